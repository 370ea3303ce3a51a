// SPDX-License-Identifier: Apache-2.0
// These are named cases of the program of Eqs. (22), (23): each degenerate case, and each kind of
// failure.
#include "lp/linear_program.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "support/program/linear_program.h"

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kHalfRoot3 = std::sqrt(3.0) / 2.0;
using Planes = std::vector<HalfPlane>;
using reference::ProgramResult;
using reference::ProgramState;

ProgramResult solve(const Planes& hard, const Planes& soft, Disc acceleration, Disc speed,
                    Vec2 preferred) {
  std::vector<HalfPlane> scratch;
  const ProgramResult r =
      reference::nearest_point(hard, soft, acceleration, speed, preferred, scratch);
  if (hard.empty() && speed.center == Vec2{}) {
    ProgramRows rows;
    const avo::ProgramResult own = nearest_point(soft, acceleration, speed.radius, preferred, rows);
    const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
    EXPECT_EQ(bits(own.point.x), bits(r.point.x));
    EXPECT_EQ(bits(own.point.y), bits(r.point.y));
    EXPECT_EQ(bits(own.violation), bits(r.violation));
    EXPECT_EQ(own.state == avo::ProgramState::optimal, r.state == ProgramState::optimal);
    EXPECT_EQ(own.state == avo::ProgramState::discs_disjoint,
              r.state == ProgramState::discs_disjoint);
  }
  return r;
}

// The paper's limits: a robot at rest, δ a_max = 4, v_max = 2.
ProgramResult solve(const Planes& hard, const Planes& soft, Vec2 preferred) {
  return solve(hard, soft, {{0, 0}, 4}, {{0, 0}, 2}, preferred);
}

void expect_point(const ProgramResult& r, Vec2 expected, double tolerance = 1e-15) {
  EXPECT_NEAR(r.point.x, expected.x, tolerance);
  EXPECT_NEAR(r.point.y, expected.y, tolerance);
}

void expect_optimal(const ProgramResult& r, Vec2 expected) {
  EXPECT_EQ(r.state, ProgramState::optimal);
  EXPECT_EQ(r.violation, 0.0);
  expect_point(r, expected);
}

TEST(LinearProgram, no_half_planes_keep_the_preferred_velocity) {
  const Vec2 preferred{1.1, -0.3};
  const ProgramResult r = solve({}, {}, preferred);
  EXPECT_EQ(r.point, preferred);
  // bit for bit also where the discs lie elsewhere
  EXPECT_EQ(solve({}, {}, {{0.3, 0.7}, 2.0}, {{0, 0}, 4}, preferred).point, preferred);
}

TEST(LinearProgram, too_fast_a_preference_is_cut_to_the_speed_disc) {
  const ProgramResult r = solve({}, {}, {6, 8});
  expect_optimal(r, {1.2, 1.6});
}

TEST(LinearProgram, infinite_acceleration_leaves_the_speed_disc_alone) {
  expect_optimal(solve({}, {}, {{5, 5}, kInfinity}, {{0, 0}, 2}, {0, 9}), {0, 2});
  expect_optimal(solve({}, {{{1, 0}, 1}}, {{5, 5}, kInfinity}, {{0, 0}, 2}, {0, 9}),
                 {1, std::sqrt(3.0)});
}

TEST(LinearProgram, the_speed_limit_is_a_disc_and_not_two_lines) {
  // on the half-plane's boundary the disc ends at |u| = 2, a box would end at y = 2
  const ProgramResult r = solve({}, {{{1, 0}, 1.2}}, {0, 3});
  expect_optimal(r, {1.2, 1.6});
}

TEST(LinearProgram, the_acceleration_limit_is_a_disc_too) {
  const ProgramResult r = solve({}, {{{1, 0}, 1.2}}, {{0, 0}, 2}, {{0, 0}, 4}, {0, 3});
  expect_optimal(r, {1.2, 1.6});
}

