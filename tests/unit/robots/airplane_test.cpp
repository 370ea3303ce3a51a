// SPDX-License-Identifier: Apache-2.0
// Airplanes: arcs against points of them, limits, and circles that are held.
#include "robots/airplane.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

constexpr double kTimeStep = 0.1;

Vec2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

Vec2 any_direction(Random& random) {
  return direction(random.uniform(-std::numbers::pi, std::numbers::pi));
}

// By the parameter form of a circle, or a straight line.
Vec2 point_of(const FlightArc& arc, double length) {
  const Vec2 left{-arc.heading.y, arc.heading.x};
  if (arc.curvature == 0.0) return arc.start + length * arc.heading;
  const double turn = arc.curvature * length;
  return arc.start + (std::sin(turn) / arc.curvature) * arc.heading +
         ((1.0 - std::cos(turn)) / arc.curvature) * left;
}

FlightArc any_arc(Random& random) {
  const double length = random.log_uniform(0.01, 10.0);
  const double turn = random.below(20) == 0 ? 0.0 : random.uniform(-3.0, 3.0);
  return {test::in_disc(random, 5.0), any_direction(random), turn / length, length};
}

TEST(Airplane, the_lowest_point_of_an_arc_is_that_of_all_its_points) {
  Random random(31);
  int inside = 0;
  for (int k = 0; k < 2'000; ++k) {
    const FlightArc arc = any_arc(random);
    const Vec2 n = any_direction(random);
    double least = 0.0;
    constexpr int kPoints = 4'000;
    for (int i = 0; i <= kPoints; ++i)
      least = std::min(least, dot(n, point_of(arc, arc.length * i / kPoints) - arc.start));
    const double end = dot(n, point_of(arc, arc.length) - arc.start);
    ASSERT_NEAR(lowest(arc, end_of(arc, chord(arc)), n), least, 1e-6 * arc.length);
    ASSERT_LE(lowest(arc, end_of(arc, chord(arc)), n), least + 1e-12 * arc.length);
    inside += least < std::min(0.0, end) - 1e-3 * arc.length ? 1 : 0;
  }
  EXPECT_GT(inside, 200);  // it is not at an end
}

TEST(Airplane, the_distance_of_an_arc_is_that_of_all_its_points) {
  Random random(32);
  for (int k = 0; k < 2'000; ++k) {
    const FlightArc arc = any_arc(random);
    const Vec2 p = test::in_disc(random, 10.0);
    double least = 1e9, off = 0.0;
    const Vec2 end = point_of(arc, arc.length), chord = (end - arc.start) / norm(end - arc.start);
    constexpr int kPoints = 4'000;
    for (int i = 0; i <= kPoints; ++i) {
      const Vec2 point = point_of(arc, arc.length * i / kPoints);
      least = std::min(least, norm(point - p));
      off = std::max(off, std::abs(cross(chord, point - arc.start)));
    }
    ASSERT_NEAR(distance(arc, p), least, 1e-3 * arc.length);
    ASSERT_LE(distance(arc, p), least + 1e-12);
    ASSERT_GE(sagitta(arc) + 1e-12, off);
  }
}

struct Flying {
  Airplane airplane;
  MotionLimits limits;
  MotionState state;
};

Flying any_flying(Random& random) {
  Flying any;
  any.airplane.min_speed = random.log_uniform(0.3, 30.0);
  any.limits = {random.log_uniform(0.1, 10.0), any.airplane.min_speed * random.uniform(1.0, 3.0)};
  any.airplane.lateral_acceleration =
      random.log_uniform(0.01, 25.0 * any.airplane.min_speed);  // less than 3 rad a step
  any.state.position = test::in_disc(random, 100.0);
  any.state.heading = random.uniform(-3.0, 3.0);
  any.state.velocity =
      random.uniform(any.airplane.min_speed, any.limits.max_speed) * direction(any.state.heading);
  any.state.circle = loiter_circle(any.airplane, any.state.position, any.state.velocity);
  return any;
}

