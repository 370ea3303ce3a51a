// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers beside movers that are likely to deviate: as much of it is reckoned with as
// leaves a maneuver (docs/movers.md, "Who is likely to deviate").
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/mover_scenes.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

constexpr double kTimeStep = 0.1;  // s

Neighbor passer_by(double likely_deviation) {
  return {.position = {-6, 0.3},
          .velocity = {1, 0},
          .radius = 0.4,
          .behavior = Behavior::moves_on,
          .likely_deviation = likely_deviation};
}

struct Passed {
  double clearance = 1e9;  // m, least
  double evades_at = 1e9;  // s, first
  double leaves = 0.0;     // m, at most, from its goal
};

// A rests at its goal, and the walker goes by, or over it, at constant velocity.
Passed pass_by(Vec2 from, double speed, double likely_deviation) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot robot{.radius = 0.4};
  Neighbor other = passer_by(likely_deviation);
  other.position = from, other.velocity = {speed, 0};
  Passed result;
  for (int k = 0; k < 120; ++k) {
    robot.preferred_velocity = -0.5 * robot.position;
    const Plan plan = planner.plan(robot, std::vector{other}, workspace);
    if (plan.evading) result.evades_at = std::min(result.evades_at, kTimeStep * k);
    for (int part = 1; part <= 8; ++part) {
      const double t = kTimeStep * part / 8.0;
      const Vec2 place = robot.position + t * robot.velocity + 0.5 * t * t * plan.acceleration;
      result.clearance =
          std::min(result.clearance, norm(place - other.position - t * other.velocity) - 0.8);
    }
    robot.position = robot.position + kTimeStep * robot.velocity +
                     0.5 * kTimeStep * kTimeStep * plan.acceleration;
    robot.velocity = robot.velocity + kTimeStep * plan.acceleration;
    other.position = other.position + kTimeStep * other.velocity;
    result.leaves = std::max(result.leaves, norm(robot.position));
  }
  return result;
}

TEST(LikelyDeviation, makes_room_for_one_that_goes_by) {
  const Passed exact = pass_by({-6, 1.0}, 1.0, 0.0), likely = pass_by({-6, 1.0}, 1.0, 2.0);
  EXPECT_EQ(exact.evades_at, 1e9);
  EXPECT_LT(likely.evades_at, 5.0);
  EXPECT_GT(likely.leaves, exact.leaves + 0.1);
  EXPECT_GE(likely.clearance, exact.clearance);
}

// All of it leaves no maneuver at all.
TEST(LikelyDeviation, takes_no_way_away_however_large) {
  for (const double likely : {1.0, 10.0, 1e3, 1e6}) {
    for (const double speed : {2.0, 3.0, 4.0, 5.0})
      EXPECT_GT(pass_by({-2.0 * speed, 0.2}, speed, likely).clearance, 0.0)
          << likely << ", " << speed;
  }
}

TEST(LikelyDeviation, has_to_be_a_number_that_is_not_negative) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  for (const double bad : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Plan plan = planner.plan(Robot{}, std::vector{passer_by(bad)}, workspace);
    EXPECT_EQ(plan.status, PlanStatus::invalid_input) << bad;
  }
}

// A robot crosses a circle on which people exchange places by ORCA, at once and without limits of
// acceleration. They see the robot, or do not.
Scenario people_on_a_circle(Random& random, bool see_it) {
  Scenario scene;
  scene.time_step = 0.25, scene.sensing_radius = 10.0, scene.max_neighbors = 10;
  scene.robots = {robot_at({0, -4}, {0, 4})};
  for (int k = 0; k < 9; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.3, 0.7)) / 9.0;
    const Vec2 place = random.uniform(4.2, 5.0) * Vec2{std::sin(angle), -std::cos(angle)};
    scene.robots.push_back(robot_at(place, -place));
    scene.robots.back().method = Method::orca;
    scene.robots.back().time_horizon = 5.0;
    if (!see_it) scene.robots.back().avoids = LayerSet{1};
  }
  for (RobotSetup& robot : scene.robots) robot.radius = 0.3, robot.max_speed = 1.0;
  if (!see_it) scene.robots[0].layers = LayerSet{2};
  return scene;
}

// By where the discs are, sixteen times a step.
bool is_touched(const Scenario& scene) {
  Simulation simulation(scene, 1);
  std::vector<Vec2> p, v;
  for (int step = 0; step < 100; ++step) {
    const FleetView before = simulation.fleet();
    p.assign(before.position.begin(), before.position.end());
    v.assign(before.velocity.begin(), before.velocity.end());
    simulation.step();
    const FleetView fleet = simulation.fleet();
    const double h = scene.time_step;
    const auto place = [&](std::size_t k, double t) {
      return p[k] + t * v[k] + (t * t / (h * h)) * (fleet.position[k] - p[k] - h * v[k]);
    };
    for (int part = 1; part <= 16; ++part)
      for (std::size_t k = 1; k < p.size(); ++k) {
        const double t = h * part / 16.0;
        if (norm(place(0, t) - place(k, t)) < 0.6) return true;
      }
  }
  return false;
}

TEST(LikelyDeviation, keeps_a_robot_clear_of_people_who_turn_at_once) {
  Random random(41);
  int touched = 0;
  for (int trial = 0; trial < 80; ++trial)
    touched += static_cast<int>(is_touched(people_on_a_circle(random, trial % 2 == 0)));
  EXPECT_LE(touched, 2);
}

}  // namespace
}  // namespace avo