TEST(LinearProgram, both_circles_may_bind_at_their_corner) {
  // circles of radius 1 around 0 and (1, 0) cross at (1/2, ±√3/2)
  const ProgramResult r = solve({}, {}, {{0, 0}, 1}, {{1, 0}, 1}, {0.5, 5});
  expect_optimal(r, {0.5, kHalfRoot3});
}

TEST(LinearProgram, a_line_is_clipped_by_both_circles) {
  const Disc left{{0, 0}, 1}, right{{1, 0}, 1};
  const Planes up{{{0, 1}, 0.6}};
  expect_optimal(solve({}, up, left, right, {-5, 0}), {0.2, 0.6});
  expect_optimal(solve({}, up, left, right, {5, 0}), {0.8, 0.6});
  expect_optimal(solve({}, up, right, left, {5, 0}), {0.8, 0.6});
}

TEST(LinearProgram, preference_is_projected_on_one_half_plane) {
  const ProgramResult r = solve({}, {{{0.6, 0.8}, 1}}, {0, 0});
  expect_optimal(r, {0.6, 0.8});
}

TEST(LinearProgram, two_half_planes_meet_in_a_corner) {
  const ProgramResult r = solve({}, {{{1, 0}, 0.5}, {{0, 1}, 0.25}}, {-1, -1});
  expect_optimal(r, {0.5, 0.25});
}

TEST(LinearProgram, satisfied_and_duplicate_half_planes_change_nothing) {
  const HalfPlane line{{0.6, 0.8}, 1};
  const ProgramResult once = solve({}, {line}, {0, 0});
  const ProgramResult more = solve({line}, {line, {{0.6, 0.8}, 0.5}, line, {{1, 0}, -3}}, {0, 0});
  EXPECT_EQ(more.point, once.point);
  EXPECT_EQ(more.state, ProgramState::optimal);
}

TEST(LinearProgram, the_stricter_of_two_parallel_half_planes_counts) {
  expect_optimal(solve({}, {{{1, 0}, 0.5}, {{1, 0}, 1}}, {0, 0}), {1, 0});
  expect_optimal(solve({}, {{{1, 0}, 1}, {{1, 0}, 0.5}}, {0, 0}), {1, 0});
}

TEST(LinearProgram, opposite_half_planes_that_touch_leave_their_line) {
  expect_optimal(solve({}, {{{1, 0}, 0.3}, {{-1, 0}, -0.3}}, {-1, 0.7}), {0.3, 0.7});
}

TEST(LinearProgram, concurrent_half_planes_leave_their_point) {
  // three lines through (0.1, 0.7), which no double holds, at 120 degrees
  Planes soft;
  for (Vec2 n : {Vec2{1, 0}, Vec2{-0.5, kHalfRoot3}, Vec2{-0.5, -kHalfRoot3}}) {
    soft.push_back({n, dot(n, {0.1, 0.7})});
  }
  expect_optimal(solve({}, soft, {-1, -1}), {0.1, 0.7});
  expect_optimal(solve(soft, {}, {-1, -1}), {0.1, 0.7});
}

TEST(LinearProgram, a_half_plane_that_touches_the_disc_leaves_one_point) {
  expect_optimal(solve({}, {{{0.6, 0.8}, 2}}, {-1, 0}), {1.2, 1.6});
  expect_optimal(solve({{{0.6, 0.8}, 2}}, {{{1, 0}, 0.5}}, {-1, 0}), {1.2, 1.6});
}

TEST(LinearProgram, discs_that_touch_leave_one_point) {
  expect_optimal(solve({}, {{{0, 1}, -1}}, {{0, 0}, 1}, {{3, 0}, 2}, {0, 9}), {1, 0});
  expect_optimal(solve({}, {}, {{0.1, 0}, 0.2}, {{0.4, 0}, 0.1}, {0, 9}), {0.3, 0});
}

