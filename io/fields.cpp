// SPDX-License-Identifier: Apache-2.0
// The one table of what a scene file may say.
#include "fields.h"

#include <algorithm>
#include <limits>

namespace avo_io {

using avo::Airplane;
using avo::Car;
using avo::CarBody;
using avo::DifferentialDrive;
using avo::kAnyValue;
using avo::kAtLeastOne;
using avo::kNotNegative;
using avo::kPositive;
using avo::MeasurementNoise;
using avo::MovingObstacle;
using avo::RobotSetup;
using avo::Scenario;
using avo::SensingError;
using avo::SensingModel;
constexpr Need kRequired = Need::required;
constexpr Need kOptional = Need::optional;
constexpr std::monostate kNested;
constexpr avo::Range kNoNumber{};
constexpr avo::Range kSeed{0.0, 18446744073709551615.0, false};
constexpr avo::Range kNumber{1.0, static_cast<double>(avo::kMostRobots), false};
constexpr avo::Range kDelay{0.0, avo::kMostDelay, false};
constexpr avo::Range kLayer{0.0, 31.0, false};
constexpr avo::Range kName{1.0, 200.0, false};  // bytes

template <>
const std::vector<Field<Scenario>>& fields() {
  static const std::vector<Field<Scenario>> table{
      {"version", kNested, kRequired, {1.0, 1.0, false}, "", "version of this format"},
      {"name", &Scenario::name, kOptional, kName, "", "of the scene", "the file's name"},
      {"time_step", &Scenario::time_step, kOptional, kPositive, "s", "between decisions"},
      {"duration", &Scenario::duration, kOptional, kPositive, "s", "of the whole scene",
       "60 s and twice the longest straight way to a goal"},
      {"control_time", &Scenario::control_time, kOptional, kPositive, "s",
       "delta: time constant with which a new velocity is approached",
       "2 s for method avo, else 4 s"},
      {"time_horizon", &Scenario::time_horizon, kOptional, kPositive, "s",
       "tau: how far collisions are looked for", "3 s for method avo, else 10 s"},
      {"sensing_radius", &Scenario::sensing_radius, kOptional, kPositive, "m",
       "between centers; who is farther is not seen"},
      {"max_neighbors", &Scenario::max_neighbors, kOptional, kAtLeastOne, "",
       "nearest neighbors that get a half-plane", "no limit"},
      {"method", &Scenario::method, kOptional, kNoNumber, "", "how new velocities are chosen"},
      {"certificate", &Scenario::certificate, kOptional, kNoNumber, "",
       "what no decision may break; method avo only",
       "braking_trajectories for method avo, else none"},
      {"motion", &Scenario::motion, kOptional, kNoNumber, "",
       "between decisions: acceleration held, or proportional control exactly"},
      {"precision", kNested, kOptional, kNoNumber, "", "double, of all that is computed"},
      {"samples", &Scenario::samples, kOptional, avo::kSamples, "",
       "of an obstacle's boundary, a side; 0: exact half-planes (1 is refused)"},
      {"arrival_distance", &Scenario::arrival_distance, kOptional, kPositive, "m",
       "from the goal, within which a robot has arrived"},
      {"seed", &Scenario::seed, kOptional, kSeed, "", "of random placements, goals and headings"},
      {"robots", kNested, kOptional, kNoNumber, "", "numbered 0, 1, ... in this order"},
      {"groups", kNested, kOptional, kNoNumber, "",
       "many like robots each, numbered after `robots`"},
      {"robots_from", kNested, kOptional, kNoNumber, "",
       "robots of a MovingAI scenario, numbered after `robots` and before `groups`"},
      {"moving_obstacles", kNested, kOptional, kNoNumber, "", "discs that react to nobody"},
      {"obstacles", kNested, kOptional, kNoNumber, "", "what does not move, and nobody may touch"},
      {"navigation", &Scenario::navigation, kOptional, kNoNumber, "",
       "the preferred velocity follows a path around the obstacles",
       "true where there are obstacles"},
      {"right_of_way", &Scenario::right_of_way, kOptional, kNoNumber, "",
       "with navigation, how robots know who else is about to go through a narrow passage"},
      {"sensing", kNested, kOptional, {}, "", "how robots sense others; omitted: as they are"},
      {"sensing_error",
       kNested,
       kOptional,
       {},
       "",
       "what robots declare to braking_trajectories; omitted: what covers noise and delay"},
      {"clock", &Scenario::clock, kOptional, kNoNumber, "",
       "free: each robot decides at times of its own, from a phase that the seed gives it"},
  };
  return table;
}

template <>
const std::vector<Field<SensingModel>>& fields() {
  static const std::vector<Field<SensingModel>> table{
      {"noise", kNested, kOptional, {}, "", "by which a measurement is off"},
      {"delay", &SensingModel::delay, kOptional, kDelay, "steps",
       "from a measurement to the decision; carried on meanwhile"},
      {"dropped", &SensingModel::dropped, kOptional, avo::kShareMissed, "",
       "share of the measurements that are missed, each by chance"},
      {"occlusion",
       &SensingModel::occlusion,
       kOptional,
       {},
       "",
       "nobody is sensed whose center is behind an obstacle"},
  };
  return table;
}

template <>
const std::vector<Field<MeasurementNoise>>& fields() {
  static const std::vector<Field<MeasurementNoise>> table{
      {"position", &MeasurementNoise::position, kOptional, avo::kNoise, "m",
       "of each coordinate: standard deviation, or bound of uniform noise"},
      {"velocity", &MeasurementNoise::velocity, kOptional, avo::kNoise, "m/s", "likewise"},
      {"distribution", &MeasurementNoise::distribution, kOptional, {}, "", "of each coordinate"},
      {"truncated", &MeasurementNoise::truncated, kOptional, avo::kTruncation, "",
       "gaussian noise stays within so many standard deviations", "3"},
  };
  return table;
}

template <>
const std::vector<Field<SensingError>>& fields() {
  static const std::vector<Field<SensingError>> table{
      {"position", &SensingError::position, kOptional, kNotNegative, "m",
       "at most so far from where it is sensed"},
      {"velocity", &SensingError::velocity, kOptional, kNotNegative, "m/s", "likewise"},
  };
  return table;
}

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
      {"priority", &RobotSetup::priority, kOptional, kPositive, "",
       "of a pair, A takes the part p_B/(p_A + p_B) of what both have to do, 1/64 to 63/64 of it"},
      {"max_braking", &RobotSetup::max_braking, kOptional, kPositive, "m/s^2",
       "that it surely brakes with whenever it has to, <= max_acceleration", "max_acceleration"},
      {"parked", &RobotSetup::parked, kOptional, kNoNumber, "",
       "never moves and never decides: a disc that nobody may touch; its goal is its position"},
      {"layers", &RobotSetup::layers, kOptional, kLayer, "", "that it is in"},
      {"avoids", &RobotSetup::avoids, kOptional, kLayer, "",
       "it avoids the robots that are in one of these layers", "all of them"},
      {"time_step", &RobotSetup::time_step, kOptional, kPositive, "s",
       "between its own decisions; only where clock is free", "the scene's"},
  };
  return table;
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
const std::vector<Field<DifferentialDrive>>& fields() {
  static const std::vector<Field<DifferentialDrive>> table{
      {"track", &DifferentialDrive::track, kOptional, kPositive, "m", "between the wheels"},
      {"offset", &DifferentialDrive::offset, kOptional, kPositive, "m",
       "ahead of the axle, of the point that is planned for; the disc that others sense is about "
       "it, with radius + offset"},
      {"wheel_speed", &DifferentialDrive::wheel_speed, kOptional, kPositive, "m/s",
       "of each wheel, never exceeded"},
      {"wheel_acceleration", &DifferentialDrive::wheel_acceleration, kOptional, kPositive, "m/s^2",
       "of each wheel, never exceeded"},
  };
  return table;
}

