// SPDX-License-Identifier: Apache-2.0
// Trucks and forklifts, which are rows of discs, among walls and each other: they pass, and touch
// nothing (docs/certificate/footprints.md, "Lanes, corners and yards").
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "avo/discs.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {
namespace {

constexpr double kLeft = std::numbers::pi;

struct TruckSize {
  double length, width;
};

RobotSetup truck(Vec2 position, double heading, Vec2 goal, TruckSize size = {6.0, 2.0},
                 bool reverse = true) {
  Car car{.wheelbase = 0.58 * size.length, .max_curvature = 0.2, .reverse = reverse};
  car.footprint = cover_rectangle(size.length, size.width, 0.5 * size.length - 1.25, 0.5);
  RobotSetup robot;
  robot.position = position, robot.heading = heading, robot.goal = goal;
  robot.model = car;
  return robot;
}

double disc_radius_of(const RobotSetup& robot) {
  return std::get<Car>(robot.model).footprint.radius;
}

StaticObstacle wall(std::vector<Vec2> points) {
  return {.chains = {Chain{std::move(points), false}}};
}

StaticObstacle block(double left, double bottom, double right, double top) {
  return {{Chain{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, true}},
          0.0,
          Fill::solid};
}

struct Driven {
  double time = 0.0;  // s, of the last arrival, or of the end
  RunSummary summary;
  bool all_arrived = false;
};

Driven drive(Scenario scene, double most) {
  scene.duration = most;
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (!metrics.all_arrived() && simulation.time() < most) {
    simulation.step();
    metrics.observe(simulation);
  }
  return {simulation.time(), metrics.summary(), metrics.all_arrived()};
}

void expect_passes(const Scenario& scene, double most) {
  const Driven driven = drive(scene, most);
  EXPECT_TRUE(driven.all_arrived) << driven.summary.arrived << " arrived";
  EXPECT_EQ(driven.summary.collision_pairs, 0);
  EXPECT_EQ(driven.summary.static_collisions, 0);
}

// Two trucks in a lane of that half-width, at -+aside.
Scenario meeting(TruckSize size, double half, double aside, bool reverse = true) {
  Scenario scene;
  scene.obstacles = {wall({{-60.0, half}, {60.0, half}}), wall({{-60.0, -half}, {60.0, -half}})};
  scene.robots = {truck({-18.0, -aside}, 0.0, {18.0, -aside}, size, reverse),
                  truck({18.0, aside}, kLeft, {-18.0, aside}, size, reverse)};
  return scene;
}

// The lane aims at a place 3 radii ahead, and a straight line from there on leads into the wall.
TEST(Trucks, two_pass_in_a_lane) {
  for (const TruckSize size : {TruckSize{4.0, 1.5}, {6.0, 2.0}, {9.0, 2.5}}) {
    const double contact = 2.0 * disc_radius_of(truck({}, 0.0, {}, size));
    for (const double part : {1.15, 1.5}) {
      for (const bool reverse : {true, false}) {
        SCOPED_TRACE(std::to_string(size.length) + " m, " + std::to_string(part) +
                     (reverse ? ", with reverse" : ""));
        const double half = part * contact;
        expect_passes(meeting(size, half, 0.5 * half, reverse), 40.0);
      }
    }
  }
}

TEST(Trucks, two_pass_that_meet_head_on) {
  for (const double half : {3.5, 4.2, 5.0}) {
    SCOPED_TRACE(half);
    expect_passes(meeting({6.0, 2.0}, half, 0.0), 40.0);
  }
}

// The scenes of the table of jams in the page.
TEST(Trucks, two_pass_between_walls_that_leave_more_room) {
  for (const double between : {3.2, 3.4, 3.6}) {
    for (const double beside : {1.8, 2.2, 2.9}) {
      SCOPED_TRACE(std::to_string(between) + ", " + std::to_string(beside));
      expect_passes(meeting({6.0, 2.0}, 0.5 * between + beside, 0.5 * between), 40.0);
    }
  }
}

// The goals of the trucks of one lane are 8 m apart: nearer than two discs that cover a truck.
TEST(Trucks, rows_of_two_pass_and_stop_one_behind_the_other) {
  for (const double half : {3.6, 4.2, 5.0}) {
    SCOPED_TRACE(half);
    Scenario scene = meeting({6.0, 2.0}, half, 0.5 * half);
    scene.robots[0].goal.x = 26.0, scene.robots[1].goal.x = -26.0;
    scene.robots.push_back(truck({-26.0, -0.5 * half}, 0.0, {18.0, -0.5 * half}));
    scene.robots.push_back(truck({26.0, 0.5 * half}, kLeft, {-18.0, 0.5 * half}));
    expect_passes(scene, 50.0);
  }
}

// Beyond the corner a straight line leads into the outer wall.
Scenario corner(double half) {
  Scenario scene;
  scene.obstacles = {wall({{-40.0, -half}, {half, -half}, {half, 40.0}}),
                     wall({{-40.0, half}, {-half, half}, {-half, 40.0}})};
  scene.robots = {truck({-25.0, -0.5 * half}, 0.0, {0.5 * half, 25.0})};
  return scene;
}

TEST(Trucks, one_turns_a_corner) {
  for (const double width : {7.0, 8.0, 10.0}) {
    SCOPED_TRACE(width);
    expect_passes(corner(0.5 * width), 40.0);
  }
}

// The discs that cover them overlap, and would push them back.
TEST(Trucks, two_meet_at_a_corner) {
  Scenario scene = corner(5.0);
  scene.robots.push_back(truck({-2.5, 25.0}, -0.5 * kLeft, {-25.0, 2.5}));
  expect_passes(scene, 60.0);
}

RobotSetup forklift(Vec2 position, double heading, Vec2 goal) {
  DifferentialDrive drive{.track = 1.0, .offset = 0.5, .wheel_speed = 1.5};
  drive.footprint = cover_rectangle(2.4, 1.1, 0.3, 0.3);
  RobotSetup robot;
  robot.position = position, robot.heading = heading, robot.goal = goal;
  robot.model = drive;
  robot.max_speed = robot.preferred_speed = 1.5;
  robot.max_acceleration = 0.5 * most_acceleration(drive);
  return robot;
}

// Its rear swings into the wall where it turns on the spot, so it first drives straight.
TEST(Forklifts, one_turns_beside_a_wall) {
  for (const double heading : {0.0, 0.1, -0.1, 1.6, -1.6, 3.0}) {
    for (const double beside : {0.9, 1.0, 1.3}) {
      SCOPED_TRACE(std::to_string(heading) + ", " + std::to_string(beside));
      Scenario scene;
      const RobotSetup robot = forklift({}, heading, {});
      double low = 0.0;  // m, of the lowest disc
      for (const Disc& disc : discs_at(robot, {}, heading)) low = std::min(low, disc.center.y);
      scene.obstacles = {wall({{-30.0, 0.0}, {30.0, 0.0}})};
      scene.robots = {forklift({0.0, beside - low}, heading, {-9.0, 4.0})};
      expect_passes(scene, 40.0);
    }
  }
}

TEST(Forklifts, two_pass_a_door) {
  for (const double door : {2.2, 2.8, 3.5, 4.5}) {
    SCOPED_TRACE(door);
    Scenario scene;
    const double half = 0.5 * door;
    scene.obstacles = {block(-0.2, half, 0.2, 12.0), block(-0.2, -12.0, 0.2, -half)};
    scene.robots = {forklift({-8.0, 0.0}, 0.0, {8.0, 0.0}),
                    forklift({8.0, 0.0}, kLeft, {-8.0, 0.0})};
    expect_passes(scene, 90.0);
  }
}

// The disc that covers the truck at any heading reaches twice as far aside.
TEST(Trucks, stay_where_movers_pass_their_discs) {
  Scenario scene;
  scene.robots = {truck({}, 0.0, {})};
  MovingObstacle walker;
  walker.position = {12.0, 2.4}, walker.velocity = {-1.2, 0.0}, walker.radius = 0.3;
  scene.moving_obstacles = {walker};
  Simulation simulation(scene, 1);
  while (simulation.time() < 20.0) {
    simulation.step();
    ASSERT_EQ(simulation.fleet().position[0], (Vec2{})) << simulation.time() << " s";
  }
}

TEST(Trucks, alone_among_movers_are_not_touched) {
  Random random(40);
  for (int trial = 0; trial < 16; ++trial) {
    SCOPED_TRACE(trial);
    Scenario scene;
    scene.robots = {trial % 2 == 0 ? truck({-18.0, 0.0}, 0.0, {18.0, 0.0})
                                   : forklift({-18.0, 0.0}, 0.0, {18.0, 0.0})};
    while (scene.moving_obstacles.size() < 4) {
      MovingObstacle mover;
      mover.velocity = random.uniform(0.5, 2.0) * random.direction();
      const Vec2 meets{random.uniform(-12.0, 12.0), random.uniform(-4.0, 4.0)};
      mover.position = meets - random.uniform(5.0, 16.0) * mover.velocity;
      mover.radius = random.uniform(0.3, 1.0);
      if (norm(mover.position - scene.robots[0].position) > 8.0)
        scene.moving_obstacles.push_back(mover);
    }
    const Driven driven = drive(scene, 90.0);
    EXPECT_TRUE(driven.all_arrived);
    EXPECT_EQ(driven.summary.mover_collisions, 0);
  }
}

}  // namespace
}  // namespace avo::test
