// SPDX-License-Identifier: Apache-2.0
// Distance over one step against dense sampling.
#include "metrics/separation.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "support/brute_force.h"
#include "support/segment_distance.h"

namespace avo {
namespace {

using test::Random;

Vec2 point(const StepPath& path, double u) {
  const double q = 1.0 - u;
  const auto& b = path.control;
  return (q * q * q) * b[0] + (3 * q * q * u) * b[1] + (3 * q * u * u) * b[2] + (u * u * u) * b[3];
}

// By samples, then by golden section around each of their minima.
judge::Instant sampled(const StepPath& a, const StepPath& b) {
  constexpr int kSamples = 400;
  const auto nearness = [&](double u) { return -norm(point(a, u) - point(b, u)); };
  judge::Instant best{0.0, std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    if (-nearness(u) < best.distance) best = {u, -nearness(u)};
  }
  for (int k = 0; k <= kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    const double low = std::max(0.0, u - 1.0 / kSamples), high = std::min(1.0, u + 1.0 / kSamples);
    if (nearness(u) < nearness(low) || nearness(u) < nearness(high)) continue;
    best.distance = std::min(best.distance, -test::golden_section(nearness, low, high, 50));
  }
  return best;
}

StepPath random_path(Random& random, double size) {
  StepPath path;
  for (Vec2& each : path.control) each = test::in_disc(random, size);
  return path;
}

TEST(Separation, agrees_with_dense_sampling) {
  Random random(1);
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double size = random.log_uniform(1e-6, 1e6);
    const StepPath a = random_path(random, size), b = random_path(random, size);
    const judge::Instant found = separation(a, b, std::numeric_limits<double>::infinity());
    const judge::Instant expected = sampled(a, b);
    EXPECT_NEAR(found.distance, expected.distance, 1e-7 * size);
    const double there = norm(point(a, found.fraction) - point(b, found.fraction));
    EXPECT_NEAR(there, found.distance, 1e-12 * size);
  }
}

// Fast passes that both ends of the step miss.
TEST(Separation, sees_what_happens_between_the_ends) {
  const StepPath still = hermite_path({0, 0}, {0, 0}, {0, 0}, {0, 0}, 0.1);
  for (const double miss : {0.0, 1e-9, 0.3, 0.9}) {
    const StepPath fast = hermite_path({-10, miss}, {200, 0}, {10, miss}, {200, 0}, 0.1);
    const judge::Instant found = separation(still, fast, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(found.distance, miss, 1e-11);
    EXPECT_NEAR(found.fraction, 0.5, 1e-4);
    EXPECT_NEAR(first_below(still, fast, 1.0).value(), 0.5 - std::sqrt(1.0 - miss * miss) / 20.0,
                1e-12);
  }
}

TEST(Separation, a_cutoff_never_hides_what_is_nearer) {
  Random random(2);
  int near = 0;
  for (int k = 0; k < 20'000 && !HasFailure(); ++k) {
    const StepPath a = random_path(random, 1.0), b = random_path(random, 1.0);
    const double exact = separation(a, b, std::numeric_limits<double>::infinity()).distance;
    const double cutoff = random.uniform(0.0, 1.0);
    const double found = separation(a, b, cutoff).distance;
    EXPECT_GE(found, exact - 1e-12);
    if (exact < cutoff - 1e-12) {
      EXPECT_NEAR(found, exact, 1e-9);
      ++near;
    } else {
      EXPECT_GE(found, cutoff - 1e-9);
    }
  }
  EXPECT_GT(near, 2'000);
}

TEST(Separation, a_cubic_is_exact_for_a_held_acceleration) {
  const Vec2 p{1, 2}, v{0.3, -0.4}, a{0.7, 0.9};
  const double dt = 0.25;
  const Vec2 end = p + dt * v + (0.5 * dt * dt) * a;
  const StepPath path = hermite_path(p, v, end, v + dt * a, dt);
  for (const double u : {0.0, 0.2, 0.5, 0.77, 1.0}) {
    const double t = u * dt;
    EXPECT_NEAR(norm(point(path, u) - (p + t * v + (0.5 * t * t) * a)), 0.0, 1e-15);
  }
}

TEST(Separation, first_below_is_the_first) {
  const StepPath still = hermite_path({0, 0}, {0, 0}, {0, 0}, {0, 0}, 1.0);
  const StepPath path = hermite_path({3, 0}, {-2, 0}, {1, 0}, {-2, 0}, 1.0);
  EXPECT_NEAR(first_below(still, path, 2.0).value(), 0.5, 1e-15);
  EXPECT_EQ(first_below(still, path, 4.0), 0.0);
  EXPECT_EQ(first_below(still, path, 1.0), std::nullopt);
}

// Nearest to the segment, by samples, then by golden section around each of their minima.
template <typename PointAt>
double sampled_from(const PointAt& at, const Segment& segment) {
  constexpr int kSamples = 400;
  const auto nearness = [&](double u) {
    return -test::slow_segment_distance(at(u), segment.a, segment.b);
  };
  double best = -std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    const double low = std::max(0.0, u - 1.0 / kSamples), high = std::min(1.0, u + 1.0 / kSamples);
    best = std::max(best, nearness(u));
    if (nearness(u) < nearness(low) || nearness(u) < nearness(high)) continue;
    best = std::max(best, test::golden_section(nearness, low, high, 50));
  }
  return -best;
}

constexpr double kNoCutoff = std::numeric_limits<double>::infinity();

TEST(Separation, from_a_segment_agrees_with_dense_sampling) {
  Random random(5);
  int crossed = 0;
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double size = random.log_uniform(1e-6, 1e6);
    const StepPath path = random_path(random, size);
    const Vec2 a = test::in_disc(random, size);
    const double length = random.below(8) == 0 ? 0.0 : size * random.log_uniform(1e-3, 10.0);
    const Segment segment{a, a + length * random.direction()};
    const double nearest = separation(path, segment, kNoCutoff);
    const double expected = sampled_from([&](double u) { return point(path, u); }, segment);
    EXPECT_NEAR(nearest, expected, 1e-7 * size);
    EXPECT_LE(nearest, expected + 1e-11 * size);
    if (nearest < 1e-10 * size) ++crossed;
  }
  EXPECT_GT(crossed, 100);
}

// Robots brake and speed up along walls: the path bends in the direction that does not matter.
TEST(Separation, along_a_segment_the_distance_is_that_to_its_line) {
  Random random(6);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const Vec2 along = random.direction(), across = perpendicular(along);
    const double off = random.uniform(0.1, 2.0), bend = random.near_zero();
    StepPath path;
    for (Vec2& each : path.control)
      each = random.uniform(-1.0, 1.0) * along + (off + bend) * across;
    EXPECT_NEAR(separation(path, Segment{-3.0 * along, 3.0 * along}, kNoCutoff), off + bend, 1e-12);
  }
}