TEST(Airplane, keeps_its_limits_whatever_it_is_told) {
  Random random(33);
  for (int k = 0; k < 20'000; ++k) {
    const auto [airplane, limits, state] = any_flying(random);
    const Plan plan{.acceleration = test::in_disc(random, 30.0)};
    const double ahead = dot(direction(state.heading), plan.acceleration);
    const FlightStep step = fly(airplane, limits, state, plan, kTimeStep);
    const double before = norm(state.velocity), after = norm(step.motion.next.velocity);
    ASSERT_GE(after, airplane.min_speed * (1.0 - 1e-12));
    ASSERT_LE(after, limits.max_speed * (1.0 + 1e-12));
    ASSERT_LE(std::abs(after - before), (std::abs(ahead) + 1e-9) * kTimeStep);
    const double top = std::max(before, after);
    ASSERT_LE(top * top * std::abs(step.arc.curvature), airplane.lateral_acceleration);
    ASSERT_NEAR(norm(step.motion.next.position - point_of(step.arc, step.arc.length)), 0.0, 1e-10);
  }
}

TEST(Airplane, its_circle_is_to_the_right_and_holds_all_of_its_disc) {
  Random random(34);
  for (int k = 0; k < 2'000; ++k) {
    const auto [airplane, limits, start] = any_flying(random);
    MotionState state = start;
    const Vec2 to_center = start.circle.center - start.position;
    ASSERT_LT(cross(start.velocity, to_center), 0.0);
    for (int i = 0; i < 50; ++i) {
      const Plan plan{.acceleration = loitering(airplane, state)};
      const FlightStep step = fly(airplane, limits, state, plan, kTimeStep);
      for (int part = 0; part <= 8; ++part) {
        const Vec2 p = point_of(step.arc, step.arc.length * part / 8);
        ASSERT_NEAR(norm(p - start.circle.center), start.circle.radius,
                    1e-12 * (start.circle.radius + 100.0));
      }
      ASSERT_LT(cross(state.velocity, step.motion.next.velocity), 0.0);  // to the right
      state = step.motion.next;
    }
  }
}

TEST(Airplane, a_circle_is_the_same_after_100_000_steps) {
  Random random(35);
  for (int k = 0; k < 3; ++k) {
    const auto [airplane, limits, start] = any_flying(random);
    MotionState state = start;
    for (int i = 0; i < 100'000; ++i) {
      const Plan plan{.acceleration = loitering(airplane, state)};
      state = fly(airplane, limits, state, plan, kTimeStep).motion.next;
    }
    EXPECT_EQ(state.circle, start.circle);
    const double size = start.circle.radius + norm(start.circle.center);
    EXPECT_NEAR(norm(state.position - start.circle.center), start.circle.radius, 1e-15 * size);
    EXPECT_NEAR(norm(state.velocity) / norm(start.velocity), 1.0, 1e-15);
    // and what others would make of it is still that circle
    const LoiterCircle seen = loiter_circle(airplane, state.position, state.velocity);
    EXPECT_NEAR(norm(seen.center - start.circle.center), 0.0, 4e-15 * size);
  }
}

TEST(Airplane, slowing_down_in_a_right_turn_stays_within_the_circle) {
  Random random(36);
  for (int k = 0; k < 5'000; ++k) {
    const auto [airplane, limits, state] = any_flying(random);
    const Vec2 right{std::sin(state.heading), -std::cos(state.heading)};
    const Plan plan{.acceleration = usable_acceleration(airplane) * right -
                                    random.uniform(0.0, 3.0) * direction(state.heading)};
    const LoiterCircle next = fly(airplane, limits, state, plan, kTimeStep).motion.next.circle;
    ASSERT_LE(norm(next.center - state.circle.center) + next.radius,
              state.circle.radius * (1.0 + 1e-9) + 1e-9);
  }
}

}  // namespace
}  // namespace avo
