// SPDX-License-Identifier: Apache-2.0
// What robots use without need: of their acceleration, of its change, and of the room.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>
#include <span>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

Scenario crossing_pair() {
  Scenario scene;
  scene.robots = {robot_at({-10, 0}, {10, 0}), robot_at({0.2, -10}, {0.2, 10})};
  return scene;
}

// The robot starts across the direction to its goal, and has to turn.
Scenario turning_robot() {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {10, 0})};
  scene.robots[0].velocity = {0, 1.5};
  return scene;
}

struct Used {
  double acceleration = 0.0;  // m/s²
  double jerk = 0.0;          // m/s³, unhindered and farther than 4 m from the goals
  double beyond = 0.0;        // m, past a goal on the x axis
  bool arrived = false;
};
Used used_by(const Scenario& scene) {
  Simulation simulation(scene, 1);
  std::vector<Vec2> last(scene.robots.size());
  Used used;
  for (int step = 0; step < 600 && !simulation.all_at_goal(); ++step) {
    simulation.step();
    for (std::size_t k = 0; k < last.size(); ++k) {
      const Plan& plan = simulation.fleet().plan[k];
      const Vec2 a = plan.acceleration;
      used.acceleration = std::max(used.acceleration, norm(a));
      // nearer to their goals, robots come to rest without swinging about them
      const double left = norm(scene.robots[k].goal - simulation.fleet().position[k]);
      if (left > 4.0 && plan.status == PlanStatus::optimal)
        used.jerk = std::max(used.jerk, norm(a - last[k]) / scene.time_step);
      last[k] = a;
    }
    used.beyond = std::max(used.beyond, simulation.fleet().position[0].x - scene.robots[0].goal.x);
  }
  used.arrived = simulation.all_at_goal();
  return used;
}

TEST(Comfort, acceleration_is_not_exceeded_in_the_open) {
  for (Scenario scene : {turning_robot(), crossing_pair()}) {
    EXPECT_GT(used_by(scene).acceleration, 0.9);
    for (const double comfort : {0.7, 0.5, 0.3}) {
      scene.comfort_acceleration = comfort;
      const Used used = used_by(scene);
      EXPECT_LE(used.acceleration, comfort * (1.0 + 1e-9));
      EXPECT_TRUE(used.arrived);
    }
  }
}

// Those with wheels come to rest with all that is used, and robots among movers alone go at once.
TEST(Comfort, acceleration_is_not_exceeded_by_any_robot_that_nobody_hinders) {
  Scenario scene;
  scene.comfort_acceleration = 0.2;
  for (const MotionModel& model :
       {MotionModel{Car{0.8}}, MotionModel{DifferentialDrive{}}, MotionModel{Holonomic{}}}) {
    scene.robots = {robot_at({0, 0}, {8, 0})};
    scene.robots[0].model = model;
    scene.moving_obstacles.clear();
    Used used = used_by(scene);
    EXPECT_LE(used.acceleration, 0.2 * (1.0 + 1e-9));
    EXPECT_TRUE(used.arrived);
    scene.moving_obstacles = {{.position = {4, 12}, .velocity = {0.5, 0}}};
    used = used_by(scene);
    EXPECT_LE(used.acceleration, 0.2 * (1.0 + 1e-9));
    EXPECT_TRUE(used.arrived);
  }
}

TEST(Comfort, one_that_sets_out_near_its_goal_does_so_gently) {
  for (const double jerk : {0.5, 1.0, 2.0}) {
    Scenario scene;
    scene.comfort_jerk = jerk;
    scene.robots = {robot_at({0, 0}, {3, 0})};
    Simulation simulation(scene, 1);
    double last = 0.0;
    for (int step = 0; step < 5; ++step) {
      simulation.step();
      const double a = simulation.fleet().plan[0].acceleration.x;
      EXPECT_GT(a, last);
      EXPECT_LE(a - last, jerk * scene.time_step * (1.0 + 1e-5));
      last = a;
    }
  }
}

