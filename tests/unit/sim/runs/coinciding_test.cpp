// SPDX-License-Identifier: Apache-2.0
// Robots at one place, with one velocity and one goal: nothing but their ids tells them apart.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "avo/robot.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

constexpr double kContact = 1.0;  // m, of the discs of these robots

RobotSetup holonomic() {
  return test::robot_at({}, {10.0, 0.0});
}
RobotSetup car() {
  RobotSetup setup = holonomic();
  setup.model = Car{};
  return setup;
}
RobotSetup reversing_car() {
  RobotSetup setup = holonomic();
  setup.model = Car{.max_curvature = 0.8, .reverse = true};
  return setup;
}
RobotSetup forward_car() {
  RobotSetup setup = holonomic();
  setup.model = Car{.max_curvature = 0.8};
  return setup;
}
RobotSetup drive() {
  RobotSetup setup = holonomic();
  setup.model = DifferentialDrive{};
  setup.radius = 0.3;  // of its disc, 0.5
  return setup;
}

Scenario crowd_of(int robots, const RobotSetup& setup) {
  Scenario scene{.allow_broken_assumptions = true};
  scene.robots.assign(static_cast<std::size_t>(robots), setup);
  return scene;
}

StaticObstacle wall_at(double y) {
  return {.chains = {{{{-30.0, y}, {30.0, y}}}}};
}

// Least distance of two discs, m.
double least_distance(const Simulation& simulation, double ahead) {
  const FleetView fleet = simulation.fleet();
  const auto center = [&](std::size_t k) {
    return fleet.position[k] + ahead * Vec2{std::cos(fleet.heading[k]), std::sin(fleet.heading[k])};
  };
  double least = 1e9;
  for (std::size_t i = 0; i < fleet.position.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) least = std::min(least, norm(center(i) - center(k)));
  return least;
}

// s, until none of them overlap; `last` if some still do then. No limit is broken meanwhile.
double time_apart(const Scenario& scene, double last) {
  const bool holonomic = std::holds_alternative<Holonomic>(scene.robots.front().model);
  const auto* drive = std::get_if<DifferentialDrive>(&scene.robots.front().model);
  const double ahead = drive != nullptr ? drive->offset : 0.0;
  Simulation simulation(scene, 1);
  std::vector<Vec2> before(scene.robots.size());
  while (simulation.time() < last) {
    std::copy_n(simulation.fleet().velocity.begin(), before.size(), before.begin());
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < before.size(); ++k) {
      const RobotSetup& setup = scene.robots[k];
      EXPECT_LE(fleet.applied_acceleration[k], setup.max_acceleration * (1.0 + 1e-9));
      EXPECT_LE(norm(fleet.velocity[k]), setup.max_speed * (1.0 + 1e-9));
      const double change = norm(fleet.velocity[k] - before[k]);
      if (holonomic && !adopts_at_once(scene.method)) {
        EXPECT_LE(change, scene.time_step * setup.max_acceleration * (1.0 + 1e-9));
      }
    }
    if (least_distance(simulation, ahead) >= kContact) return simulation.time();
  }
  return last;
}

TEST(Coinciding, two_part_as_fast_as_their_limits_allow) {
  // half of the contact takes each of them 1 s from rest
  EXPECT_LE(time_apart(crowd_of(2, holonomic()), 40.0), 1.2);
  EXPECT_LE(time_apart(crowd_of(2, drive()), 40.0), 1.5);
  EXPECT_LE(time_apart(crowd_of(2, reversing_car()), 40.0), 1.5);
  EXPECT_LE(time_apart(crowd_of(2, forward_car()), 40.0), 2.0);
  EXPECT_LE(time_apart(crowd_of(2, car()), 40.0), 2.0);  // it turns first
}

TEST(Coinciding, crowds_of_all_that_decide_part) {
  for (const int robots : {3, 5, 10, 20}) {
    SCOPED_TRACE(robots);
    EXPECT_LE(time_apart(crowd_of(robots, holonomic()), 40.0), 4.0);
    EXPECT_LE(time_apart(crowd_of(robots, drive()), 40.0), 5.0);
    EXPECT_LE(time_apart(crowd_of(robots, car()), 40.0), 15.0);
    EXPECT_LE(time_apart(crowd_of(robots, reversing_car()), 40.0), 20.0);
    EXPECT_LE(time_apart(crowd_of(robots, forward_car()), 40.0), 25.0);  // one after the other
  }
}