TEST(Separation, from_a_segment_by_the_response) {
  Random random(7);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const double delta = random.log_uniform(0.05, 5.0), step = random.log_uniform(0.01, 1.0);
    const ResponsePath path{test::in_disc(random, 2.0), test::in_disc(random, 3.0),
                            test::in_disc(random, 3.0), Response::proportional(delta), step};
    const Vec2 a = test::in_disc(random, 2.0);
    const Segment segment{a, a + random.log_uniform(0.01, 10.0) * random.direction()};
    const auto at = [&](double u) {
      const double t = u * step, g = static_cast<double>(test::slow_gain(t, delta));
      return path.position + t * path.velocity + g * path.w;
    };
    EXPECT_NEAR(separation(path, segment), sampled_from(at, segment), 1e-7);
  }
}

TEST(Separation, from_a_segment_of_a_cars_arc) {
  Random random(9);
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double size = random.log_uniform(1e-3, 1e3), heading = random.uniform(-3.0, 3.0);
    const double turn = random.below(4) == 0 ? random.uniform(-1e-9, 1e-9) : random.uniform(-2, 2);
    const Vec2 start = test::in_disc(random, size);
    const auto at = [&](double part) {
      const double half = 0.5 * part * turn;
      const double chord = part * size * (half == 0.0 ? 1.0 : std::sin(half) / half);
      return start + chord * Vec2{std::cos(heading + half), std::sin(heading + half)};
    };
    const ArcPath path = arc_path(start, at(1.0), turn);
    EXPECT_NEAR(path.length, size, 1e-12 * size);
    const Vec2 a = test::in_disc(random, size);
    const Segment segment{a, a + random.uniform(0.0, 2.0) * size * random.direction()};
    EXPECT_NEAR(separation(path, segment, kNoCutoff), sampled_from(at, segment), 1e-9 * size);
  }
}

