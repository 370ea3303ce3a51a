// SPDX-License-Identifier: Apache-2.0
// Doors open and close: static obstacles come and go while robots move.
#include "sim/host/edits.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "unit/sim/judged.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::Judged;
using test::pieces;
using test::robot_at;

const StaticObstacle kDoor = pieces({{{10, 4}, {10, 6}}});

// Robots in the left one of two rooms; the door between them is 2 m wide.
Scenario rooms(const std::vector<RobotSetup>& robots) {
  Scenario scene;
  scene.obstacles = {pieces(test::two_rooms(2.0))};
  scene.robots = robots;
  return scene;
}

std::string refusal(Simulation& simulation, const StaticObstacle& obstacle) {
  const std::vector<std::byte> before = simulation.save();
  std::string message = "accepted";
  try {
    simulation.add_obstacle(obstacle);
  } catch (const Error& error) {
    message = error.what();
    EXPECT_TRUE(simulation.save() == before) << message;
  }
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

TEST(Edits, a_robot_waits_before_a_door_that_closes_and_goes_on_once_it_opens) {
  for (const bool navigation : {true, false}) {
    Scenario scene = rooms({robot_at({3, 5}, {17, 5})});
    scene.navigation = navigation;
    Judged judged(scene, 1);
    Simulation& simulation = judged.simulation;
    judged.run(2.0);
    EXPECT_TRUE(simulation.unreachable().empty());
    const ObstacleId door = simulation.add_obstacle(kDoor);
    EXPECT_EQ(door.value, 1u);
    EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
    judged.run(20.0);
    EXPECT_LT(simulation.fleet().position[0].x, 9.5);
    simulation.remove_obstacle(door);
    EXPECT_TRUE(simulation.unreachable().empty());
    if (navigation) {  // without, it has gone along the wall
      EXPECT_LT(norm(simulation.fleet().velocity[0]), 1e-3);
      judged.run(20.0);
      EXPECT_TRUE(simulation.all_at_goal());
    }
    EXPECT_TRUE(judged.report().safe());
    EXPECT_GT(*judged.report().least_static_clearance, 0.0);
  }
}

TEST(Edits, a_robot_turns_to_another_way_when_a_door_closes) {
  Scenario scene = rooms({robot_at({3, 5}, {17, 5})});
  scene.obstacles = {pieces({{{10, 0}, {10, 4}}, {{10, 6}, {10, 30}}})};
  Judged judged(scene, 1);
  judged.run(2.0);
  EXPECT_EQ(judged.simulation.perceive({0}).robot.preferred_velocity.y, 0.0);
  judged.simulation.add_obstacle(kDoor);
  EXPECT_TRUE(judged.simulation.unreachable().empty());
  EXPECT_LT(judged.simulation.perceive({0}).robot.preferred_velocity.y, -0.1);
  double lowest = 1e300;
  while (!judged.simulation.all_at_goal() && judged.simulation.time() < 40.0) {
    judged.step();
    lowest = std::min(lowest, judged.simulation.fleet().position[0].y);
  }
  EXPECT_TRUE(judged.simulation.all_at_goal());
  EXPECT_LT(lowest, 0.0);
  EXPECT_TRUE(judged.report().safe());
}

TEST(Edits, a_robot_takes_the_shorter_way_as_soon_as_its_door_opens) {
  Scenario scene;
  scene.obstacles = {pieces({{{-30, 0}, {-1, 0}}, {{1, 0}, {30, 0}}}), pieces({{{-1, 0}, {1, 0}}})};
  scene.robots = {robot_at({6, -2}, {6, 2})};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 15; ++k) simulation.step();
  EXPECT_GT(simulation.perceive({0}).robot.preferred_velocity.x, 1.0);
  simulation.remove_obstacle({1});
  EXPECT_LT(simulation.perceive({0}).robot.preferred_velocity.x, 0.0);
}