TEST(Comfort, one_that_brakes_softly_begins_early) {
  Scenario scene = turning_robot();
  const double usual = used_by(scene).beyond;
  for (const double comfort : {0.7, 0.5, 0.3}) {
    scene.comfort_acceleration = comfort;
    EXPECT_LE(used_by(scene).beyond, std::max(usual, 0.0) + 0.05) << comfort;
  }
}

TEST(Comfort, jerk_is_not_exceeded_in_the_open) {
  const auto expect_kept = [](Scenario scene, std::initializer_list<double> jerks) {
    EXPECT_GT(used_by(scene).jerk, *jerks.begin());
    for (const double comfort : jerks) {
      scene.comfort_jerk = comfort;
      const Used used = used_by(scene);
      EXPECT_LE(used.jerk, comfort * (1.0 + 1e-5)) << "the last one is remembered as a float";
      EXPECT_TRUE(used.arrived);
    }
  };
  expect_kept(turning_robot(), {2.5, 2.0, 1.0});
  expect_kept(crossing_pair(), {4.5, 4.0});  // with less the certificate has to intervene
}

TEST(Comfort, the_certificate_brakes_with_all_there_is) {
  PlannerOptions options;
  options.comfort_acceleration = 0.3, options.comfort_jerk = 0.5;
  const Planner planner(options);
  PlanWorkspace workspace;
  Detour detour;
  const Robot robot{.velocity = {2, 0}, .preferred_velocity = {2, 0}};
  const Neighbor neighbor{.position = {5.03, 0}, .velocity = {-2, 0}};
  const Plan plan = planner.plan(robot, std::span(&neighbor, 1), workspace, &detour);
  EXPECT_EQ(plan.state, SafetyState::safe);
  EXPECT_GT(norm(plan.acceleration), 0.9);
  EXPECT_FLOAT_EQ(detour.acceleration_x, static_cast<float>(plan.acceleration.x));
}

// m, least clearance of the first two at the ends of steps.
double least_clearance(const Scenario& scene) {
  Simulation simulation(scene, 1);
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 600 && !simulation.all_at_goal(); ++step) {
    simulation.step();
    const auto position = simulation.fleet().position;
    least = std::min(
        least, norm(position[0] - position[1]) - scene.robots[0].radius - scene.robots[1].radius);
  }
  EXPECT_TRUE(simulation.all_at_goal());
  return least;
}

TEST(Margin, robots_that_pass_in_the_open_keep_it) {
  Scenario oncoming;
  oncoming.robots = {robot_at({-10, 0}, {10, 0}), robot_at({10, 0.1}, {-10, 0.1})};
  for (Scenario scene : {oncoming, crossing_pair()}) {
    const double without = least_clearance(scene);
    for (const double margin : {0.1, 0.2, 0.4}) {
      scene.margin = margin;
      EXPECT_GT(least_clearance(scene), std::max(0.8 * margin, without)) << margin;
    }
  }
}

TEST(Margin, closes_no_door) {
  Scenario scene;
  scene.obstacles = {{.chains = {{{{0, -8}, {0, -0.52}}}}}, {.chains = {{{{0, 0.52}, {0, 8}}}}}};
  scene.robots = {robot_at({-5, -2}, {5, 2}), robot_at({5, -3}, {-5, 3})};
  for (const double margin : {0.0, 0.1, 0.5}) {
    scene.margin = margin;
    Simulation simulation(scene, 1);
    for (int step = 0; step < 1200 && !simulation.all_at_goal(); ++step) simulation.step();
    EXPECT_TRUE(simulation.all_at_goal()) << margin;
  }
}

TEST(Margin, lets_robots_come_to_goals_beside_others) {
  Scenario scene;
  for (int k = 0; k < 6; ++k) scene.robots.push_back(robot_at({-8, 1.5 * k}, {8, 1.05 * (5 - k)}));
  scene.margin = 0.5;
  Simulation simulation(scene, 1);
  for (int step = 0; step < 1200 && !simulation.all_at_goal(); ++step) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
}

}  // namespace
}  // namespace avo