template <>
const std::vector<Field<MovingObstacle>>& fields() {
  static const std::vector<Field<MovingObstacle>> table{
      {"position", &MovingObstacle::position, kRequired, kAnyValue, "m", "where it starts"},
      {"velocity", &MovingObstacle::velocity, kOptional, kAnyValue, "m/s", "at the start"},
      {"acceleration", &MovingObstacle::acceleration, kOptional, kAnyValue, "m/s^2", "constant"},
      {"radius", &MovingObstacle::radius, kOptional, kPositive, "m", "of its disc"},
      {"max_deviation", &MovingObstacle::max_deviation, kOptional, kNotNegative, "m/s^2",
       "by which robots count on its acceleration being another one at any time"},
      {"max_speed", &MovingObstacle::max_speed, kOptional, kPositive, "m/s",
       "with max_deviation: that it never exceeds", "no limit"},
      {"path", &MovingObstacle::path, kOptional, kAnyValue, "m",
       "that it goes along within these, from point to point and on to the first again",
       "none: it keeps its acceleration"},
  };
  return table;
}

template <>
const std::vector<Field<Group>>& fields() {
  static const std::vector<Field<Group>> table{
      {"number", &Group::number, kRequired, kNumber, "", "how many robots"},
      {"placement", kNested, kRequired, kNoNumber, "", "where they start"},
      {"goals", kNested, kRequired, kNoNumber, "", "where they want to come to rest"},
  };
  return table;
}