TEST(Edits, an_obstacle_that_braking_would_touch_is_refused_with_the_arithmetic) {
  Scenario scene = rooms({robot_at({3, 9}, {3, 9}), robot_at({5, 5}, {17, 5})});
  scene.robots[1].velocity = {2, 0};
  Simulation simulation(scene, 1);
  EXPECT_EQ(refusal(simulation, pieces({{{7, 4}, {7, 6}}})),
            "obstacle 1: found robot 1 at [5, 5], which is 2 m from it, 0 m once it has braked, "
            "must be >= 0.5 + 0 m and 2.7e-12 m for rounding");
  // 2 m/s take v²/2a = 2 m to brake, less rounding
  EXPECT_NE(refusal(simulation, pieces({{{7.499, 4}, {7.499, 6}}})), "accepted");
  EXPECT_EQ(refusal(simulation, pieces({{{7.501, 4}, {7.501, 6}}})), "accepted");
}

TEST(Edits, bad_ones_are_refused_in_a_line) {
  Scenario scene = rooms({robot_at({3, 9}, {3, 9}), robot_at({5, 5}, {17, 5})});
  Simulation simulation(scene, 1);
  StaticObstacle thin = kDoor;
  thin.radius = -0.1;
  EXPECT_EQ(refusal(simulation, thin), "obstacle 1: radius: found -0.1, must be >= 0 m");
  EXPECT_EQ(refusal(simulation, pieces({{{10, 4}, {10, 1.0 / 0.0}}})),
            "obstacle 1: points.1: found inf, must be a finite number");
  EXPECT_EQ(refusal(simulation, {{Chain{}}}),
            "obstacle 1: chains: found one without points, must be of a point at least");
  const Chain square{{{1, 7}, {5, 7}, {5, 11}, {1, 11}}, true};
  EXPECT_EQ(refusal(simulation, {{square}, 0.0, Fill::solid}),
            "obstacle 1: found robot 0 at [3, 9], must be outside of the solid");
  EXPECT_EQ(refusal(simulation, {{square}, 0.0, Fill::bounds}),
            "obstacle 1: found robot 1 at [5, 5], must be inside of the bounds");
  EXPECT_EQ(refusal(simulation, {{square}, 0.0, Fill::none}), "accepted");
  const std::vector<std::byte> before = simulation.save();
  for (const std::uint64_t id : {2u, 77u}) {
    try {
      simulation.remove_obstacle({id});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "obstacle " + std::to_string(id) + ": found none of that id");
    }
  }
  simulation.remove_obstacle({1});
  EXPECT_THROW(simulation.remove_obstacle({1}), Error);
  EXPECT_EQ(simulation.add_obstacle(kDoor).value, 2u) << "ids are never reused";
}

// A start is not refused there either.
TEST(Edits, without_a_certificate_only_bad_values_are_refused) {
  for (const Method method : {Method::avo, Method::avo_paper, Method::orca}) {
    Scenario scene = rooms({robot_at({5, 5}, {17, 5})});
    scene.robots[0].velocity = {2, 0};
    scene.method = method;
    scene.certificate = Certificate::none;
    Simulation simulation(scene, 1);
    EXPECT_EQ(refusal(simulation, pieces({{{5.2, 4}, {5.2, 6}}})), "accepted");
    StaticObstacle thin = kDoor;
    thin.radius = -0.1;
    EXPECT_NE(refusal(simulation, thin), "accepted");
  }
}

