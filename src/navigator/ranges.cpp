// SPDX-License-Identifier: Apache-2.0
// How far a robot on board has to see.
#include <algorithm>

#include "avo/error.h"
#include "avo/navigator.h"
#include "guidance/wall_needs.h"
#include "planner/stages/certify.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo::inline navigator {
namespace {

constexpr double kBillionth = 1e-9;

void require_valid(const Robot& robot) {
  Robot unled = robot;  // these two are not read
  unled.preferred_velocity = {}, unled.distance_to_goal = 0.0;
  if (!is_valid(unled)) throw Error("robot: found a value out of range, see Robot");
}

// s: braking from its top speed, and the step before.
double time_to_rest(const Robot& robot, const StepLaw& law) {
  return law.time_step * (1.0 + braking_steps(robot.max_speed, decrement_of(robot, law)));
}

// m: what the robot can do that A does not know yet, where each decides at its own times
// (docs/on_board.md, "Clocks").
double unknown_by_clocks(const Robot& other, const StepLaw& law) {
  if (!law.has_free_clocks()) return 0.0;
  const double step = law.time_step, longest = law.longest_step;
  const double late = std::max(step, 2.0 * longest - step);
  const double a = other.max_acceleration, b = braking_limit(other);
  return a * (late * (step + other.max_speed / b) + 0.5 * (a / b * late * late - step * step) +
              (step * step + longest * longest) / 8.0);
}

RobotSetup setup_of(const Robot& robot) {
  RobotSetup setup;
  setup.radius = robot.radius;
  setup.max_speed = setup.preferred_speed = robot.max_speed;
  setup.max_acceleration = robot.max_acceleration, setup.max_braking = robot.max_braking;
  setup.priority = robot.priority;
  return setup;
}

// The pair as a scene; a disc that its model makes larger is the robot's own already.
Scenario scene_of(const PlannerOptions& options, const Robot& robot, const Robot& other,
                  bool has_map) {
  Scenario scene;
  scene.method = options.method, scene.certificate = options.certificate;
  scene.time_step = options.time_step, scene.time_horizon = options.time_horizon;
  scene.robots = {setup_of(robot), setup_of(other)};
  if (has_map) scene.obstacles = {{{{{{0.0, 0.0}}}}}};
  return scene;
}

}  // namespace
}  // namespace avo::inline navigator

namespace avo {

double sensing_range(const PlannerOptions& options, const Robot& robot,
                     std::span<const Robot> others, bool has_map) {
  const StepLaw law = certificate_law(Planner(options)).step;
  require_valid(robot);
  double range = 0.0;
  for (const Robot& other : others) {
    require_valid(other);
    const double until_rest = std::max(time_to_rest(robot, law), time_to_rest(other, law));
    const auto faster_by = [](const Robot& one) {
      return (model_traits(one.model).speed_ratio - 1.0) * one.max_speed;
    };
    const double swing = faster_by(robot) + faster_by(other);
    const double unknown = options.sensing_error.position +
                           (options.sensing_error.velocity + swing) * until_rest +
                           unknown_by_clocks(other, law);
    range =
        std::max(range, needed_sensing_radius(scene_of(options, robot, other, has_map)) + unknown);
  }
  return range;
}

double wall_range(const PlannerOptions& options, const Robot& robot) {
  const Planner planner(options);
  require_valid(robot);
  WallNeeds needs;
  needs.include(robot, traits_of(robot, robot.max_speed), planner);
  return (1.0 + kBillionth) * needs.reach;
}

}  // namespace avo