TEST(LinearProgram, equal_discs_are_one) {
  expect_optimal(solve({}, {{{0, 1}, 1}}, {{0, 0}, 2}, {{0, 0}, 2}, {9, 0}), {std::sqrt(3.0), 1});
}

TEST(LinearProgram, a_disc_touching_from_inside_plays_alone) {
  expect_optimal(solve({}, {}, {{1, 0}, 1}, {{0, 0}, 2}, {9, 0}), {2, 0});
  expect_optimal(solve({}, {}, {{1, 0}, 1}, {{0, 0}, 2}, {-9, 0}), {0, 0});
}

TEST(LinearProgram, a_disc_of_radius_0_leaves_its_center) {
  const Disc point{{0.3, 0.4}, 0}, speed{{0, 0}, 2};
  expect_optimal(solve({}, {{{1, 0}, 0.3}}, point, speed, {1, 1}), {0.3, 0.4});
  const ProgramResult r = solve({}, {{{1, 0}, 0.5}}, point, speed, {1, 1});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  expect_point(r, {0.3, 0.4});
  EXPECT_NEAR(r.violation, 0.2, 1e-15);
}

TEST(LinearProgram, discs_that_do_not_meet_brake_towards_the_speed_limit) {
  const ProgramResult r = solve({{{1, 0}, 9}}, {}, {{3, 4}, 1}, {{0, 0}, 2}, {9, 9});
  EXPECT_EQ(r.state, ProgramState::discs_disjoint);
  expect_point(r, {2.4, 3.2}, 1e-14);
  EXPECT_NEAR(r.violation, 2, 1e-14);
  expect_point(solve({}, {}, {{3, 4}, 2}, {{0, 0}, 1}, {9, 9}), {1.8, 2.4}, 1e-14);
}

TEST(LinearProgram, half_planes_too_far_away_give_the_least_unsafe_point) {
  const ProgramResult r = solve({}, {{{0.6, 0.8}, 3}}, {-1, 0});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  expect_point(r, {1.2, 1.6});
  EXPECT_NEAR(r.violation, 1, 1e-15);
}

TEST(LinearProgram, opposite_half_planes_share_the_violation) {
  // of the whole segment x = 0.35 the point nearest the preferred one
  const ProgramResult r = solve({}, {{{1, 0}, 0.5}, {{-1, 0}, -0.2}}, {0, 1});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  expect_point(r, {0.35, 1});
  EXPECT_NEAR(r.violation, 0.15, 1e-15);
}

TEST(LinearProgram, three_half_planes_share_the_violation) {
  const Planes soft{{{1, 0}, 0.5}, {{-0.5, kHalfRoot3}, 1}, {{-0.5, -kHalfRoot3}, 1}};
  const ProgramResult r = solve({}, soft, {0, 1});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  expect_point(r, {-1.0 / 3.0, 0});
  EXPECT_NEAR(r.violation, 5.0 / 6.0, 1e-15);
}

TEST(LinearProgram, hard_half_planes_are_kept_at_the_cost_of_soft_ones) {
  const ProgramResult r = solve({{{1, 0}, 0.5}}, {{{-1, 0}, -0.2}, {{0, 1}, 1}}, {0, 0});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  EXPECT_NEAR(r.violation, 0.3, 1e-15);
  expect_point(r, {0.5, 0.7});  // the second soft plane may yield as much as the first
}

TEST(LinearProgram, hard_half_planes_that_leave_nothing_share_the_violation) {
  const ProgramResult r = solve({{{1, 0}, 0.5}, {{-1, 0}, 0.1}}, {{{0, 1}, 1}}, {0, 0.25});
  EXPECT_EQ(r.state, ProgramState::hard_infeasible);
  EXPECT_NEAR(r.violation, 0.3, 1e-15);
  expect_point(r, {0.2, 0.25});  // soft half-planes do not count
}

