// SPDX-License-Identifier: Apache-2.0
// Arrivals of airplanes, which fly through their goals between two rows.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "support/generators.h"
#include "unit/check/headings.h"

namespace avo::test {
namespace {

CheckedRobot flying(Vec2 goal) {
  CheckedRobot robot = free_robot();
  robot.kinematics = CheckedAirplane{};
  robot.goal = goal;
  return robot;
}

std::int64_t arrived(const CheckedRobot& robot, const CheckedState& from, const CheckedState& to,
                     double within, double step = 0.5) {
  return report_of({robot}, {{0.0, {from}}, {step, {to}}}, {}, {.arrival_distance = within})
      .arrived;
}

TEST(CheckPassing, on_arcs_of_all_kinds_to_a_millionth) {
  Random random(3);
  int within = 0;
  for (int k = 0; k < 300; ++k) {
    const CheckedState from = pose({random.uniform(-9, 9), random.uniform(-9, 9)},
                                   random.uniform(-3, 3), random.uniform(1, 9));
    const double curvature =
        k % 3 == 0 ? 0.0 : random.log_uniform(1e-6, 0.5) * (k % 2 == 0 ? 1.0 : -1.0);
    const Held held{random.uniform(-1, 1), curvature};
    const CheckedState to = driven(from, held, 0.5);
    const Vec2 goal = driven(from, held, random.uniform(-0.1, 0.6)).position +
                      Vec2{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    double least = norm(to.position - goal);
    for (int i = 0; i < 20'000; ++i)
      least = std::min(least, norm(driven(from, held, 0.5 * i / 20'000).position - goal));
    const double rows = std::min(norm(from.position - goal), norm(to.position - goal));
    within += least < rows - 1e-3 ? 1 : 0;
    EXPECT_EQ(arrived(flying(goal), from, to, least * (1.0 + 1e-6) + 1e-9), 1) << k;
    // the samples are 0.25 mm apart, so the true least distance is less by very little
    EXPECT_EQ(arrived(flying(goal), from, to, least * (1.0 - 1e-4) - 1e-6), 0) << k;
  }
  EXPECT_GT(within, 100);  // nearer than at both rows
}

TEST(CheckPassing, only_of_airplanes_and_over_steps) {
  const CheckedState from = pose({0, 0}, 0.0, 4.0), to = pose({2, 0}, 0.0, 4.0);
  CheckedRobot robot = flying({1, 0.1});
  EXPECT_EQ(arrived(robot, from, to, 0.2), 1);
  EXPECT_EQ(arrived(robot, from, to, 0.09), 0);
  EXPECT_EQ(
      report_of({robot}, {{0.0, {from}}, {0.5, {to}}}, {}, {.arrival_distance = 0.2}).last_arrival,
      0.5);
  // where the airplane was missing before, its path to the goal is unknown
  const CheckReport gone = report_of(
      {robot, free_robot()},
      {{0.0, {from, {1, {9, 9}, {}}}}, {0.2, {{1, {9, 9}, {}}}}, {0.5, {to, {1, {9, 9}, {}}}}}, {},
      {.arrival_distance = 0.2});
  EXPECT_EQ(gone.arrived, 0);
  // at its goal from the start it arrives in its first step, as in a simulation
  EXPECT_EQ(report_of({flying({0, 0})}, {{0.0, {from}}, {0.5, {to}}}).last_arrival, 0.5);
  // by velocities alone
  CheckedState bare_from = from, bare_to = to;
  bare_from.heading.reset(), bare_to.heading.reset();
  EXPECT_EQ(arrived(robot, bare_from, bare_to, 0.2), 1);
  robot.kinematics = CheckedCar{};  // it has to stay
  EXPECT_EQ(arrived(robot, from, to, 0.2), 0);
}

TEST(CheckPassing, a_wall_does_not_hide_the_goal) {
  CheckedRobot robot = flying({1, 1.5});
  for (const bool car : {false, true}) {
    if (car) robot.kinematics = CheckedCar{};
    Check check({robot}, {}, {.arrival_distance = 2.0});
    check.set_walls({{{-9, 1}, {9, 1}}});
    check.add(0.0, std::vector{pose({0, 0}, 0.0, 4.0)});
    check.add(0.5, std::vector{pose({2, 0}, 0.0, 4.0)});
    EXPECT_EQ(check.report().arrived, car ? 0 : 1);
  }
}

}  // namespace
}  // namespace avo::test