// Parts of a motion on an arc are where it is, and so are their cubics, the better the smaller they
// are.
TEST(Separation, parts_of_an_arc_are_where_it_is_at_their_times) {
  Random random(12);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const double step = random.log_uniform(0.02, 0.5);
    const double speed = random.uniform(0.0, 2.0), next_speed = random.uniform(0.01, 2.0);
    const double length = 0.5 * (speed + next_speed) * step, turn = random.uniform(-2.0, 2.0);
    const double heading = random.uniform(-3.0, 3.0);
    const ArcMotion arc{{{1, 2}, heading, turn, length}, speed, next_speed};
    const auto at = [&](double u) {
      const double covered = u * step * (speed + 0.5 * u * (next_speed - speed));
      const double half = 0.5 * turn * covered / length;
      const double chord = covered * (half == 0.0 ? 1.0 : std::sin(half) / half);
      return Vec2{1, 2} + chord * Vec2{std::cos(heading + half), std::sin(heading + half)};
    };
    const double from = random.uniform(0.0, 0.9), to = from + random.uniform(0.01, 0.1);
    const StepPath cubic = hermite_path(part_of(arc, from, to), (to - from) * step);
    const auto between = [&](double u) {
      const double q = 1.0 - u;
      const auto& b = cubic.control;
      return (q * q * q) * b[0] + (3.0 * q * q * u) * b[1] + (3.0 * q * u * u) * b[2] +
             (u * u * u) * b[3];
    };
    for (const double u : {0.0, 0.3, 0.5, 0.8, 1.0})
      EXPECT_LT(norm(between(u) - at(from + u * (to - from))), 1e-4 * length) << k;
    const StepPath whole = random_path(random, 1.0), part = part_of(whole, from, to);
    const StepPath again = part_of(part, 0.25, 0.75);
    const StepPath middle = part_of(whole, from + 0.25 * (to - from), from + 0.75 * (to - from));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LT(norm(again.control[i] - middle.control[i]), 1e-12) << k;
  }
}

TEST(Separation, from_a_segment_of_a_car_that_turns_in_place) {
  const ArcPath path = arc_path({1, 2}, {1, 2}, 3.0);
  EXPECT_EQ(separation(path, {{-5, 0}, {5, 0}}, kNoCutoff), 2.0);
}

TEST(Separation, from_a_segment_beyond_the_cutoff_is_above_it) {
  Random random(8);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const StepPath path = random_path(random, 1.0);
    const Segment segment{test::in_disc(random, 3.0), test::in_disc(random, 3.0)};
    const double cutoff = random.uniform(0.0, 2.0);
    const double exact = separation(path, segment, kNoCutoff);
    const double coarse = separation(path, segment, cutoff);
    EXPECT_GE(coarse, exact - 1e-12);
    if (exact < cutoff) {
      EXPECT_NEAR(coarse, exact, 1e-12);
    }
  }
}

}  // namespace
}  // namespace avo
