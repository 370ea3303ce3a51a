// SPDX-License-Identifier: Apache-2.0
// Cars that cannot turn in place, along kerbs and into gaps (docs/arrival.md, "Cars").
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {
namespace {

// m: those that a car has, from the middle of its axle.
struct Size {
  double curvature, offset, radius;
};
constexpr Size kSizes[] = {{0.18, 1.35, 2.4}, {0.18, 0.0, 2.0}, {0.18, -1.0, 2.4}, {0.8, 0.5, 0.9}};

RobotSetup car_of(const Size& size, bool reverse) {
  RobotSetup robot;
  robot.radius = size.radius;
  robot.model = Car{.max_curvature = size.curvature,
                    .body = CarBody{size.offset, size.radius},
                    .reverse = reverse};
  return robot;
}

// A kerb along y.
StaticObstacle kerb(double y) {
  return {.chains = {Chain{{{-200.0, y}, {200.0, y}}, false}}};
}

struct Driven {
  double time = std::numeric_limits<double>::infinity();       // s, of the arrival
  double clearance = std::numeric_limits<double>::infinity();  // m, from kerbs and others
};

double clearance_of(const Scenario& scene, Vec2 center) {
  const double radius = scene.robots[0].radius;
  double least = std::numeric_limits<double>::infinity();
  for (const StaticObstacle& obstacle : scene.obstacles)
    least = std::min(least, std::abs(center.y - obstacle.chains[0].points[0].y) - radius);
  for (std::size_t k = 1; k < scene.robots.size(); ++k)
    least =
        std::min(least, norm(center - scene.robots[k].position) - radius - scene.robots[k].radius);
  return least;
}

Driven drive(const Scenario& scene, double most) {
  Driven result;
  Simulation simulation(scene, 1);
  while (simulation.time() < most && !simulation.is_at_goal({0})) {
    simulation.step();
    const FleetView fleet = simulation.fleet();
    const Vec2 center = disc_center(scene.robots[0].model, fleet.position[0], fleet.heading[0]);
    result.clearance = std::min(result.clearance, clearance_of(scene, center));
  }
  if (simulation.is_at_goal({0})) result.time = simulation.time();
  return result;
}

// It took the goal for its axle to be one for its disc, and never found it clear: 252 s with a
// reverse gear, and never without.
TEST(CarManeuvers, a_goal_beside_a_kerb_is_driven_to_at_once) {
  for (const bool reverse : {false, true}) {
    Scenario scene;
    scene.obstacles = {kerb(-4.0), kerb(6.0)};
    RobotSetup robot = car_of(kSizes[0], reverse);
    robot.position = {-15.0, 1.0}, robot.goal = {0.0, -1.3};
    scene.robots = {robot};
    const Driven found = drive(scene, 60.0);
    EXPECT_LT(found.time, 10.0) << reverse;
    EXPECT_GT(found.clearance, 0.0);
  }
}

// The car stands and goes between kerbs as it likes, and with a reverse gear it starts up to 0.4
// rad off their direction.
TEST(CarManeuvers, kerbs_take_little_time) {
  Random random(11);
  for (int k = 0; k < 120; ++k) {
    const Size& size = kSizes[k % 4];
    const double turning = 1.0 / size.curvature, room = random.uniform(0.6, 3.0) * size.radius;
    RobotSetup robot = car_of(size, /*reverse=*/k % 3 != 0);
    robot.heading = k % 3 == 0 ? 0.0 : random.uniform(-0.4, 0.4);
    robot.position = {-size.offset * std::cos(robot.heading),
                      room * random.uniform(0.2, 0.8) - size.offset * std::sin(robot.heading)};
    const double beside =
        k % 5 == 0 ? random.uniform(0.06, 0.2) * size.radius : random.uniform(0.1, 0.9) * room;
    robot.goal = {random.uniform(2.0, 5.0) * turning + 2.0 * size.radius,
                  k % 2 == 0 ? beside : room - beside};
    Scenario free, scene;
    free.robots = scene.robots = {robot};
    scene.obstacles = {kerb(-size.radius), kerb(room + size.radius)};
    const Driven found = drive(scene, 200.0);
    EXPECT_LE(found.time, 1.5 * drive(free, 200.0).time + 3.0) << k;
    EXPECT_GT(found.clearance, 0.0) << k;
  }
}

// gap: of the cars' lengths. On a road of one more car's width, or beside an open place.
Scenario parking(const Size& size, double gap, double side, bool is_road, Vec2 from,
                 double heading) {
  Scenario scene;
  const double r = size.radius;
  scene.obstacles = {kerb(-1.15 * side * r)};
  if (is_road) scene.obstacles.push_back(kerb(7.0 * side * r));
  RobotSetup robot = car_of(size, /*reverse=*/true);
  robot.heading = heading;
  robot.position = {from.x * r, side * from.y * r};
  scene.robots = {robot};
  for (const double end : {-1.0, 1.0}) {
    RobotSetup parked;
    parked.radius = r;
    parked.position = parked.goal = {end * (1.0 + gap) * r, 0.0};
    parked.behavior = Behavior::parked;
    scene.robots.push_back(parked);
  }
  return scene;
}

// Never, before.
TEST(CarManeuvers, parks_between_two_parked_discs) {
  double last = 0.0;
  for (const Size& size : kSizes) {
    for (const double gap : {1.2, 1.6}) {
      for (const double side : {-1.0, 1.0}) {
        for (const Vec2 from : {Vec2{-4.0, 3.0}, Vec2{0.0, 2.6}, Vec2{4.0, 3.0}}) {
          for (const double heading : {0.0, std::numbers::pi}) {
            const Driven found =
                drive(parking(size, gap, side, from.x != 0.0, from, heading), 120.0);
            EXPECT_LE(found.time, 60.0) << size.offset << ' ' << size.radius << ' ' << gap << ' '
                                        << side << ' ' << from.x << ' ' << heading;
            EXPECT_GT(found.clearance, 0.0);
            last = std::max(last, found.time);
          }
        }
      }
    }
  }
  RecordProperty("last", std::to_string(last));
}

// The course of a long car on a narrow road takes more than two moves: with two the car drives
// about for ever.
TEST(CarManeuvers, some_gaps_take_several_moves) {
  Scenario scene;
  scene.obstacles = {kerb(3.0), kerb(-17.903675)};
  RobotSetup robot = car_of({0.12, 2.0, 3.0}, /*reverse=*/true);
  robot.position = {-17.634457, -10.526656}, robot.goal = {2.0, -0.4272};
  scene.robots = {robot};
  for (const double x : {-9.0, 9.0}) {
    RobotSetup parked;
    parked.radius = 3.0;
    parked.position = parked.goal = {x, -0.4272};
    parked.behavior = Behavior::parked;
    scene.robots.push_back(parked);
  }
  const Driven found = drive(scene, 120.0);
  EXPECT_LE(found.time, 60.0);
  EXPECT_GT(found.clearance, 0.0);
}

// `avo explain` shows what was decided: in the midst of a search as anywhere.
TEST(CarManeuvers, what_is_perceived_says_what_is_decided) {
  const Scenario scene = parking(kSizes[3], 1.5, 1.0, true, {-4.0, 3.0}, 0.0);
  Simulation simulation(scene, 1);
  PlanWorkspace workspace;
  while (simulation.time() < 12.0) {
    const Simulation::Perception seen = simulation.perceive({0});
    Detour detour = seen.detour;
    const Plan plan =
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
    simulation.step();
    EXPECT_EQ(plan.new_velocity, simulation.fleet().plan[0].new_velocity) << simulation.time();
  }
}

// A search looks no farther than it says, wherever the car is and whatever else there is.
TEST(CarManeuvers, walls_far_away_change_no_bit) {
  Scenario scene = parking(kSizes[3], 1.3, 1.0, true, {-4.0, 3.0}, 0.0), larger = scene;
  larger.obstacles.push_back(kerb(150.0));
  Simulation one(scene, 1), other(larger, 1);
  while (one.time() < 30.0) {
    one.step(), other.step();
    ASSERT_EQ(one.fleet().position[0], other.fleet().position[0]) << one.time();
  }
  EXPECT_TRUE(one.is_at_goal({0}));
}

}  // namespace
}  // namespace avo::test
