// SPDX-License-Identifier: Apache-2.0
// Doors close right before robots of every model in motion. As near as the doors are accepted, no
// robot touches them.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "support/generators.h"
#include "unit/sim/judged.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::Judged;
using test::Random;

struct Kind {
  std::string name;
  MotionModel model;
};

std::vector<Kind> kinds() {
  const auto drive = [](double offset) {
    return DifferentialDrive{
        .track = 0.4, .offset = offset, .wheel_speed = 2.0, .wheel_acceleration = 3.0};
  };
  return {{"holonomic", Holonomic{}},
          {"car", Car{}},
          {"car with a body", Car{.max_curvature = 0.8, .body = CarBody{0.5, 0.6}}},
          {"car with the exact set", Car{.acceleration_set = AccelerationSet::exact}},
          {"reversing car", Car{.max_curvature = 0.8, .body = CarBody{-0.3, 0.5}, .reverse = true}},
          {"drive", drive(0.2)},
          {"long drive", drive(0.4)},
          {"airplane", Airplane{}}};
}

RobotSetup any_robot(Random& random, const MotionModel& model) {
  RobotSetup robot;
  robot.model = model;
  robot.heading = random.uniform(-3.0, 3.0);
  robot.radius = 0.3;
  robot.max_speed = 1.9;
  robot.preferred_speed = random.uniform(1.2, 1.9);
  robot.max_acceleration = 1.0;
  if (can_rest(model) && random.below(2) == 0) robot.max_braking = random.uniform(0.5, 1.0);
  robot.goal = 20.0 * random.direction();
  return robot;
}

// m, of straight braking in steps.
double braking_way(const RobotSetup& robot, double time_step) {
  const double u = robot.max_braking.value_or(robot.max_acceleration) * time_step;
  double way = 0.0, speed = norm(robot.velocity);
  while (speed > 0.0) {
    const double next = std::max(speed - u, 0.0);
    way += 0.5 * (speed + next) * time_step;
    speed = next;
  }
  return way;
}

// A wall of 0.6 m that lies across a direction, `gap` before the disc.
StaticObstacle door_at(const RobotSetup& robot, Vec2 direction, double gap) {
  const Vec2 middle = disc_center(robot.model, robot.position, robot.heading) +
                      (disc_radius(robot.model, robot.radius) + gap) * direction;
  const Vec2 half = 0.3 * perpendicular(direction);
  return test::pieces({{middle - half, middle + half}});
}

bool is_accepted(Simulation& simulation, const StaticObstacle& door) {
  try {
    simulation.remove_obstacle(simulation.add_obstacle(door));
    return true;
  } catch (const Error&) {
    return false;
  }
}

// m: the smallest that is accepted.
double least_gap(Simulation& simulation, const RobotSetup& robot, Vec2 direction) {
  double refused = 1e-6, accepted = 12.0;
  if (is_accepted(simulation, door_at(robot, direction, refused))) return refused;
  while (accepted - refused > 1e-9) {
    const double gap = 0.5 * (refused + accepted);
    (is_accepted(simulation, door_at(robot, direction, gap)) ? accepted : refused) = gap;
  }
  return accepted;
}

TEST(EditsByModel, a_door_is_refused_where_it_would_be_touched_and_nowhere_else) {
  Random random(14);
  for (const auto& [name, model] : kinds()) {
    SCOPED_TRACE(name);
    int off_heading = 0, at_limit = 0;
    for (int k = 0; k < 60; ++k) {
      Scenario scene;
      scene.navigation = false;
      scene.sensing_radius = 60.0;
      scene.robots = {any_robot(random, model)};
      Judged judged(scene, 1);
      Simulation& simulation = judged.simulation;
      for (int i = 1 + random.below(30); i > 0; --i) judged.step();
      simulation.set_goal({0}, simulation.fleet().position[0] + 20.0 * random.direction());
      for (int i = 1 + random.below(12); i > 0; --i) judged.step();
      const RobotSetup robot = simulation.fleet().setup[0];
      const double speed = norm(robot.velocity);
      if (!(speed > 0.1)) continue;
      const Vec2 moves = robot.velocity / speed;
      const Vec2 heading{std::cos(robot.heading), std::sin(robot.heading)};
      if (!is_holonomic(model) && std::abs(dot(moves, heading)) < 0.99) ++off_heading;
      const bool across_way = random.below(2) == 0;
      const Vec2 direction = across_way            ? moves
                             : is_holonomic(model) ? random.direction()
                                                   : heading;
      const double gap = least_gap(simulation, robot, direction);
      if (across_way && can_rest(model)) {
        EXPECT_NEAR(gap, braking_way(robot, scene.time_step), 1e-6) << "at " << speed << " m/s";
        ++at_limit;
      }
      simulation.add_obstacle(door_at(robot, direction, gap));
      for (int i = 0; i < 40; ++i) {
        judged.step();
        EXPECT_NE(simulation.fleet().plan[0].status, PlanStatus::overlapping) << "step " << i;
      }
      EXPECT_EQ(judged.report().static_contacts.count, 0)
          << "scene " << k << ": " << *judged.report().least_static_clearance << " m";
    }
    if (std::holds_alternative<DifferentialDrive>(model)) {
      EXPECT_GT(off_heading, 10);
    }
    if (can_rest(model)) {
      EXPECT_GT(at_limit, 15);
    }
  }
}

}  // namespace
}  // namespace avo
