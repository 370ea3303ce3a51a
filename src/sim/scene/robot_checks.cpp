// SPDX-License-Identifier: Apache-2.0
// Which robots a scene may have: ranges of their values, and the demands of their motion models.
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "fields/model_fields.h"
#include "fields/robot_fields.h"
#include "robots/model.h"
#include "robots/motion.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

std::string found(LayerSet set) {
  std::string list("[");
  for (int k = 0; k < 32; ++k) {
    if ((set.bits >> k & 1U) == 0) continue;
    if (list.size() > 1) list.append(", ");
    list.append(std::to_string(k));
  }
  return list.append("]");
}

template <typename Value>
std::string found(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return to_string(value);
  else
    return text(value);
}
template <typename Value>
std::string found(const std::optional<Value>& value) {
  return value ? found(*value) : "none";
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
  for_each_member(kFields<RobotSetup>, [&](const RobotField& field, auto member) {
    if (field.whose == Whose::deciding && !(robot.*member == usual.*member))
      refuse(std::string(Place{"robots", i, field.key}), found(robot.*member),
             "left out: it is parked");
  });
}

void check_model(std::size_t /*i*/, const RobotSetup& /*robot*/, double /*time_step*/,
                 const Holonomic& /*any*/) {}

void check_model(std::size_t i, const RobotSetup& /*robot*/, double /*time_step*/, const Car& car) {
  require_ranges(car, PlaceOf{"robots", i, "car."});
  if (car.body) require_ranges(*car.body, PlaceOf{"robots", i, "car.body."});
}

void check_model(std::size_t i, const RobotSetup& robot, double /*time_step*/,
                 const DifferentialDrive& drive) {
  const std::string_view list = "robots";
  require_ranges(drive, PlaceOf{list, i, "drive."});
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

// For the promise to others, see robots/flight.h.
void check_model(std::size_t i, const RobotSetup& robot, double time_step, const Airplane& model) {
  constexpr double kOff = 1e-9;  // of a speed: error of the length of a vector of that speed
  const std::string_view list = "robots";
  const auto at = [&](std::string_view field) { return std::string(Place{list, i, field}); };
  const PlaceOf own{list, i, "airplane."};
  require_ranges(model, own);
  if (model.min_speed > robot.max_speed)
    refuse(std::string(own("min_speed")), text(model.min_speed),
           "<= max_speed = " + text(robot.max_speed) + " m/s");
  const double most = kMostTurn * model.min_speed / time_step;
  if (model.lateral_acceleration > most)
    refuse(std::string(own("lateral_acceleration")), text(model.lateral_acceleration),
           "<= " + text(most) + " m/s^2, 3 rad in a step at min_speed");
  const double speed = norm(robot.velocity);
  if (speed > 0.0 &&
      !(speed >= (1.0 - kOff) * model.min_speed && speed <= (1.0 + kOff) * robot.max_speed))
    refuse(at("velocity"), text(speed) + " m/s",
           text(model.min_speed) + " to " + text(robot.max_speed) +
               " m/s, or left out: preferred_speed");
  if (robot.max_braking)
    refuse(at("max_braking"), text(*robot.max_braking), "left out: it cannot brake");
  if (is_parked(robot)) refuse(at("behavior"), "parked", "another one: it cannot stop");
  if (robot.start_time != 0.0)
    refuse(at("start_time"), text(robot.start_time), "left out: it cannot wait at its start");
}

}  // namespace

void check_robot(std::size_t i, const RobotSetup& robot, double time_step) {
  require_ranges(robot, PlaceOf{"robots", i});
  if (is_parked(robot)) check_parked(i, robot);
  require(Place{"robots", i, "heading"}, robot.heading, kAngle, "rad");
  check_footprint(i, robot);
  std::visit([&](const auto& model) { check_model(i, robot, time_step, model); }, robot.model);
}

}  // namespace avo::inline sim
