// SPDX-License-Identifier: Apache-2.0
// The programs of one robot, and of many at once on every instruction set: bit for bit those of the
// reference.
#include "lp/programs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "core/simd_target.h"
#include "lp/linear_program.h"
#include "unit/lp/judge.h"
#include "unit/lp/programs.h"

namespace avo::test {
namespace {

constexpr int kPrograms = 40000;  // of each family

// As a planner hands them over: no hard half-planes, the speed disc around 0.
Program centered(Program p) {
  const Vec2 origin = p.speed.center;
  for (const HalfPlane& plane : p.hard) p.soft.push_back(plane);
  p.hard.clear();
  for (HalfPlane& plane : p.soft) plane.offset -= dot(plane.normal, origin);
  p.acceleration.center = p.acceleration.center - origin;
  p.speed.center = {};
  p.preferred = p.preferred - origin;
  return p;
}

std::vector<Program> programs(Generator make, int count) {
  Random random(2011);
  std::vector<Program> all;
  for (int k = 0; k < count; ++k) all.push_back(centered(make(random)));
  return all;
}

void solve(const std::vector<Program>& all, ProgramBatch& batch) {
  batch.clear();
  for (const Program& p : all) {
    batch.add(p.acceleration, p.speed.radius, p.preferred, p.soft);
  }
  nearest_points(batch);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(Vec2 a, Vec2 b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y);
}

// Which cases the settled programs were, each of which has to occur.
struct Cases {
  int untouched = 0, one_plane = 0, two_planes = 0, arc = 0, corner = 0, plane_and_arc = 0;
  int least_unsafe = 0;

  void count(const Program& p, const ProgramResult& r) {
    if (r.state == ProgramState::least_unsafe) return void(++least_unsafe);
    if (r.point == p.preferred) return void(++untouched);
    const Real size = 1e-12L * (norm(p.acceleration.center) + p.acceleration.radius);
    const Point u{r.point.x, r.point.y};
    int planes = 0, arcs = 0;
    for (const HalfPlane& plane : p.soft) planes += std::abs(excess(plane, u)) < size;
    for (const Disc& disc : {p.acceleration, p.speed}) arcs += std::abs(excess(disc, u)) < size;
    if (planes == 0) ++(arcs == 1 ? arc : corner);
    if (planes == 1) ++(arcs == 0 ? one_plane : plane_and_arc);
    if (planes == 2) ++two_planes;
  }
};

class BatchOn : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(use_simd_target(GetParam())); }
  void TearDown() override { use_simd_target(simd_targets().front()); }
};
INSTANTIATE_TEST_SUITE_P(Targets, BatchOn, testing::ValuesIn(simd_targets()),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(BatchOn, equals_the_reference_bit_for_bit) {
  Cases cases;
  ProgramBatch batch;
  for (const Family& family : kFamilies) {
    const std::vector<Program> all = programs(family.make, kPrograms);
    solve(all, batch);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const ProgramResult r = run(all[k]);
      const bool ordinary = r.state != ProgramState::discs_disjoint;
      ASSERT_EQ(batch.settled(k), ordinary) << text(all[k], r);
      if (!batch.settled(k)) continue;
      cases.count(all[k], r);
      ASSERT_TRUE(same_bits(batch.point(k), r.point) && same_bits(batch.violation(k), r.violation))
          << text(all[k], r);
    }
  }
  EXPECT_GT(cases.untouched, 5000);
  EXPECT_GT(cases.one_plane, 5000);
  EXPECT_GT(cases.two_planes, 5000);
  EXPECT_GT(cases.arc, 5000);
  EXPECT_GT(cases.corner, 5000);
  EXPECT_GT(cases.plane_and_arc, 5000);
  EXPECT_GT(cases.least_unsafe, 50000);
}

void examine_all(const Family& family) {
  ProgramBatch batch;
  const std::vector<Program> all = programs(family.make, kPrograms);
  solve(all, batch);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!batch.settled(k)) continue;
    ProgramResult r;
    r.point = batch.point(k);
    r.violation = batch.violation(k);
    if (r.violation > 0.0) r.state = ProgramState::least_unsafe;
    judge(all[k], r);
    if (testing::Test::HasFailure()) FAIL() << family << ' ' << k << '\n' << text(all[k], r);
  }
}