// The fallback must be right wherever in the order the program fails, not only at the first plane.
TEST(LinearProgram, fails_at_every_index) {
  const Planes others{{{0, 1}, -0.5},   {{0, -1}, -0.6},     {{-1, 0}, -1.5},
                      {{0.6, 0.8}, -1}, {{-0.6, 0.8}, -1.2}, {{0.8, -0.6}, -1.1}};
  // these two half-planes leave |x| <= -0.4; no other half-plane matters at (0, 0.1)
  for (std::size_t first = 0; first <= others.size(); ++first) {
    for (std::size_t second = first; second <= others.size(); ++second) {
      Planes soft = others;
      soft.insert(soft.begin() + static_cast<std::ptrdiff_t>(second), {{1, 0}, 0.4});
      soft.insert(soft.begin() + static_cast<std::ptrdiff_t>(first), {{-1, 0}, 0.4});
      const ProgramResult r = solve({}, soft, {0.2, 0.1});
      EXPECT_EQ(r.state, ProgramState::least_unsafe);
      EXPECT_NEAR(r.violation, 0.4, 1e-15);
      expect_point(r, {0, 0.1});
    }
  }
}

TEST(LinearProgram, huge_offsets_are_ordinary) {
  expect_optimal(solve({}, {{{1, 0}, -1e308}, {{0, 1}, 1}}, {0, 0}), {0, 1});
  const ProgramResult r = solve({}, {{{0.6, 0.8}, 1e308}, {{1, 0}, -1e308}}, {0, 0});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  expect_point(r, {1.2, 1.6});
  EXPECT_EQ(r.violation, 1e308);
  expect_point(solve({}, {}, {3e300, 4e300}), {1.2, 1.6});
}

TEST(LinearProgram, the_size_of_the_numbers_does_not_matter) {
  for (double s = 1e-6; s < 2e7; s *= 10.0) {
    const Planes soft{{{1, 0}, 0.5 * s}, {{-1, 0}, -0.2 * s}};
    const ProgramResult unsafe = solve({}, soft, {{0, 0}, 4 * s}, {{0, 0}, 2 * s}, {0, s});
    EXPECT_EQ(unsafe.state, ProgramState::least_unsafe) << s;
    EXPECT_NEAR(unsafe.violation / s, 0.15, 1e-15);
    expect_point({unsafe.point / s}, {0.35, 1});
    const ProgramResult corner =
        solve({}, {{{1, 0}, 1.2 * s}}, {{0, 0}, 4 * s}, {{0, 0}, 2 * s}, {0, 3 * s});
    EXPECT_EQ(corner.state, ProgramState::optimal) << s;
    expect_point({corner.point / s}, {1.2, 1.6});
  }
}

TEST(LinearProgram, a_disc_far_from_the_origin_keeps_its_digits) {
  // offset * normal would lose 1e7 / 1e-2 digits of the place on the line; ulp(1e7) is 2e-9
  const Disc disc{{1e7, -1e7}, 0.01};
  const ProgramResult r = solve({}, {{{0, 1}, -1e7 + 0.006}}, disc, {{1e7, -1e7}, 1}, {2e7, -1e7});
  EXPECT_EQ(r.state, ProgramState::optimal);
  EXPECT_NEAR(r.point.x - disc.center.x, 0.008, 4e-9);
  EXPECT_NEAR(r.point.y - disc.center.y, 0.01 * 0.6, 4e-9);
}

// A corner of a line and both discs, all within rounding of each other: 1.05 times the bound
// before the point was taken back into the disc.
TEST(LinearProgram, rounding_does_not_leave_the_disc) {
  constexpr double kHalf = 0.70710678118654757;
  const Disc speed{{0.75, -0.25}, 1.25};
  const ProgramResult r =
      solve({{{-0.8, 0.6}, -0.39999999999999997}}, {{{kHalf, -kHalf}, 0.53033008588991071}},
            {{1, -1}, 1.75}, speed, {-1.5, -1.5});
  EXPECT_EQ(r.state, ProgramState::optimal);
  EXPECT_LE(norm(r.point - speed.center), 1.25 * (1 + 0x1p-51));
}

