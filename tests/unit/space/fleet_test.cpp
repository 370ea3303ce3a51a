// SPDX-License-Identifier: Apache-2.0
// Fleets in space arrive without contact, and the same whatever the number of threads.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/space/check.h"
#include "avo/space/simulation.h"

namespace avo::space::tests {
namespace {

// The robots have antipodal goals on a sphere, and all of them meet in the middle.
Scenario sphere(int count, double radius, double downwash = 0.0) {
  Scenario scene;
  scene.duration = 60.0;
  const double golden = 3.14159265358979323846 * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / count, across = std::sqrt(1.0 - z * z);
    RobotSetup robot;
    robot.position = radius * Vec3{across * std::cos(golden * k), across * std::sin(golden * k), z};
    robot.goal = -robot.position;
    robot.downwash = downwash;
    scene.robots.push_back(robot);
  }
  return scene;
}

CheckReport report_of(const Scenario& scene, int threads = 1) {
  Simulation simulation(scene, threads);
  std::vector<CheckedRobot> bodies;
  for (const RobotSetup& robot : scene.robots)
    bodies.push_back({.radius = robot.radius,
                      .downwash = robot.downwash,
                      .max_acceleration = robot.max_acceleration,
                      .max_speed = robot.max_speed,
                      .goal = robot.goal});
  Check check(bodies, scene.boxes);
  const auto observe = [&] {
    std::vector<CheckedState> rows;
    for (std::size_t k = 0; k < simulation.size(); ++k)
      rows.push_back({static_cast<std::int64_t>(k), simulation.robots()[k].position,
                      simulation.robots()[k].velocity});
    check.add(simulation.time(), rows);
  };
  observe();
  bool all = false;
  while (!all && simulation.time() < scene.duration) {
    simulation.step();
    observe();
    all = true;
    for (std::size_t k = 0; k < simulation.size(); ++k) all = all && simulation.is_at_goal({k});
  }
  return check.report();
}

TEST(SpaceFleets, a_sphere_of_50_arrives_without_contact) {
  const CheckReport report = report_of(sphere(50, 7.1));
  EXPECT_FALSE(report.broken());
  EXPECT_EQ(report.arrived, 50);
  EXPECT_LT(*report.last_arrival, 14.0);
}

TEST(SpaceFleets, nobody_flies_below_another_where_downwash_is_declared) {
  const CheckReport report = report_of(sphere(30, 7.1, 1.5));
  EXPECT_FALSE(report.broken());
  EXPECT_EQ(report.arrived, 30);
}

TEST(SpaceFleets, a_floor_and_a_ceiling_are_not_touched) {
  Scenario scene = sphere(16, 8.0);
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    const double angle = 0.3926990816987241 * static_cast<double>(k);
    scene.robots[k].position = {8.0 * std::cos(angle), 8.0 * std::sin(angle), 1.0};
    scene.robots[k].goal = {-8.0 * std::cos(angle), -8.0 * std::sin(angle), 1.0};
  }
  scene.boxes = {{{-Box::kFar, -Box::kFar, -Box::kFar}, {Box::kFar, Box::kFar, 0.0}, 0.0, 0.0},
                 {{-Box::kFar, -Box::kFar, 2.2}, {Box::kFar, Box::kFar, Box::kFar}, 0.0, 0.0}};
  const CheckReport report = report_of(scene);
  EXPECT_FALSE(report.broken());
  EXPECT_EQ(report.arrived, 16);
  EXPECT_LT(*report.least_static_clearance, 0.6);
}

