// SPDX-License-Identifier: Apache-2.0
// What a certified robot does among obstacles, beside others at its goal, and as a car.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/check.h"
#include "avo/error.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

// Contacts with an obstacle during which a robot moved, by the independent judge, and decisions of
// robots in motion that something is broken.
std::int64_t broken_in_motion(const Scenario& scene) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& robot : scene.robots) {
    CheckedRobot checked;
    checked.radius = robot.radius;
    checked.max_acceleration = robot.max_acceleration;
    checked.max_speed = robot.max_speed;
    robots.push_back(checked);
  }
  std::vector<CheckedMover> obstacles;
  for (const MovingObstacle& each : scene.moving_obstacles) {
    obstacles.push_back({each.position, each.velocity, each.acceleration, each.radius});
  }
  Check check(robots, obstacles, CheckOptions{});
  Simulation simulation(scene, 1);
  std::vector<CheckedState> rows(scene.robots.size());
  const std::int64_t steps = last_step(scene, scene.duration);
  std::int64_t broken = 0;
  for (std::int64_t k = 0;; ++k) {
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = {static_cast<std::int64_t>(i), fleet.position[i], fleet.velocity[i]};
    }
    check.add(simulation.time(), rows);
    if (k == steps) break;
    simulation.step();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool moves = norm(rows[i].velocity) > 0.0;
      if (moves && simulation.fleet().plan[i].status == PlanStatus::overlapping) ++broken;
    }
  }
  return broken + check.report().mover_contacts_moving.count;
}

// At v_max 2 and u 0.1 braking takes a whole number of steps, which rounding may count as one more.
// An interval in which the robot has come to rest must not count as one in which it moves. The
// moving obstacle crosses the robot's course fast, at an angle that the search found.
TEST(CertifiedMotion, whole_numbers_of_steps_are_counted_once) {
  int crossed = 0;
  Scenario scene;
  scene.duration = 9.0;
  scene.sensing_radius = 200.0;
  scene.robots = {robot_at({0, 0}, {40, 0}), robot_at({0, 50}, {0, 50})};
  scene.moving_obstacles = {{.position = {-83.31795193815938, -34.617121590378105},
                             .velocity = {13.595674931099252, 5.0321200809841935},
                             .acceleration = {},
                             .radius = 1.488647517657194}};
  EXPECT_EQ(broken_in_motion(scene), 0);
  // the same from many sides and at many speeds
  for (int k = 0; k < 120; ++k) {
    const double angle = 0.052 * k, speed = 3.0 + 0.11 * k, meets = 2.5 + 0.03 * k;
    const Vec2 v = speed * Vec2{std::cos(angle), std::sin(angle)};
    scene.moving_obstacles[0].velocity = v;
    scene.moving_obstacles[0].position = Vec2{2.0 * meets, 0.3} - meets * v;
    if (norm(scene.moving_obstacles[0].position) < 8.0 + speed) continue;
    ++crossed;
    EXPECT_EQ(broken_in_motion(scene), 0) << "angle " << angle << ", speed " << speed;
  }
  EXPECT_GT(crossed, 50);
}

// No motion, bit for bit; also where they come to their goals at other times.
TEST(CertifiedMotion, robots_whose_goals_touch_or_overlap_come_to_rest) {
  for (const double spacing : {0.8, 0.9, 1.0, 1.0000001, 1.001, 1.05, 1.2}) {
    for (int start = 0; start < 8; ++start) {
      Scenario scene;
      for (int k = 0; k < 6; ++k) {
        const double late = 0.3 * ((start * (k + 1)) % 7);
        scene.robots.push_back(robot_at({3.0 * k, -9.0 - late}, {spacing * k, 0}));
      }
      if (spacing < 1.0) scene.robots.resize(2);  // of more, some cannot come near
      Simulation simulation(scene, 1);
      while (simulation.time() < 120.0) simulation.step();
      for (const Vec2 v : simulation.fleet().velocity)
        EXPECT_EQ(v, Vec2{}) << "spacing " << spacing << ", start " << start;
      EXPECT_TRUE(simulation.all_at_goal()) << "spacing " << spacing << ", start " << start;
    }
  }
}

TEST(CertifiedMotion, robots_at_their_goals_give_way_and_come_back) {
  Scenario scene;
  // a constraint of parked robots, too close to pass between, and one that has to get through
  for (int k = -4; k <= 4; ++k) scene.robots.push_back(robot_at({0, 1.6 * k}, {0, 1.6 * k}));
  scene.robots.push_back(robot_at({-8, 0.1}, {8, 0.1}));
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  double moved = 0.0;
  while (simulation.time() < 90.0) {
    simulation.step();
    metrics.observe(simulation);
    for (std::size_t i = 0; i < 9; ++i) {
      moved = std::max(moved, norm(simulation.fleet().position[i] - scene.robots[i].goal));
    }
  }
  EXPECT_GT(moved, 0.1);
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    EXPECT_LT(norm(simulation.fleet().position[i] - scene.robots[i].goal), 0.13) << i;
    EXPECT_EQ(simulation.fleet().velocity[i], Vec2{}) << i;
  }
}

