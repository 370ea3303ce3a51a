// SPDX-License-Identifier: Apache-2.0
// Differential drives in whole runs: goals, crowds, walls. Each step of each wheel is looked at by
// support/wheels.h, and places by distances of discs.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "support/wheels.h"

namespace avo {
namespace {

using test::AxleState;
using test::Random;
using test::WheelUse;

constexpr DifferentialDrive kDrive{
    .track = 0.4, .offset = 0.2, .wheel_speed = 1.2, .wheel_acceleration = 2.0};

RobotSetup drive_at(Vec2 position, Vec2 goal, double heading) {
  RobotSetup setup;
  setup.position = position, setup.goal = goal, setup.heading = heading;
  setup.radius = 0.3, setup.model = kDrive;
  setup.max_speed = setup.preferred_speed = kDrive.wheel_speed;
  setup.max_acceleration = 0.5 * most_acceleration(kDrive);
  return setup;
}

// This simulation watches the wheels at 64 instants of each step, as the plans say that q
// accelerates.
class Watched {
 public:
  explicit Watched(const Scenario& scene)
      : simulation(scene, 1), metrics(scene), time_step(scene.time_step) {
    metrics.observe(simulation);
  }

  void step() {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> position(before.position.begin(), before.position.end());
    const std::vector<Vec2> velocity(before.velocity.begin(), before.velocity.end());
    const std::vector<double> heading(before.heading.begin(), before.heading.end());
    simulation.step();
    metrics.observe(simulation);
    const FleetView after = simulation.fleet();
    for (std::size_t k = 0; k < position.size(); ++k) {
      const auto* drive = std::get_if<DifferentialDrive>(&after.setup[k].model);
      if (drive == nullptr) continue;
      const Vec2 center = disc_center(*drive, position[k], heading[k]);
      AxleState axle = test::axle_of(*drive, center, velocity[k], heading[k]);
      WheelUse use = integrate(*drive, axle, after.plan[k].acceleration, time_step, 64);
      use.speed /= drive->wheel_speed, use.acceleration /= drive->wheel_acceleration;
      worst.take(use);
      off = std::max(off, norm(Vec2{axle.x, axle.y} - after.position[k]));
      off = std::max(
          off, std::abs(std::remainder(axle.heading - after.heading[k], 2.0 * std::numbers::pi)));
      fastest = std::max(fastest, norm(after.velocity[k]) / after.setup[k].max_speed);
    }
  }
  void run(double seconds) {
    const double end = simulation.time() + seconds - 1e-9;
    while (simulation.time() < end) step();
  }
  void expect_limits() const {
    EXPECT_LE(worst.speed, 1.0);
    EXPECT_LE(worst.acceleration, 1.0);
    EXPECT_LE(fastest, 1.0 + 1e-9);
    EXPECT_LT(off, 1e-6) << "what is reported is where the wheels lead to";
  }

  Simulation simulation;
  Metrics metrics;
  double time_step;  // s
  WheelUse worst;    // of their limits
  double off = 0.0, fastest = 0.0;
};

TEST(DriveRuns, come_to_goals_all_around_and_rest_there) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    for (int k = 0; k < 16; ++k) {
      const double angle = k * std::numbers::pi / 8.0;
      for (const double far : {0.6, 3.0, 10.0}) {
        Scenario scene;
        scene.method = method;
        scene.robots = {
            drive_at({1, 2}, Vec2{1, 2} + far * Vec2{std::cos(angle), std::sin(angle)}, 0.0)};
        Watched run(scene);
        run.run(20.0 + 2.0 * far);
        const FleetView fleet = run.simulation.fleet();
        EXPECT_LT(norm(fleet.position[0] - fleet.goal[0]), 0.1) << to_string(method) << k << far;
        EXPECT_LT(norm(fleet.velocity[0]), method == Method::avo ? 1e-3 : 0.05)
            << to_string(method) << ' ' << k << ' ' << far;
        run.expect_limits();
      }
    }
  }
}

