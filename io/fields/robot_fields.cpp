// SPDX-License-Identifier: Apache-2.0
// The table of fields for a robot and its motion model.
#include "avo_io/robot_fields.h"

#include <type_traits>

#include "io/fields/fields.h"

namespace avo_io {

using avo::Airplane;
using avo::Car;
using avo::CarBody;
using avo::DifferentialDrive;
using avo::kAnyValue;
using avo::kNotNegative;
using avo::kPositive;
using avo::RobotSetup;

template <>
const std::vector<Field<RobotSetup>>& fields() {
  static const std::vector<Field<RobotSetup>> table{
      {"position", &RobotSetup::position, kRequired, kAnyValue, "m", "where it starts"},
      {"velocity", &RobotSetup::velocity, kOptional, kAnyValue, "m/s",
       "at the start; of one with a heading its length counts, along it"},
      {"goal", &RobotSetup::goal, kRequired, kAnyValue, "m", "where it wants to come to rest"},
      {"radius", &RobotSetup::radius, kOptional, kPositive, "m", "of its disc"},
      {"max_speed", &RobotSetup::max_speed, kOptional, kPositive, "m/s", "never exceeded",
       "2; of a differential drive its wheel_speed"},
      {"max_acceleration", &RobotSetup::max_acceleration, kOptional, kPositive, "m/s^2",
       "never exceeded",
       "1; of a differential drive half of what its wheels can do in any direction"},
      {"preferred_speed", &RobotSetup::preferred_speed, kOptional, kNotNegative, "m/s",
       "towards the goal", "max_speed"},
      {"model", kNested, kOptional, kNoNumber, "", "how it moves",
       "the one whose keys there are, else holonomic"},
      {"heading", kNested, kOptional, kHeadingField.range, kHeadingField.unit, kHeadingField.doc,
       "0"},
      {"car", kNested, kOptional, kNoNumber, "", "a car's own; its position is its rear axle"},
      {"drive", kNested, kOptional, kNoNumber, "",
       "a differential drive's own; its position is the middle of its axle"},
      {"airplane", kNested, kOptional, kNoNumber, "", "an airplane's own; it cannot stop"},
      {"footprint", kNested, kOptional, kNoNumber, "",
       "its body where that is no disc, of a car or a drive: up to five discs cover it",
       "that of radius, or of car.body"},
      {"priority", &RobotSetup::priority, kOptional, kPositive, "",
       "of a pair, A takes the part p_B/(p_A + p_B) of what both have to do, 1/64 to 63/64 of it"},
      {"max_braking", &RobotSetup::max_braking, kOptional, kPositive, "m/s^2",
       "that it surely brakes with whenever it has to; may be more than max_acceleration",
       "max_acceleration"},
      {"parked", &RobotSetup::parked, kOptional, kNoNumber, "",
       "never moves and never decides: a disc that nobody may touch; its goal is its position"},
      {"layers", &RobotSetup::layers, kOptional, kLayer, "", "that it is in"},
      {"avoids", &RobotSetup::avoids, kOptional, kLayer, "",
       "it avoids the robots that are in one of these layers", "all of them"},
      {"behavior", &RobotSetup::behavior, kOptional, kNoNumber, "",
       "cooperates: it does its share, and the others do not count on it to brake"},
      {"time_step", &RobotSetup::time_step, kOptional, kPositive, "s",
       "between its own decisions; only where clock is free", "the scene's"},
      {"method", &RobotSetup::method, kOptional, kNoNumber, "",
       "how it chooses its velocities; one of another method than the scene's has what is "
       "customary "
       "for its own",
       "the scene's"},
      {"time_horizon", &RobotSetup::time_horizon, kOptional, kPositive, "s",
       "tau: how far it looks for collisions",
       "the scene's where it has its method, else what is customary"},
      {"arrival_distance", &RobotSetup::arrival_distance, kOptional, kPositive, "m",
       "to its goal: it has arrived once it is that near", "the scene's"},
  };
  return table;
}

std::vector<RobotField> robot_fields() {
  std::vector<RobotField> result;
  for (const Field<RobotSetup>& field : fields<RobotSetup>())
    std::visit(
        [&](auto member) {
          if constexpr (!std::is_same_v<decltype(member), std::monostate>)
            result.push_back({field.key, member, field.need == kRequired, field.unit, field.doc,
                              field.default_text});
        },
        field.member);
  return result;
}

const std::vector<Field<RobotSetup>>& group_robot_fields() {
  static const std::vector<Field<RobotSetup>> table = [] {
    std::vector<Field<RobotSetup>> result = fields<RobotSetup>();
    std::erase_if(result, [](const auto& f) { return f.key == "position" || f.key == "goal"; });
    return result;
  }();
  return table;
}

template <>
const std::vector<Field<Car>>& fields() {
  static const std::vector<Field<Car>> table{
      {"wheelbase", &Car::wheelbase, kOptional, kPositive, "m", "between the axles"},
      {"max_curvature", &Car::max_curvature, kOptional, kPositive, "1/m",
       "of its way; it turns in place only without", "unlimited"},
      {"body", kNested, kOptional, kNoNumber, "", "the disc that covers it",
       "that of radius, about the rear axle"},
      {"reverse", &Car::reverse, kOptional, kNoNumber, "", "it may drive backwards"},
      {"acceleration_set", &Car::acceleration_set, kOptional, kNoNumber, "",
       "exact: |a_lin| and |a_lat| <= max_acceleration; incircle: |a| is"},
  };
  return table;
}

template <>
const std::vector<Field<Airplane>>& fields() {
  static const std::vector<Field<Airplane>> table{
      {"min_speed", &Airplane::min_speed, kOptional, kPositive, "m/s", "never less"},
      {"lateral_acceleration", &Airplane::lateral_acceleration, kOptional, kPositive, "m/s^2",
       "across its way, never exceeded; max_acceleration is along it"},
      {"after_goal", &Airplane::after_goal, kOptional, kNoNumber, "",
       "once it has passed its goal: it turns right there for ever, or is gone"},
  };
  return table;
}

template <>
const std::vector<Field<CarBody>>& fields() {
  static const std::vector<Field<CarBody>> table{
      {"offset", &CarBody::offset, kOptional, kAnyValue, "m",
       "of its center, ahead of the rear axle"},
      {"radius", &CarBody::radius, kRequired, kPositive, "m", "of the disc, instead of radius"},
  };
  return table;
}

template <>
const std::vector<Field<FootprintShape>>& fields() {
  static const std::vector<Field<FootprintShape>> table{
      {"length", &FootprintShape::length, kOptional, kPositive, "m",
       "of a rectangle, along the heading", "a polygon"},
      {"width", &FootprintShape::width, kOptional, kPositive, "m", "of the rectangle", "a polygon"},
      {"offset", &FootprintShape::offset, kOptional, kAnyValue, "m",
       "of the rectangle's center, ahead of the position"},
      {"polygon", &FootprintShape::polygon, kOptional, kAnyValue, "m",
       "corners, from the position: x along the heading, y to its left", "a rectangle"},
      {"excess", &FootprintShape::excess, kOptional, kNotNegative, "m",
       "by which discs may exceed its sides; as few discs as that allows cover it",
       "a quarter of its width"},
  };
  return table;
}

template <>
const std::vector<Field<DifferentialDrive>>& fields() {
  static const std::vector<Field<DifferentialDrive>> table{
      {"track", &DifferentialDrive::track, kOptional, kPositive, "m", "between the wheels"},
      {"offset", &DifferentialDrive::offset, kOptional, kPositive, "m",
       "ahead of the axle, of the point that is planned for; the disc that others sense is about "
       "it, with radius + offset",
       "half of the smaller one of radius and track"},
      {"wheel_speed", &DifferentialDrive::wheel_speed, kOptional, kPositive, "m/s",
       "of each wheel, never exceeded"},
      {"wheel_acceleration", &DifferentialDrive::wheel_acceleration, kOptional, kPositive, "m/s^2",
       "of each wheel, never exceeded"},
  };
  return table;
}

}  // namespace avo_io