TEST(CertifiedMotion, cars_in_a_crowd_do_not_touch) {
  Scenario scene;
  for (int k = 0; k < 36; ++k) {
    const Vec2 start{3.0 * (k % 6), 3.0 * static_cast<double>(k / 6)};
    RobotSetup car = robot_at(start, Vec2{15.0, 15.0} - start);
    car.model = Car{0.8}, car.heading = 0.7 * k;
    if (k % 7 == 0) car.model = Holonomic{};  // others among them
    scene.robots.push_back(car);
  }
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (simulation.time() < 60.0) {
    simulation.step();
    metrics.observe(simulation);
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.decisions.overlapping, 0);
  EXPECT_LE(summary.max_speed, 2.0 * (1.0 + 1e-9));
  EXPECT_EQ(summary.acceleration_excess, 0.0);
  EXPECT_GT(summary.arrived, 20);
}

TEST(CertifiedMotion, cars_are_refused_what_they_cannot_do) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0})};
  scene.robots[0].model = Car{};
  EXPECT_NO_THROW(validate(scene));
  scene.motion = Motion::exponential;
  EXPECT_THROW(validate(scene), Error);
  scene.certificate = Certificate::none;
  EXPECT_NO_THROW(validate(scene));

  PlannerOptions options;
  options.motion = Motion::exponential;
  PlanWorkspace workspace;
  Robot car{.velocity = {1, 0}, .preferred_velocity = {1, 0}};
  car.model = Car{};
  EXPECT_EQ(Planner(options).plan(car, {}, workspace).status, PlanStatus::invalid_input);
}

TEST(CertifiedMotion, what_is_no_number_is_not_admitted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const float nan_part = std::numeric_limits<float>::quiet_NaN();
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  const Robot sound{.velocity = {1, 0}, .preferred_velocity = {2, 0}};
  for (Detour detour : {Detour{nan_part}, Detour{0.0F, nan_part}, Detour{-1.0F, 7.0F}}) {
    const Plan plan = planner.plan(sound, {}, workspace, &detour);
    EXPECT_TRUE(is_finite(plan.acceleration));
    EXPECT_EQ(detour.angle, 0.0);
    EXPECT_EQ(detour.beside, 0.0F);
  }
  Robot robot = sound;
  robot.distance_to_goal = nan;
  EXPECT_EQ(planner.plan(robot, {}, workspace).status, PlanStatus::invalid_input);
  robot = sound;
  robot.model = Car{0.8}, robot.heading = nan;
  EXPECT_EQ(planner.plan(robot, {}, workspace).status, PlanStatus::invalid_input);
}

// Obstacles do not brake, whatever acceleration they are said to be capable of.
TEST(CertifiedMotion, obstacles_are_not_counted_on) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  Robot robot{.velocity = {2, 0}, .preferred_velocity = {2, 0}};
  Neighbor constraint{.position = {9, 0}, .velocity = {-2, 0}, .radius = 0.5};
  std::vector<Neighbor> obstacles;
  for (int k = -8; k <= 8; ++k) {
    obstacles.push_back(constraint);
    obstacles.back().position.y = 0.9 * k;
  }
  for (int k = 0; k < 100; ++k) {
    const Plan plan = planner.plan_among_movers(robot, obstacles, workspace);
    const Vec2 next = robot.velocity + 0.1 * plan.acceleration;
    robot.position = robot.position + 0.05 * (robot.velocity + next);
    robot.velocity = next;
    for (Neighbor& each : obstacles) {
      each.position = each.position + 0.1 * each.velocity;
      if (norm(robot.position - each.position) < 1.0 - 1e-9) {
        EXPECT_LT(norm(robot.velocity), 1e-9) << k;
      }
    }
  }
}

TEST(CertifiedMotion, robots_that_nobody_could_see_in_time_are_not_added) {
  Scenario scene;
  scene.sensing_radius = 5.5;
  scene.robots = {robot_at({0, 0}, {9, 0})};
  Simulation simulation(scene, 1);
  RobotSetup fast = robot_at({30, 0}, {0, 0});
  EXPECT_NO_THROW(simulation.add_robot(fast));
  fast.position.y = 10.0;
  fast.max_speed = 20.0;
  const std::uint64_t before = simulation.state_hash();
  EXPECT_THROW(simulation.add_robot(fast), Error);
  EXPECT_EQ(simulation.state_hash(), before);
}

// Two cars at rest that overlap by less than what their arcs could hide.
TEST(CertifiedMotion, the_judge_sees_overlaps_in_the_rows_themselves) {
  CheckedRobot car;
  car.interpolation_error = 0.01;
  Check check({car, car}, {}, CheckOptions{});
  const std::vector<CheckedState> rows{{0, {0, 0}, {}}, {1, {0.995, 0}, {}}};
  for (int k = 0; k < 3; ++k) check.add(0.1 * k, rows);
  EXPECT_EQ(check.report().overlaps.count, 1);
  EXPECT_NEAR(check.report().overlaps.worst, 0.005, 1e-6);
  EXPECT_FALSE(check.report().safe());
}

}  // namespace
}  // namespace avo