TEST(SpaceFleets, climb_and_sink_limit_the_vertical_speed_alone) {
  const auto flight = [](Vec3 goal) {
    Scenario scene;
    scene.duration = 100.0;
    scene.robots.push_back({.goal = goal, .climb = 0.3, .sink = 0.2});
    Simulation simulation(scene);
    double most = 0.0, least = 0.0;
    while (!simulation.is_at_goal({0}) && simulation.time() < scene.duration) {
      simulation.step();
      most = std::max(most, simulation.robots()[0].velocity.z);
      least = std::min(least, simulation.robots()[0].velocity.z);
    }
    EXPECT_LE(most, 0.3);
    EXPECT_GE(least, -0.2);
    return simulation.time();
  };
  EXPECT_LT(flight({20, 0, 0}), 13.0);
  EXPECT_LT(flight({20, 0, -0.5}), 13.0);
  EXPECT_NEAR(flight({0, 0, 6}), 5.5 / 0.3, 2.0);
  EXPECT_NEAR(flight({0, 0, -4}), 3.5 / 0.2, 2.0);
}

// The limits of acceleration and speed are met to the last bit, which rounding may exceed.
TEST(SpaceFleets, what_rounding_alone_moves_is_not_refused) {
  Scenario scene;
  for (int k = 0; k < 20; ++k) {
    RobotSetup robot;
    robot.position = {100.0 * k, 0.0, 0.0};
    robot.goal = {100.0 * k + 9.0, 1.0 + 0.7 * k, 3.0 + 0.3 * k};
    robot.vertical = k % 2 == 0 ? 1.0 : 1.3;
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  for (int step = 0; step < 200; ++step) {
    simulation.step();
    for (const Plan& plan : simulation.plans()) ASSERT_EQ(plan.status, PlanStatus::optimal) << step;
  }
}

TEST(SpaceFleets, starts_that_break_limits_or_margins_are_refused) {
  const auto is_refused = [](const RobotSetup& robot, const std::vector<Box>& boxes = {}) {
    Scenario scene;
    scene.robots = {robot};
    scene.boxes = boxes;
    try {
      validate(scene);
    } catch (const Error&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(is_refused({.velocity = {19, 0, 0}}));
  EXPECT_FALSE(is_refused({.velocity = {2, 0, 0}}));
  EXPECT_TRUE(is_refused({.velocity = {0, 0, 2}, .climb = 1.0}));
  const Box floor{{-Box::kFar, -Box::kFar, -Box::kFar}, {Box::kFar, Box::kFar, 0.0}, 0.0, 0.0};
  EXPECT_TRUE(is_refused({.position = {0, 0, 0.5}}, {floor}));
  EXPECT_FALSE(is_refused({.position = {0, 0, 0.50001}}, {floor}));
}

TEST(SpaceFleets, exponential_motion_keeps_apart_as_well) {
  Scenario scene = sphere(30, 6.0);
  scene.motion = Motion::exponential;
  const CheckReport report = report_of(scene);
  EXPECT_EQ(report.overlaps.count, 0);
  EXPECT_EQ(report.arrived, 30);
}

TEST(SpaceFleets, boxes_that_come_between_two_steps_are_heeded_or_refused) {
  Scenario scene = sphere(8, 8.0);
  Simulation simulation(scene);
  for (int k = 0; k < 10; ++k) simulation.step();
  const Vec3 place = simulation.robots()[0].position;
  const Box on_robot{place - Vec3{1, 1, 1}, place + Vec3{1, 1, 1}, 0.0, 0.0};
  EXPECT_THROW(simulation.set_boxes(std::span(&on_robot, 1)), Error);
  const Box middle{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 0.0, 0.0};
  simulation.set_boxes(std::span(&middle, 1));
  for (int k = 0; k < 150; ++k) {
    simulation.step();
    for (const Robot& robot : simulation.robots()) {
      const Vec3 p = robot.position;
      const Vec3 off{std::max(std::abs(p.x) - 0.5, 0.0), std::max(std::abs(p.y) - 0.5, 0.0),
                     std::max(std::abs(p.z) - 0.5, 0.0)};
      ASSERT_GE(norm(off), robot.radius - 1e-9);
    }
  }
}

TEST(SpaceFleets, boxes_may_be_a_part_of_the_present_ones_and_have_to_be_sound) {
  Scenario scene = sphere(2, 8.0);
  for (const double x : {-3.0, 0.0, 3.0})
    scene.boxes.push_back({{x, 20, -1}, {x + 1, 21, 1}, 0.0, 0.0});
  Simulation simulation(scene);
  simulation.set_boxes(std::span(simulation.scenario().boxes).subspan(1));
  ASSERT_EQ(simulation.scenario().boxes.size(), 2);
  EXPECT_EQ(simulation.scenario().boxes[0].min, scene.boxes[1].min);
  EXPECT_EQ(simulation.scenario().boxes[1].min, scene.boxes[2].min);
  Box broken = scene.boxes[0];
  broken.heading = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(simulation.set_boxes(std::span(&broken, 1)), Error);
  broken = scene.boxes[0];
  std::swap(broken.min, broken.max);
  EXPECT_THROW(simulation.set_boxes(std::span(&broken, 1)), Error);
  EXPECT_THROW(simulation.set_goal({0}, {1e20, 0, 0}), Error);
}

TEST(SpaceFleets, threads_change_no_bit) {
  const Scenario scene = sphere(300, 20.0);
  Simulation one(scene, 1), two(scene, 3);
  for (int k = 0; k < 15; ++k) one.step(), two.step();
  EXPECT_EQ(one.state_hash(), two.state_hash());
}

void expect_to_move_as_turned(const Scenario& scene) {
  const auto turned = [](Vec3 a) { return Vec3{-a.y, a.x, a.z}; };
  Scenario other = scene;
  for (RobotSetup& robot : other.robots)
    robot.position = turned(robot.position), robot.goal = turned(robot.goal);
  Simulation simulation(scene, 1), same(other, 1);
  for (int step = 0; step < 200; ++step) {
    simulation.step(), same.step();
    for (std::size_t k = 0; k < simulation.size(); ++k) {
      ASSERT_EQ(turned(simulation.robots()[k].position), same.robots()[k].position)
          << "robot " << k << ", step " << step;
      ASSERT_EQ(turned(simulation.robots()[k].velocity), same.robots()[k].velocity);
    }
  }
}

// Steep courses turn about a fixed axis (axis_across()), so no robot has one here.
TEST(SpaceFleets, a_scene_turned_by_90_degrees_about_the_vertical_moves_as_turned_bit_for_bit) {
  Scenario scene = sphere(60, 7.0, 0.5);
  std::erase_if(scene.robots, [](const RobotSetup& robot) {
    return std::abs(robot.position.z) > 0.9 * norm(robot.position);
  });
  expect_to_move_as_turned(scene);
  // normals with equal components, of either sign
  for (const double side : {1.0, -1.0}) {
    scene.robots.resize(2);
    scene.robots[0].position = {1.5, side * 3.5, -0.625};
    scene.robots[1].position = {0.625, side * 4.375, -0.625};
    for (RobotSetup& robot : scene.robots) robot.goal = -robot.position;
    expect_to_move_as_turned(scene);
  }
}

TEST(SpaceFleets, a_start_in_contact_is_refused_by_name) {
  Scenario scene = sphere(4, 8.0);
  scene.robots[2].position = scene.robots[1].position + Vec3{0.5, 0, 0};
  try {
    const Simulation simulation(scene);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("robots.2 and robots.1"), std::string::npos)
        << error.what();
  }
}

TEST(SpaceFleets, a_new_goal_is_followed_and_the_same_goal_changes_nothing) {
  Scenario scene = sphere(1, 5.0);
  Simulation simulation(scene), same(scene);
  for (int k = 0; k < 30; ++k) {
    same.set_goal({0}, scene.robots[0].goal);
    simulation.step(), same.step();
  }
  EXPECT_EQ(simulation.state_hash(), same.state_hash());
  simulation.set_goal({0}, {0, 0, 20});
  for (int k = 0; k < 200; ++k) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({0}));
  EXPECT_THROW(simulation.set_goal({1}, {}), Error);
}

}  // namespace
}  // namespace avo::space::tests