// Beside the axle, a velocity across the heading of now led round the goal for ever.
TEST(DriveRuns, come_to_goals_beside_their_axles_and_rest_there) {
  for (const auto& [offset, far] : {std::pair{0.2, 0.02}, std::pair{0.2, 0.1}, std::pair{0.2, 0.35},
                                    std::pair{0.6, 0.1}, std::pair{0.6, 0.9}}) {
    Scenario scene;
    scene.arrival_distance = 0.02;
    for (int k = 0; k < 32; ++k) {
      const double angle = k * std::numbers::pi / 16.0;
      RobotSetup setup;
      setup.position = {10.0 * k, 0.0};
      setup.goal = setup.position + far * Vec2{std::cos(angle), std::sin(angle)};
      const DifferentialDrive drive{.offset = offset};
      setup.radius = 0.3, setup.model = drive;
      setup.max_acceleration = 0.5 * most_acceleration(drive);
      scene.robots.push_back(setup);
    }
    Simulation simulation(scene, 1);
    while (simulation.time() < 20.0) simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < fleet.position.size(); ++k) {
      EXPECT_LE(norm(fleet.position[k] - fleet.goal[k]), 0.01) << offset << far << ' ' << k;
      EXPECT_EQ(fleet.velocity[k], Vec2{}) << offset << far << ' ' << k;
    }
  }
}

// The goal is behind it: it turns about its axle first.
TEST(DriveRuns, turn_before_they_drive_a_long_way) {
  Scenario scene;
  scene.robots = {drive_at({}, {-8, 0}, 0.0)};
  Watched run(scene);
  run.run(3.0);
  EXPECT_LT(std::cos(run.simulation.fleet().heading[0]), -0.9);
  run.run(9.0);
  EXPECT_TRUE(run.simulation.all_at_goal());
}

// Drives and holonomic robots, and where `cars` also cars, on a lattice.
Scenario crowd(int side, double spacing, Method method, std::uint64_t seed, bool to_one_point) {
  Random random(seed);
  Scenario scene;
  scene.method = method;
  scene.sensing_radius = 10.0;
  scene.allow_broken_assumptions = true;  // the fastest should see each other from farther away
  for (int k = 0; k < side * side; ++k) {
    const Vec2 place{spacing * (k % side), spacing * (k / side)};
    const double extent = spacing * side;
    Vec2 goal{random.uniform(0.0, extent), random.uniform(0.0, extent)};
    if (to_one_point) goal = Vec2{extent, extent} - place;
    RobotSetup setup = drive_at(place, goal, random.uniform(-3.1, 3.1));
    if (k % 4 == 1) {
      setup.model = Holonomic{}, setup.radius = random.uniform(0.3, 0.5);
      setup.max_acceleration = random.uniform(0.5, 2.0);
    } else if (k % 4 == 3) {
      setup.model = Car{.wheelbase = 0.5}, setup.radius = 0.45;
      setup.max_acceleration = random.uniform(0.5, 1.5);
    } else {
      DifferentialDrive drive{.track = random.uniform(0.2, 0.6),
                              .offset = random.uniform(0.05, 0.3),
                              .wheel_speed = random.uniform(0.6, 2.0),
                              .wheel_acceleration = random.uniform(1.0, 4.0)};
      setup.model = drive, setup.radius = random.uniform(0.15, 0.5 - drive.offset);
      setup.max_speed = setup.preferred_speed = drive.wheel_speed;
      setup.max_acceleration = random.uniform(0.2, 0.9) * most_acceleration(drive);
    }
    scene.robots.push_back(setup);
  }
  return scene;
}

TEST(DriveRuns, keep_apart_in_a_crush_of_mixed_kinds) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Watched run(crowd(7, 1.8, Method::avo, seed, true));
    run.run(40.0);
    EXPECT_EQ(run.metrics.summary().collision_pairs, 0);
    EXPECT_LT(*run.metrics.summary().min_clearance, 0.01) << "a crush";
    run.expect_limits();
    EXPECT_GT(run.worst.acceleration, 0.85);
  }
}