TEST(Edits, the_first_obstacle_may_come_late_and_the_last_one_go) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {10, 0}), robot_at({0, 3}, {10, 3})};
  Judged judged(scene, 1);
  Simulation& simulation = judged.simulation;
  Simulation untouched(scene, 1);
  judged.run(1.0);
  for (int k = 0; k < 10; ++k) untouched.step();
  const ObstacleId wall = simulation.add_obstacle(pieces({{{5, -4}, {5, 8}}}));
  EXPECT_EQ(wall.value, 0u);
  simulation.remove_obstacle(wall);
  EXPECT_EQ(simulation.state_hash(), untouched.state_hash());
  simulation.add_obstacle(pieces({{{5, -4}, {5, 8}}, {{-2, 1.5}, {1, 1.5}}}));
  EXPECT_GT(std::abs(simulation.perceive({0}).robot.preferred_velocity.y), 0.1);
  EXPECT_FALSE(simulation.perceive({0}).walls.empty());
  judged.run(30.0);
  EXPECT_TRUE(simulation.all_at_goal());
  simulation.remove_obstacle({1});
  EXPECT_TRUE(simulation.obstacles().id.empty());
  EXPECT_TRUE(simulation.perceive({0}).walls.empty());
  judged.run(1.0);
  EXPECT_TRUE(judged.report().safe());
  // what a robot needs beside walls is asked of those that are there
  scene.robots[1].radius = 1e-3;
  Simulation tiny(scene, 1);
  EXPECT_EQ(refusal(tiny, kDoor).find("robot 1: radius: found 0.001, must be > 0.0025"), 0u);
}

TEST(Edits, whoever_comes_or_turns_after_them_knows_the_walls) {
  Scenario scene = rooms({robot_at({3, 5}, {7, 5})});
  Simulation simulation(scene, 1);
  const ObstacleId door = simulation.add_obstacle(kDoor);
  const RobotId late = simulation.add_robot(robot_at({3, 8}, {17, 8}));
  simulation.set_goal({0}, {17, 5});
  const std::vector<RobotId> both{{0}, late};
  EXPECT_EQ(simulation.unreachable(), both);
  simulation.set_goal(late, {7, 8});
  EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
  simulation.remove_obstacle(door);
  EXPECT_TRUE(simulation.unreachable().empty());
}

// A fast robot that has come since the grid of walls was built, and obstacles that have.
TEST(Edits, perceive_is_what_the_step_decides_on) {
  Scenario scene = rooms({robot_at({3, 5}, {17, 5})});
  scene.sensing_radius = 100.0;
  scene.navigation = false;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 5; ++k) simulation.step();
  RobotSetup fast = robot_at({-30, 5}, {17, 5.5});
  fast.max_speed = fast.preferred_speed = 8.0;
  fast.velocity = {7.55, 0};  // the nearest wall, 30 m away, is just out of its braking's reach
  simulation.add_robot(fast);
  PlanWorkspace workspace;
  for (int k = 0; k < 20; ++k) {
    if (k == 10) simulation.add_obstacle(kDoor);
    std::vector<Plan> plans;
    for (std::size_t i = 0; i < 2; ++i) {
      Simulation::Perception seen = simulation.perceive({i});
      plans.push_back(simulation.planner().plan(seen.robot, seen.neighbors, workspace, &seen.detour,
                                                seen.walls));
    }
    simulation.step();
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(simulation.fleet().plan[i].new_velocity, plans[i].new_velocity) << k;
  }
}

}  // namespace
// It has stood in the midst of four others for a minute; what that taught it is about the old goal.
TEST(Edits, a_new_goal_begins_anew) {
  Scenario scene;
  scene.robots = {{}};
  for (const Vec2 place : {Vec2{1.05, 0}, {-1.05, 0}, {0, 1.05}, {0, -1.05}})
    scene.robots.push_back({.position = place, .goal = place});
  Simulation simulation(scene, 1);
  for (int i = 0; i < 600; ++i) simulation.step();
  EXPECT_GT(simulation.fleet().detour[0].beside, 20.0F);
  for (std::uint64_t other = 1; other <= 4; ++other) simulation.remove_robot({other});
  const Vec2 goal = simulation.fleet().position[0] + Vec2{0.0, 0.4};
  simulation.set_goal({0}, goal);
  EXPECT_EQ(simulation.fleet().detour[0].beside, 0.0F);
  for (int i = 0; i < 25; ++i) simulation.step();
  EXPECT_NEAR(norm(simulation.fleet().position[0] - goal), 0.0, 1e-12);
  EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
}