template <>
const std::vector<Field<CirclePlacement>>& fields() {
  static const std::vector<Field<CirclePlacement>> table{
      {"center", &CirclePlacement::center, kOptional, kAnyValue, "m", "of the circle"},
      {"min_radius", &CirclePlacement::min_radius, kOptional, kNotNegative, "m", "of the circle"},
      {"spacing", &CirclePlacement::spacing, kOptional, kPositive, "m",
       "length of the arc from robot to robot, unless min_radius is larger"},
  };
  return table;
}

template <>
const std::vector<Field<GridPlacement>>& fields() {
  static const std::vector<Field<GridPlacement>> table{
      {"corner", &GridPlacement::corner, kOptional, kAnyValue, "m", "of the first robot"},
      {"spacing", &GridPlacement::spacing, kRequired, kPositive, "m",
       "from robot to robot, along x and y"},
      {"columns", &GridPlacement::columns, kRequired, kNumber, "", "how many robots in a row"},
  };
  return table;
}

template <>
const std::vector<Field<LinePlacement>>& fields() {
  static const std::vector<Field<LinePlacement>> table{
      {"from", &LinePlacement::from, kRequired, kAnyValue, "m", "where the first robot starts"},
      {"to", &LinePlacement::to, kRequired, kAnyValue, "m", "where the last robot starts"},
  };
  return table;
}

template <>
const std::vector<Field<RandomPlacement>>& fields() {
  static const std::vector<Field<RandomPlacement>> table{
      {"min", &RandomPlacement::min, kRequired, kAnyValue, "m", "lower left corner"},
      {"max", &RandomPlacement::max, kRequired, kAnyValue, "m", "upper right corner"},
      {"clearance", &RandomPlacement::clearance, kOptional, kNotNegative, "m", "between discs"},
  };
  return table;
}

template <>
const std::vector<Field<AntipodalGoals>>& fields() {
  static const std::vector<Field<AntipodalGoals>> table;
  return table;
}

template <>
const std::vector<Field<OffsetGoals>>& fields() {
  static const std::vector<Field<OffsetGoals>> table{
      {"by", &OffsetGoals::by, kRequired, kAnyValue, "m", "from start to goal"},
  };
  return table;
}

template <>
const std::vector<Field<PermutationGoals>>& fields() {
  static const std::vector<Field<PermutationGoals>> table;
  return table;
}

template <>
const std::vector<Field<RandomGoals>>& fields() {
  static const std::vector<Field<RandomGoals>> table{
      {"min", &RandomGoals::min, kRequired, kAnyValue, "m", "lower left corner"},
      {"max", &RandomGoals::max, kRequired, kAnyValue, "m", "upper right corner"},
      {"clearance", &RandomGoals::clearance, kOptional, kNotNegative, "m",
       "between the discs of robots at their goals"},
  };
  return table;
}

}  // namespace avo_io