// A hard half-plane that misses the disc by rounding leaves one point, and the soft ones count
// still. They were once forgotten, with a violation of 2.55 called optimal.
TEST(LinearProgram, a_hard_half_plane_that_nearly_misses_the_disc) {
  const ProgramResult r =
      solve({{{1, 0}, 1.2499999999999938}},
            {{{-0.79999999999999982, 0.60000000000000031}, 0.70000000000000628}},
            {{0.49999999999999561, 0.49999999999999206}, 0.74999999999999656}, {{0.5, 0.5}, 2},
            {-2.75, -1.5});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  EXPECT_NEAR(r.violation, 1.4, 1e-7);  // a touching line amplifies rounding to its root
}

// Two hard half-planes that miss each other by rounding leave a segment to choose from.
TEST(LinearProgram, hard_half_planes_that_nearly_miss_each_other) {
  const ProgramResult r = solve({{{8.7973085321773399e-16, 1}, 0.75000000000000211},
                                 {{-1.2459643631976329e-15, -1}, -0.74999999999999556}},
                                {{{1, 0}, 0.25}}, {{1, 0.249999999999995}, 1.25},
                                {{-0.50000000000000533, -0.5}, 1.4999999999999967}, {-2.5, 0.25});
  expect_point(r, {0.25, 0.75}, 1e-14);
  EXPECT_EQ(r.state, ProgramState::optimal);
}

TEST(LinearProgram, offsets_may_overflow_where_the_discs_are_scaled_up) {
  const ProgramResult r = solve({}, {{{1, 0}, 1.7e308}, {{-1, 0}, 1.7e308}, {{0, 1}, 1.7e308}},
                                {{0, 0}, 4e-310}, {{0, 0}, 2e-310}, {1e-310, 1e-310});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  EXPECT_EQ(r.violation, 1.7e308);
  EXPECT_LE(std::abs(r.point.x), 2e-310);
  EXPECT_LE(std::abs(r.point.y), 2e-310);
}

// Lines that coincide but for rounding: exact clipping left nothing of a line that the least
// unsafe point lies on, and the violation came out as 0.178.
TEST(LinearProgram, nearly_coincident_lines_are_clipped_with_a_tolerance) {
  const Planes hard{{{-0.70710678118654802, 0.70710678118654702}, -0.17677669529663625},
                    {{-0.79999999999999971, 0.60000000000000031}, -0.35000000000000009}};
  const Planes soft{{{0.70710678118654757, -0.70710678118654757}, 0.17677669529663809},
                    {{1.6740133119564523e-15, -1}, -0.74999999999999845},
                    {{-0.60000000000000009, -0.79999999999999993}, -1.2},
                    {{-0.5999999999999992, -0.8000000000000006}, -0.49999999999999911},
                    {{0.79999999999999982, -0.60000000000000042}, 0.35000000000000009},
                    {{-0.79999999999999905, 0.60000000000000131}, -0.35000000000000009}};
  const ProgramResult r =
      solve(hard, soft, {{0.49999999999999889, -0.49999999999999961}, 2},
            {{0.750000000000001, 0.25}, 0.75000000000000056}, {-1, -0.50000000000000167});
  EXPECT_EQ(r.state, ProgramState::least_unsafe);
  EXPECT_NEAR(r.violation, 0.0875, 1e-14);
}

TEST(LinearProgram, scratch_is_reused) {
  ProgramRows scratch;
  const Planes planes{{{1, 0}, 0.5}, {{-1, 0}, -0.2}, {{0, 1}, 0.1}};
  const auto once = nearest_point(planes, {{0, 0}, 4}, 2, {0, 1}, scratch);
  const ProgramRow<1>* memory = scratch.data();
  const auto again = nearest_point(planes, {{0, 0}, 4}, 2, {0, 1}, scratch);
  EXPECT_EQ(scratch.data(), memory);
  EXPECT_EQ(once.point, again.point);
}

}  // namespace
}  // namespace avo