// As a scene in which it had stood there from the start: nothing of it is remembered elsewhere.
TEST(Edits, a_robot_that_is_put_down_elsewhere_is_as_if_it_had_come_there) {
  Scenario scene = rooms({robot_at({3, 5}, {17, 5}), robot_at({3, 8}, {17, 8})});
  scene.response_time = 0.0;  // or else the other one remembers its last acceleration
  Simulation simulation(scene, 1);
  for (int k = 0; k < 30; ++k) simulation.step();
  simulation.move_robot({0}, {2, 2});
  EXPECT_EQ(simulation.fleet().position[0], (Vec2{2, 2}));
  EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
  EXPECT_EQ(simulation.fleet().id[0].value, 0u);
  EXPECT_NEAR(simulation.route({0}).length, norm(Vec2{8, 3}) + 7.0,
              1.5);  // by the door, from there

  scene.robots = {simulation.fleet().setup[0], simulation.fleet().setup[1]};
  scene.robots[1].velocity = simulation.fleet().velocity[1];
  Simulation fresh(scene, 1);
  for (int k = 0; k < 60; ++k) {
    simulation.step(), fresh.step();
    ASSERT_EQ(simulation.fleet().position[0], fresh.fleet().position[0]) << k;
  }
}

TEST(Edits, robots_that_are_moved_are_kept_apart_and_saved) {
  Judged judged(rooms({robot_at({3, 5}, {17, 5}), robot_at({5, 5.2}, {17, 8})}), 1);
  Simulation& simulation = judged.simulation;
  judged.run(2.0);
  const std::vector<std::byte> before = simulation.save();
  EXPECT_THROW(simulation.move_robot({7}, {2, 2}), Error);
  EXPECT_THROW(simulation.move_robot({0}, {std::nan(""), 2}), Error);
  EXPECT_TRUE(simulation.save() == before);
  simulation.move_robot({1}, {2, 7});
  Simulation other(simulation.save(), 1);
  for (int k = 0; k < 150; ++k) simulation.step(), other.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
  EXPECT_GE(norm(simulation.fleet().position[0] - simulation.fleet().position[1]), 1.0);
}

TEST(Edits, delayed_senses_see_nothing_of_where_a_moved_robot_was) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {20, 0}), robot_at({8, 0}, {-20, 0})};
  scene.sensing_radius = 15.0;
  scene.sensing.delay = 5;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 10; ++k) simulation.step();
  EXPECT_EQ(simulation.perceive({0}).neighbors.size(), 1u);
  simulation.move_robot({1}, {8, 9});
  for (const Neighbor& seen : simulation.perceive({0}).neighbors)
    EXPECT_GT(seen.position.y, 8.0) << "where it is, or nothing yet";
  for (int k = 0; k < 100; ++k) simulation.step();
  EXPECT_GE(norm(simulation.fleet().position[0] - simulation.fleet().position[1]), 1.0);
}

TEST(Edits, parked_robots_are_not_moved_and_airplanes_fly_on) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {20, 0}), robot_at({8, 0}, {8, 0})};
  scene.robots[1].behavior = Behavior::parked;
  Simulation simulation(scene, 1);
  EXPECT_THROW(simulation.move_robot({1}, {8, 9}), Error);

  Scenario sky;
  sky.sensing_radius = 100.0;
  sky.robots = {robot_at({0, 0}, {60, 0})};
  sky.robots[0].model = Airplane{};
  sky.robots[0].velocity = {2.0, 0.0};
  Simulation flying(sky, 1);
  flying.step();
  const Vec2 velocity = flying.fleet().velocity[0];
  flying.move_robot({0}, {0, 30});
  EXPECT_EQ(flying.fleet().position[0], (Vec2{0, 30}));
  EXPECT_NEAR(norm(flying.fleet().velocity[0] - velocity), 0.0, 1e-12);
  flying.step();
  EXPECT_LT(norm(flying.fleet().position[0] - Vec2{0, 30}), 0.5);

  scene.robots.erase(scene.robots.begin());
  scene.sensing_radius = 100.0;
  Simulation beside(scene, 1);
  sky.robots[0].position.y = 30.0;
  EXPECT_EQ(beside.add_robot(sky.robots[0]).value, 1U) << "the parked one keeps its promise";
}

}  // namespace avo