// Without a certificate, and where velocities are adopted at once.
TEST(DriveRuns, keep_their_wheels_limits_by_every_method) {
  for (const Method method :
       {Method::avo_paper, Method::orca, Method::velocity_obstacle, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    Watched run(crowd(4, 2.0, method, 4, false));
    run.run(20.0);
    run.expect_limits();
    if (method == Method::orca) {
      EXPECT_GT(run.worst.acceleration, 0.9);
    }
  }
}

TEST(DriveRuns, keep_their_wheels_limits_without_a_certificate_and_while_motion_is_exponential) {
  Scenario scene = crowd(4, 2.0, Method::avo, 4, false);
  scene.certificate = Certificate::none;
  scene.motion = Motion::exponential;
  Watched run(scene);
  run.run(20.0);
  run.expect_limits();
  EXPECT_GT(run.worst.acceleration, 0.7);
}

TEST(DriveRuns, find_ways_around_walls_and_touch_none) {
  Scenario scene;
  scene.obstacles = {{{Chain{{{0, -4}, {0, 4}}}}, 0.1},
                     {{Chain{{{-4, 1}, {-1.2, 1}, {-1.2, -2}}}}, 0.0}};
  for (int k = 0; k < 4; ++k)
    scene.robots.push_back(drive_at({-3.0, -1.0 - 1.5 * k}, {3.0, 1.0 - 1.5 * k}, 2.0 * k));
  Watched run(scene);
  run.run(60.0);
  EXPECT_TRUE(run.simulation.all_at_goal());
  EXPECT_EQ(run.metrics.summary().collision_pairs, 0);
  EXPECT_EQ(run.metrics.summary().static_collisions, 0);
  EXPECT_LT(*run.metrics.summary().min_static_clearance, 0.3);
  run.expect_limits();
}

// Straight to one corner of a room after the other, or to the one across, past walls and along
// them.
TEST(DriveRuns, touch_no_wall_in_a_crush_of_mixed_kinds) {
  for (const bool ways : {false, true}) {
    Scenario scene = crowd(5, 1.8, Method::avo, 6, true);
    scene.navigation = ways;
    scene.obstacles = {{{Chain{{{-2, -2}, {10, -2}, {10, 10}, {-2, 10}}, true}}, 0.0, Fill::bounds},
                       {{Chain{{{4.5, 4.5}, {4.5, 6.3}}}}, 0.05},
                       {{Chain{{{0.9, 0.9}}}}, 0.2}};
    Watched run(scene);
    for (const Vec2 goal : {Vec2{9, 9}, Vec2{-1, 9}, Vec2{5.5, 4}, Vec2{0, 0}}) {
      for (const RobotId robot :
           std::vector(run.simulation.fleet().id.begin(), run.simulation.fleet().id.end()))
        run.simulation.set_goal(robot, robot.value % 2 == 0 ? goal : Vec2{8, 8} - goal);
      run.run(15.0);
    }
    EXPECT_EQ(run.metrics.summary().collision_pairs, 0);
    EXPECT_EQ(run.metrics.summary().static_collisions, 0);
    EXPECT_LT(*run.metrics.summary().min_static_clearance, 0.01);
    run.expect_limits();
    EXPECT_GT(run.worst.acceleration, 0.85);
  }
}

TEST(DriveRuns, continue_from_saved_bytes_with_their_setups) {
  Scenario scene = crowd(3, 1.5, Method::avo, 5, false);
  scene.robots[0].radius = 0.1 + 0.2;  // which r + L - L is not
  Simulation whole(scene, 1);
  for (int k = 0; k < 30; ++k) whole.step();
  Simulation resumed(whole.save());
  EXPECT_EQ(resumed.fleet().setup[0].model, scene.robots[0].model);
  EXPECT_EQ(resumed.fleet().setup[0].radius, 0.1 + 0.2);
  EXPECT_EQ(resumed.state_hash(), whole.state_hash());
  for (int k = 0; k < 30; ++k) whole.step(), resumed.step();
  EXPECT_EQ(resumed.state_hash(), whole.state_hash());
}

TEST(DriveRuns, a_planner_on_board_says_what_the_wheels_can_do) {
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  Robot self;
  self.velocity = {0.4, 0.0}, self.preferred_velocity = {0.0, 1.0}, self.heading = 0.3;
  self.model = kDrive, self.max_speed = 1.2, self.max_acceleration = 0.7;
  const Plan plan = planner.plan(self, {}, workspace);
  EXPECT_EQ(plan.status == PlanStatus::invalid_input, false);
  AxleState axle = test::axle_of(kDrive, {}, self.velocity, self.heading);
  const WheelUse use = integrate(kDrive, axle, plan.acceleration, 0.1, 64);
  EXPECT_LE(use.acceleration, 2.0);
  EXPECT_LT(norm(plan.next_velocity - center_velocity(kDrive, axle)), 1e-6);
  self.max_acceleration = 1.42;  // more than the wheels can do in every direction
  EXPECT_EQ(planner.plan(self, {}, workspace).status, PlanStatus::invalid_input);
  self.max_acceleration = 0.7, self.max_speed = 1.3;
  EXPECT_EQ(planner.plan(self, {}, workspace).status, PlanStatus::invalid_input);
}

}  // namespace
}  // namespace avo