// Beside one wall and between two, 0.25 m from their discs.
TEST(Coinciding, they_part_beside_walls) {
  for (const bool both : {false, true}) {
    const auto time = [&](int robots, const RobotSetup& setup) {
      Scenario scene = crowd_of(robots, setup);
      scene.obstacles.push_back(wall_at(-0.75));
      if (both) scene.obstacles.push_back(wall_at(0.75));
      return time_apart(scene, 60.0);
    };
    for (const int robots : {2, 5, 10, 20}) {
      SCOPED_TRACE(robots);
      EXPECT_LE(time(robots, holonomic()), 15.0);
      EXPECT_LE(time(robots, drive()), 33.0);
    }
    for (const RobotSetup& setup : {car(), reversing_car(), forward_car()})
      EXPECT_LE(time(2, setup), 4.0);
  }
}

TEST(Coinciding, they_part_however_they_sense_and_decide) {
  for (const int robots : {2, 10, 20}) {
    SCOPED_TRACE(robots);
    Scenario late = crowd_of(robots, holonomic());
    late.sensing.delay = 1;
    EXPECT_LE(time_apart(late, 40.0), 5.0);
    Scenario free = crowd_of(robots, holonomic());
    free.clock = Clock::free;
    EXPECT_LE(time_apart(free, 40.0), 8.0);
    for (const Method method :
         {Method::avo_paper, Method::orca_clamped, Method::buffered_voronoi}) {
      Scenario other = crowd_of(robots, holonomic());
      other.method = method;
      EXPECT_LE(time_apart(other, 40.0), 8.0) << to_string(method);
    }
  }
}

// All of the 45 pairs of robots of different sizes and limits, in motion, nearly at one place too.
TEST(Coinciding, those_that_nearly_coincide_part_as_well) {
  test::Random random(1);
  for (const double spread : {0.0, 1e-15, 1e-9, 1e-3, 0.1}) {
    Scenario scene = crowd_of(10, holonomic());
    for (RobotSetup& setup : scene.robots) {
      setup.position = test::in_disc(random, spread);
      setup.velocity = {0.6, 0.1};
    }
    EXPECT_LE(time_apart(scene, 40.0), 10.0) << spread;
  }
}

TEST(Coinciding, those_added_and_moved_to_a_place_part) {
  Scenario scene = crowd_of(1, holonomic());
  Simulation simulation(scene, 1);
  for (int k = 0; k < 4; ++k) simulation.add_robot(holonomic());
  const RobotId far = simulation.add_robot(test::robot_at({-20.0, 0.0}, {10.0, 0.0}));
  simulation.move_robot(far, {});
  while (simulation.time() < 4.0) simulation.step();
  EXPECT_GE(least_distance(simulation, 0.0), kContact);
}

// On board, a robot that knows ids can say so. Without ids, two robots that wish for the same stay
// one.
TEST(Coinciding, on_board_a_parting_direction_tells_two_apart) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  Robot robot;
  robot.preferred_velocity = {1.0, 0.0};
  Neighbor other;
  const Vec2 n = parting_direction(7, 3);
  EXPECT_NEAR(norm(n), 1.0, 1e-15);
  EXPECT_EQ(n, -parting_direction(3, 7));
  EXPECT_EQ(parting_direction(3, 3), Vec2{});
  const Vec2 alike = planner.plan(robot, std::span(&other, 1), workspace).next_velocity;
  EXPECT_EQ(alike, planner.plan(robot, {}, workspace).next_velocity);
  other.parting = n;
  const Vec2 first = planner.plan(robot, std::span(&other, 1), workspace).next_velocity;
  other.parting = -n;
  const Vec2 second = planner.plan(robot, std::span(&other, 1), workspace).next_velocity;
  EXPECT_NEAR(dot(n, first - second), 0.2, 1e-9);  // u each
  other.parting = {std::nan(""), 0.0};
  EXPECT_EQ(planner.plan(robot, std::span(&other, 1), workspace).status, PlanStatus::invalid_input);
}

}  // namespace
}  // namespace avo
