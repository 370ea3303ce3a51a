// SPDX-License-Identifier: Apache-2.0
// Turns a scene and its simulation into the types of the judge of recorded motion.
#include "avo/checked.h"

#include <cstddef>
#include <limits>

#include "core/elementary.h"
#include "robots/execution_bounds.h"
#include "robots/footprint.h"

namespace avo {
namespace {

CheckedHolonomic kinematics_of(const Holonomic& /*any*/) {
  return {};
}

CheckedCar kinematics_of(const Car& car) {
  return {.wheelbase = car.wheelbase,
          .max_curvature = car.max_curvature.value_or(std::numeric_limits<double>::infinity()),
          .body_offset = car.body ? car.body->offset : 0.0,
          .reverse = car.reverse,
          .exact_set = car.acceleration_set == AccelerationSet::exact};
}

CheckedDrive kinematics_of(const DifferentialDrive& drive) {
  return {.track = drive.track,
          .offset = drive.offset,
          .wheel_speed = drive.wheel_speed,
          .wheel_acceleration = drive.wheel_acceleration};
}

CheckedAirplane kinematics_of(const Airplane& model) {
  return {.min_speed = model.min_speed, .lateral_acceleration = model.lateral_acceleration};
}

// m, from the position of a robot with a footprint forward to the centers of its discs.
std::vector<double> judged_discs(const MotionModel& model) {
  const Footprint* footprint = own_footprint(model);
  std::vector<double> discs;
  for (int k = 0; footprint != nullptr && k < footprint->discs; ++k)
    discs.push_back(footprint->ahead(k));
  return discs;
}

// m: a drive is judged by its own disc, about its axle; the disc that others sense contains it.
double judged_radius(const RobotSetup& robot) {
  const Footprint footprint = footprint_of(robot.model);
  if (footprint) return footprint.radius;
  const bool drives = std::holds_alternative<DifferentialDrive>(robot.model);
  return drives ? robot.radius : disc_radius(robot);
}

}  // namespace

CheckedRobot checked_robot(const RobotSetup& robot) {
  return {
      .radius = judged_radius(robot),
      .max_acceleration = robot.max_acceleration,
      .max_speed = robot.max_speed,
      .goal = robot.goal,
      .arrival_distance = robot.arrival_distance,
      .kinematics = std::visit(
          [](const auto& model) -> CheckedKinematics { return kinematics_of(model); }, robot.model),
      .parked = is_parked(robot),
      .layers = robot.layers.bits,
      .avoids = robot.avoids.bits,
      .max_braking = robot.max_braking,
      .discs = judged_discs(robot.model)};
}

namespace {

// Where it is judged, a body may be faster than its reference, and no acceleration is promised. For
// a drive the disc about the point ahead of its axle is judged, which covers it at any heading.
void judge_body(const Scenario& scenario, const RobotSetup& setup, CheckedRobot& robot) {
  const ExecutionModel& model = *scenario.execution;
  const ExecutionLimits limits = limits_of(setup);
  robot.max_speed += bounds_of(model, setup.model, limits, scenario.time_step).velocity;
  robot.max_acceleration = std::numeric_limits<double>::infinity();
  robot.max_braking.reset();
  robot.interpolation_error = off_cubic(model, setup.model, limits, scenario.time_step);
  robot.largest_jump = 4.0 * robot.interpolation_error;
  if (const auto* drive = std::get_if<DifferentialDrive>(&setup.model))
    robot.kinematics = CheckedHolonomic{}, robot.radius = disc_radius(setup),
    robot.discs = {drive->offset};
}

// Exponential motion, Eqs. (8), (9), has |x''''| <= most/δ², and a cubic through positions and
// velocities errs by at most Δt⁴ |x''''|/384.
double off_cubic_of_response(const Scenario& scenario, const RobotSetup& setup) {
  const PlannerOptions options = planner_options(scenario, setup);
  const double ratio = options.time_step / options.control_time;
  return ratio * ratio * options.time_step * options.time_step * change_limit(setup) / 384.0;
}

}  // namespace

CheckedRobot checked_robot(const Scenario& scenario, const RobotSetup& setup) {
  CheckedRobot robot = checked_robot(setup);
  if (is_holonomic(setup.model)) {
    robot.straight = adopts_at_once(method_of(scenario, setup));
    if (scenario.motion != Motion::held && !robot.straight)
      robot.interpolation_error = off_cubic_of_response(scenario, setup);
  }
  if (scenario.execution) judge_body(scenario, setup, robot);
  if (scenario.clock == Clock::free && !robot.parked && !robot.straight)
    robot.time_step = time_step_of(scenario, setup);
  return robot;
}

CheckedState checked_state(const FleetView& fleet, std::size_t robot) {
  CheckedState state{static_cast<std::int64_t>(fleet.id[robot].value), fleet.position[robot],
                     fleet.velocity[robot]};
  if (is_holonomic(fleet.setup[robot].model)) return state;
  const double along = dot(elementary::direction(fleet.heading[robot]), state.velocity);
  state.heading = CheckedHeading{fleet.heading[robot], along + 0.0};  // no negative zero
  return state;
}

std::vector<CheckedState> checked_states(const FleetView& fleet) {
  std::vector<CheckedState> states;
  states.reserve(fleet.id.size());
  for (std::size_t k = 0; k < fleet.id.size(); ++k) states.push_back(checked_state(fleet, k));
  return states;
}

}  // namespace avo
