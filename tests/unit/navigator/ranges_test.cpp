// SPDX-License-Identifier: Apache-2.0
// How far a robot on board has to see: by the formulas of docs/on_board.md, and by what changes.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/navigator.h"
#include "support/generators.h"

namespace avo {
namespace {

// v²/2b in steps of u = b Δt: whole steps, and a last one that takes off the rest.
double braking_distance(double speed, double braking, double step) {
  double way = 0.0;
  for (double v = speed; v > 0.0; v -= braking * step) {
    const double next = std::max(v - braking * step, 0.0);
    way += 0.5 * step * (v + next);
  }
  return way;
}

TEST(WallRange, is_the_radius_and_a_step_and_what_braking_needs) {
  const PlannerOptions options;
  Robot robot;
  const double needed = 0.5 + 2.0 * 0.1 + braking_distance(2.0, 1.0, 0.1);
  EXPECT_NEAR(wall_range(options, robot), needed, 1e-6);
  robot.max_braking = 0.5;
  EXPECT_NEAR(wall_range(options, robot), 0.7 + braking_distance(2.0, 0.5, 0.1), 1e-6);
  PlannerOptions lost;
  lost.localization_error = 0.2;
  EXPECT_GE(wall_range(lost, Robot{}), needed + 0.2);
}

// Walls beyond change no bit; some walls a little nearer do.
TEST(WallRange, has_no_wall_beyond_that_matters) {
  test::Random random(5);
  const Planner planner(PlannerOptions{});
  int nearer = 0;
  for (int k = 0; k < 400; ++k) {
    Robot robot;
    const Vec2 direction = random.direction();
    robot.velocity = random.uniform(0.0, 2.0) * direction;
    robot.preferred_velocity = 2.0 * direction;
    const double range = wall_range(planner.options(), robot);
    const auto next = [&](double away) {
      const Vec2 middle = away * direction, side = 3.0 * perpendicular(direction);
      const std::vector<Wall> walls{{middle - side, middle + side, 0.0}};
      PlanWorkspace workspace;
      return planner.plan(robot, {}, workspace, nullptr, walls).next_velocity;
    };
    PlanWorkspace workspace;
    const Vec2 without = planner.plan(robot, {}, workspace).next_velocity;
    EXPECT_EQ(next(range * random.uniform(1.0, 1.5)), without);
    if (!(next(0.9 * range) == without)) ++nearer;
  }
  EXPECT_GT(nearer, 20);
}

TEST(SensingRange, covers_both_robots_and_declared_errors) {
  PlannerOptions options;
  const Robot robot;
  const std::vector<Robot> others(1);
  const double part = 0.5 + 2.0 * 0.1 + braking_distance(2.0, 1.0, 0.1);
  const double exact = sensing_range(options, robot, others);
  EXPECT_GE(exact, 2.0 * part);
  EXPECT_NEAR(exact, 9.0, 0.5) << "docs/scenes.md";
  EXPECT_NEAR(sensing_range(options, robot, others, true), 15.0, 0.5) << "docs/scenes.md";
  options.sensing_error = {0.1, 0.2};
  EXPECT_NEAR(sensing_range(options, robot, others), exact + 0.1 + 0.2 * 2.2, 0.03);
  options.sensing_error = {};
  options.clock = Clock::free;
  EXPECT_GT(sensing_range(options, robot, others), exact + 0.1);
  EXPECT_EQ(sensing_range(options, robot, {}), 0.0);
}

// A neighbor beyond the range changes nothing that the certificate admits.
TEST(SensingRange, has_no_neighbor_beyond_that_the_certificate_heeds) {
  test::Random random(9);
  int admitted_less = 0;
  for (int k = 0; k < 300; ++k) {
    PlannerOptions options;
    if (k % 3 == 1) options.sensing_error = {random.uniform(0.0, 0.2), random.uniform(0.0, 0.3)};
    if (k % 3 == 2) options.clock = Clock::free, options.longest_step = random.uniform(0.05, 0.2);
    const Planner planner(options);
    Robot robot, other;
    robot.radius = random.uniform(0.2, 0.6), other.radius = random.uniform(0.2, 0.6);
    robot.max_acceleration = random.uniform(0.5, 3.0);
    other.max_acceleration = random.uniform(0.5, 3.0);
    robot.max_speed = random.uniform(0.5, 3.0), other.max_speed = random.uniform(0.5, 3.0);
    const Vec2 direction = random.direction();
    robot.velocity = robot.max_speed * direction;
    const double range = sensing_range(options, robot, {&other, 1});
    const auto admits_all = [&](double away) {
      const std::vector<Neighbor> seen{{.position = away * direction,
                                        .velocity = -other.max_speed * direction,
                                        .radius = other.radius,
                                        .max_acceleration = other.max_acceleration}};
      PlanWorkspace workspace;
      std::vector<Vec2> velocities{robot.velocity};
      std::vector<std::uint8_t> admitted(1);
      planner.find_admitted(robot, seen, workspace, velocities, admitted);
      return admitted[0] == 1;
    };
    EXPECT_TRUE(admits_all(range)) << k;
    if (!admits_all(0.4 * range)) ++admitted_less;
  }
  EXPECT_GT(admitted_less, 50);
}

}  // namespace
}  // namespace avo
