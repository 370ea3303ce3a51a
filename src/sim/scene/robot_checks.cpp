// SPDX-License-Identifier: Apache-2.0
// Which robots a scene may have: ranges of their values, and the demands of their motion models.
#include <string>
#include <string_view>
#include <variant>

#include "robots/model.h"
#include "robots/motion.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

std::string list_of(LayerSet set) {
  std::string list("[");
  for (int k = 0; k < 32; ++k) {
    if ((set.bits >> k & 1U) == 0) continue;
    if (list.size() > 1) list.append(", ");
    list.append(std::to_string(k));
  }
  return list.append("]");
}

// A parked robot has arrived where it stands.
void check_parked(std::size_t i, const RobotSetup& robot) {
  if (!(robot.goal == robot.position))
    refuse(std::string(Place{"robots", i, "goal"}), text(robot.goal),
           text(robot.position) + ", its position: it is parked");
  if (!(robot.velocity == Vec2{}))
    refuse(std::string(Place{"robots", i, "velocity"}), text(robot.velocity),
           "[0, 0]: it is parked");
  const RobotSetup usual;
  const auto require_usual = [&](std::string_view field, LayerSet found, LayerSet left_out) {
    if (!(found == left_out))
      refuse(std::string(Place{"robots", i, field}), list_of(found),
             "left out: it is parked, and nobody may touch it");
  };
  require_usual("layers", robot.layers, usual.layers);
  require_usual("avoids", robot.avoids, usual.avoids);
  if (robot.behavior != usual.behavior)
    refuse(std::string(Place{"robots", i, "behavior"}), to_string(robot.behavior),
           "left out: it is parked, and does nothing");
}

void check_car(std::size_t i, const Car& car) {
  const std::string_view list = "robots";
  require(Place{list, i, "car.wheelbase"}, car.wheelbase, kPositive, "m");
  if (car.max_curvature)
    require(Place{list, i, "car.max_curvature"}, *car.max_curvature, kPositive, "1/m");
  if (!car.body) return;
  require(Place{list, i, "car.body.offset"}, car.body->offset, kAnyValue, "m");
  require(Place{list, i, "car.body.radius"}, car.body->radius, kPositive, "m");
}

void check_drive(std::size_t i, const RobotSetup& robot, const DifferentialDrive& drive) {
  const std::string_view list = "robots";
  require(Place{list, i, "drive.track"}, drive.track, kPositive, "m");
  require(Place{list, i, "drive.offset"}, drive.offset, kPositive, "m");
  require(Place{list, i, "drive.wheel_speed"}, drive.wheel_speed, kPositive, "m/s");
  require(Place{list, i, "drive.wheel_acceleration"}, drive.wheel_acceleration, kPositive, "m/s^2");
  if (robot.max_speed > drive.wheel_speed)
    refuse(std::string(Place{list, i, "max_speed"}), text(robot.max_speed),
           "<= " + text(drive.wheel_speed) + " m/s, its drive.wheel_speed");
  const double most = most_acceleration(drive);
  const auto require_less = [&](std::string_view field, double found) {
    if (!(found < most))
      refuse(std::string(Place{list, i, field}), text(found),
             "< " + text(most) + " m/s^2, wheel_acceleration/sqrt(1 + (track/(2 offset))^2)");
  };
  require_less("max_acceleration", robot.max_acceleration);
  require_less("max_braking", braking_limit(robot));
  if (norm(robot.velocity) > drive.wheel_speed)
    refuse(std::string(Place{list, i, "velocity"}), text(norm(robot.velocity)) + " m/s",
           "<= " + text(drive.wheel_speed) + " m/s, its drive.wheel_speed");
}

// For the promise to others, see docs/certificate/airplanes.md.
void check_flight(std::size_t i, const RobotSetup& robot, const Airplane& model, double time_step) {
  constexpr double kOff = 1e-9;  // of a speed: error of the length of a vector of that speed
  const std::string_view list = "robots";
  const auto at = [&](std::string_view field) { return std::string(Place{list, i, field}); };
  require(Place{list, i, "airplane.min_speed"}, model.min_speed, kPositive, "m/s");
  require(Place{list, i, "airplane.lateral_acceleration"}, model.lateral_acceleration, kPositive,
          "m/s^2");
  if (model.min_speed > robot.max_speed)
    refuse(at("airplane.min_speed"), text(model.min_speed),
           "<= max_speed = " + text(robot.max_speed) + " m/s");
  const double most = kMostTurn * model.min_speed / time_step;
  if (model.lateral_acceleration > most)
    refuse(at("airplane.lateral_acceleration"), text(model.lateral_acceleration),
           "<= " + text(most) + " m/s^2, 3 rad in a step at min_speed");
  const double speed = norm(robot.velocity);
  if (speed > 0.0 &&
      !(speed >= (1.0 - kOff) * model.min_speed && speed <= (1.0 + kOff) * robot.max_speed))
    refuse(at("velocity"), text(speed) + " m/s",
           text(model.min_speed) + " to " + text(robot.max_speed) +
               " m/s, or left out: preferred_speed");
  if (robot.max_braking)
    refuse(at("max_braking"), text(*robot.max_braking),
           "left out: it is an airplane, which cannot brake");
  if (robot.parked) refuse(at("parked"), "true", "false: it is an airplane");
}

}  // namespace

void check_robot(std::size_t i, const RobotSetup& robot, double time_step) {
  const std::string_view list = "robots";
  require(Place{list, i, "position"}, robot.position, "m");
  require(Place{list, i, "velocity"}, robot.velocity, "m/s");
  require(Place{list, i, "goal"}, robot.goal, "m");
  require(Place{list, i, "radius"}, robot.radius, kPositive, "m");
  require(Place{list, i, "max_speed"}, robot.max_speed, kPositive, "m/s");
  require(Place{list, i, "max_acceleration"}, robot.max_acceleration, kPositive, "m/s^2");
  require(Place{list, i, "preferred_speed"}, robot.preferred_speed, kNotNegative, "m/s");
  require(Place{list, i, "priority"}, robot.priority, kPositive, "");
  if (robot.max_braking)
    require(Place{list, i, "max_braking"}, *robot.max_braking, kPositive, "m/s^2");
  if (robot.time_horizon)
    require(Place{list, i, "time_horizon"}, *robot.time_horizon, kPositive, "s");
  if (robot.arrival_distance)
    require(Place{list, i, "arrival_distance"}, *robot.arrival_distance, kPositive, "m");
  if (robot.parked) check_parked(i, robot);
  require(Place{list, i, "heading"}, robot.heading, kAngle, "rad");
  check_footprint(i, robot);
  if (const Car* car = std::get_if<Car>(&robot.model)) check_car(i, *car);
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot.model))
    check_drive(i, robot, *drive);
  if (const Airplane* model = std::get_if<Airplane>(&robot.model))
    check_flight(i, robot, *model, time_step);
}

}  // namespace avo::inline sim