class Judged : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, Judged, testing::ValuesIn(kFamilies), [](const auto& family) {
  std::string name = family.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST_P(Judged, P10_P11_agrees_with_all_vertices) {
  examine_all(GetParam());
}

avo::ProgramResult one_by_one(const Program& p) {
  ProgramRows scratch;
  return nearest_point(p.soft, p.acceleration, p.speed.radius, p.preferred, scratch);
}

TEST_P(Judged, one_robot_has_the_bits_of_the_reference) {
  for (const Program& p : programs(GetParam().make, kPrograms)) {
    const ProgramResult r = run(p);
    const avo::ProgramResult own = one_by_one(p);
    ASSERT_TRUE(same_bits(own.point, r.point) && same_bits(own.violation, r.violation))
        << text(p, r) << "\n"
        << own.point.x << ' ' << own.point.y << ' ' << own.violation;
    ASSERT_EQ(own.state == avo::ProgramState::optimal, r.state == ProgramState::optimal);
    ASSERT_EQ(own.state == avo::ProgramState::discs_disjoint,
              r.state == ProgramState::discs_disjoint);
  }
}

// Any finite number is an input, and the answer is a point.
TEST(OneProgram, never_yields_nan) {
  Random random(9);
  const auto usual = [&] { return any_number(random); };
  for (int k = 0; k < kPrograms; ++k) {
    Program p;
    p.acceleration = {{usual(), usual()}, std::abs(usual())};
    p.speed = {{}, std::abs(usual())};
    p.preferred = {usual(), usual()};
    for (int n = random.below(8); n > 0; --n) p.soft.push_back({random.unit(), usual()});
    const avo::ProgramResult own = one_by_one(p);
    ASSERT_TRUE(is_finite(own.point) && !std::isnan(own.violation)) << text(p, run(p));
    ASSERT_EQ(own.violation > 0.0, own.state != avo::ProgramState::optimal) << text(p, run(p));
    ASSERT_EQ(own.state == avo::ProgramState::optimal, run(p).state == ProgramState::optimal);
  }
}

TEST(Batch, leaves_alone_what_is_out_of_the_ordinary) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto settled = [](const Disc& acceleration, double top_speed, Vec2 preferred) {
    ProgramBatch batch;
    batch.add(acceleration, top_speed, preferred, {});
    nearest_points(batch);
    return batch.settled(0);
  };
  EXPECT_TRUE(settled({{1, 0}, 1}, 2, {0, 1}));
  EXPECT_FALSE(settled({{5, 0}, 1}, 2, {0, 1}));
  EXPECT_TRUE(settled({{1, 0}, kInfinity}, 2, {0, 1}));
  EXPECT_TRUE(settled({{0, 0}, 0}, 0, {0, 1}));
  EXPECT_FALSE(settled({{1, 0}, 1e300}, 2, {0, 1}));
  EXPECT_FALSE(settled({{1e-300, 0}, 1e-300}, 1e-300, {0, 0}));
  EXPECT_FALSE(settled({{kNan, 0}, 1}, 2, {0, 1}));
  EXPECT_FALSE(settled({{0, kNan}, 1}, 2, {0, 1}));
  EXPECT_FALSE(settled({{1, 0}, kNan}, 2, {0, 1}));
  EXPECT_FALSE(settled({{1, 0}, 1}, kNan, {0, 1}));
  EXPECT_FALSE(settled({{1, 0}, 1}, 2, {kNan, 1}));
  EXPECT_FALSE(settled({{1, 0}, 1}, 2, {0, kInfinity}));
}

TEST(Batch, can_be_solved_again_and_filled_again) {
  ProgramBatch batch;
  for (const int count : {100, 3, 40, 0, 17}) {
    const std::vector<Program> all = programs(planner_program, count);
    solve(all, batch);
    nearest_points(batch);
    ASSERT_EQ(batch.size(), all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      ASSERT_TRUE(batch.settled(k));
      ASSERT_EQ(batch.point(k), run(all[k]).point);
    }
  }
}

TEST_P(BatchOn, any_number_of_half_planes) {
  Random random(2);
  std::vector<Program> all;
  for (int k = 0; k < 40; ++k) {
    Program p{{}, {}, {{0.5, 0}, 2}, {{}, 2}, random.vector(0.0, 2.0)};
    for (int n = random.below(k < 20 ? 300 : 3); n > 0; --n) {
      p.soft.push_back({random.unit(), random.uniform(-2.0, k % 2 == 0 ? -0.5 : 0.5)});
    }
    all.push_back(p);
  }
  ProgramBatch batch;
  solve(all, batch);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ASSERT_TRUE(batch.settled(k));
    ASSERT_TRUE(same_bits(batch.point(k), run(all[k]).point));
  }
}

}  // namespace
}  // namespace avo::test
