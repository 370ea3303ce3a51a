// SPDX-License-Identifier: Apache-2.0
// The table of fields for scenes of space.
#include "io/fields/fields.h"

namespace avo_io {

using avo::kAnyValue;
using avo::kAtLeastOne;
using avo::kNotNegative;
using avo::kPositive;
using SpaceRobot = avo::space::RobotSetup;
using SpaceScene = avo::space::Scenario;

template <>
const std::vector<Field<SpaceRobot>>& fields() {
  static const std::vector<Field<SpaceRobot>> table{
      {"position", &SpaceRobot::position, kRequired, kAnyValue, "m", "where it starts"},
      {"velocity", &SpaceRobot::velocity, kOptional, kAnyValue, "m/s", "at the start"},
      {"goal", &SpaceRobot::goal, kRequired, kAnyValue, "m", "where it wants to come to rest"},
      {"radius", &SpaceRobot::radius, kOptional, kPositive, "m", "of its ball"},
      {"max_speed", &SpaceRobot::max_speed, kOptional, kPositive, "m/s", "never exceeded"},
      {"max_acceleration", &SpaceRobot::max_acceleration, kOptional, kPositive, "m/s^2",
       "never exceeded"},
      {"preferred_speed", &SpaceRobot::preferred_speed, kOptional, kNotNegative, "m/s",
       "towards the goal", "max_speed"},
      {"vertical", &SpaceRobot::vertical, kOptional, kPositive, "",
       "its limits of acceleration and speed along the vertical, as a part of the horizontal ones"},
      {"climb", &SpaceRobot::climb, kOptional, kPositive, "m/s", "the largest speed upwards",
       "unlimited"},
      {"sink", &SpaceRobot::sink, kOptional, kPositive, "m/s", "the largest speed downwards",
       "unlimited"},
      {"downwash", &SpaceRobot::downwash, kOptional, kNotNegative, "m",
       "no robot may be so far below it, within both radii"},
      {"priority", &SpaceRobot::priority, kOptional, kPositive, "",
       "of a pair, A takes the part p_B/(p_A + p_B) of what both have to do, 1/64 to 63/64 of it"},
      {"max_braking", &SpaceRobot::max_braking, kOptional, kPositive, "m/s^2",
       "that it surely brakes with whenever it has to; may be more than max_acceleration",
       "max_acceleration"},
      {"quadrotor", kNested, kOptional, kNoNumber, "",
       "what flies behind the reference; it gives max_acceleration", "none"},
  };
  return table;
}

template <>
const std::vector<Field<avo::space::Quadrotor>>& fields() {
  using avo::space::Quadrotor;
  static const std::vector<Field<Quadrotor>> table{
      {"mass", &Quadrotor::mass, kRequired, kPositive, "kg", "of the vehicle"},
      {"max_thrust", &Quadrotor::max_thrust, kRequired, kPositive, "N", "of all rotors"},
      {"min_thrust", &Quadrotor::min_thrust, kOptional, kNotNegative, "N", "of all rotors",
       "a tenth of its weight"},
      {"max_tilt",
       &Quadrotor::max_tilt,
       kRequired,
       {0.0, 1.5, true},
       "rad",
       "of the thrust off the vertical"},
      {"attitude_time", &Quadrotor::attitude_time, kRequired, kPositive, "s",
       "the mean delay of its acceleration behind a command"},
      {"tracking_error", &Quadrotor::tracking_error, kOptional, kNotNegative, "m",
       "the largest distance from the reference of attitude_time ago, as measured",
       "max_acceleration attitude_time^2"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceScene>>& fields() {
  static const std::vector<Field<SpaceScene>> table{
      {"version", kNested, kRequired, kNoNumber, "", "version: 1"},
      {"space", kNested, kRequired, kNoNumber, "", "space: 3, vectors have three numbers"},
      {"name",
       &SpaceScene::name,
       kOptional,
       {1.0, 200.0, false},
       "",
       "of the scene",
       "that of the file"},
      {"time_step", &SpaceScene::time_step, kOptional, kPositive, "s", "between decisions"},
      {"duration", &SpaceScene::duration, kOptional, kPositive, "s", "of a run",
       "what robots need with detours"},
      {"control_time", &SpaceScene::control_time, kOptional, kPositive, "s", "delta of Eq. (7)",
       "2"},
      {"response_time", &SpaceScene::response_time, kOptional, kNotNegative, "",
       "in units of v_max/a_max: how gently robots move", "as in the plane"},
      {"comfort_acceleration", &SpaceScene::comfort_acceleration, kOptional, kPositive, "m/s^2",
       "used unless the certificate asks for more", "all of max_acceleration"},
      {"comfort_jerk", &SpaceScene::comfort_jerk, kOptional, kPositive, "m/s^3",
       "the largest change of the acceleration in a second", "by response_time"},
      {"time_horizon", &SpaceScene::time_horizon, kOptional, kPositive, "s",
       "tau: how far robots look for collisions", "3"},
      {"sensing_radius", &SpaceScene::sensing_radius, kOptional, kPositive, "m", "between centers",
       "what the robots need"},
      {"max_neighbors", &SpaceScene::max_neighbors, kOptional, kAtLeastOne, "",
       "so many nearest neighbors get a half-space", "all"},
      {"certificate", &SpaceScene::certificate, kOptional, kNoNumber, "",
       "what no decision may break", "braking_trajectories"},
      {"motion", &SpaceScene::motion, kOptional, kNoNumber, "",
       "how the velocity changes between two decisions"},
      {"navigation", &SpaceScene::navigation, kOptional, kNoNumber, "",
       "robots follow routes around boxes"},
      {"arrival_distance", &SpaceScene::arrival_distance, kOptional, kPositive, "m",
       "a robot has arrived once it is that near to its goal"},
      {"seed",
       &SpaceScene::seed,
       kOptional,
       {0.0, 9007199254740992.0, false},
       "",
       "of random placements"},
      {"sensing", kNested, kOptional, kNoNumber, "", "how robots sense others", "exactly"},
      {"sensing_error", kNested, kOptional, kNoNumber, "",
       "that the robots declare to their certificate", "what covers noise and delay"},
      {"robots", kNested, kOptional, kNoNumber, "", "one by one"},
      {"groups", kNested, kOptional, kNoNumber, "", "many of a kind"},
      {"moving_obstacles", kNested, kOptional, kNoNumber, "", "that decide nothing"},
      {"never_swerves", &SpaceScene::never_swerves, kOptional, kNoNumber, "",
       "whether robots are at rest whenever a moving obstacle touches them"},
      {"obstacles", kNested, kOptional, kNoNumber, "", "that do not move"},
  };
  return table;
}

template <>
const std::vector<Field<avo::space::MovingObstacle>>& fields() {
  using avo::space::MovingObstacle;
  static const std::vector<Field<MovingObstacle>> table{
      {"position", &MovingObstacle::position, kOptional, kAnyValue, "m", "where it starts",
       "where its trajectory has it at 0 s; without one it has to be given"},
      {"velocity", &MovingObstacle::velocity, kOptional, kAnyValue, "m/s", "at the start"},
      {"acceleration", &MovingObstacle::acceleration, kOptional, kAnyValue, "m/s^2", "constant"},
      {"radius", &MovingObstacle::radius, kOptional, kPositive, "m", "of its ball"},
      {"max_deviation", &MovingObstacle::max_deviation, kOptional, kNotNegative, "m/s^2",
       "by which its acceleration may differ from `acceleration`, as robots assume"},
      {"max_speed", &MovingObstacle::max_speed, kOptional, kPositive, "m/s",
       "that robots assume, with max_deviation", "unlimited"},
      {"trajectory", kNested, kOptional, kNoNumber, "",
       "[[time, x, y, z], ...]: it moves straight from each place to the next", "none"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceGroup>>& fields() {
  static const std::vector<Field<SpaceGroup>> table{
      {"count", &SpaceGroup::count, kRequired, kNumber, "", "number of robots"},
      {"sphere", kNested, kOptional, kNoNumber, "", "evenly over a sphere"},
      {"box", kNested, kOptional, kNoNumber, "", "at random in a box"},
      {"grid", kNested, kOptional, kNoNumber, "", "row by row, layer by layer"},
      {"goal", kNested, kRequired, kNoNumber, "",
       "antipodal, permuted, or {offset: {by: [x, y, z]}}"},
      {"jitter", &SpaceGroup::jitter, kOptional, kNotNegative, "m",
       "the largest random offset of starts and goals"},
  };
  return table;
}

template <>
const std::vector<Field<SpherePlacement>>& fields() {
  static const std::vector<Field<SpherePlacement>> table{
      {"center", &SpherePlacement::center, kOptional, kAnyValue, "m", "of the sphere"},
      {"radius", &SpherePlacement::radius, kOptional, kPositive, "m", "of the sphere"},
  };
  return table;
}

template <>
const std::vector<Field<BoxPlacement>>& fields() {
  static const std::vector<Field<BoxPlacement>> table{
      {"min", &BoxPlacement::min, kRequired, kAnyValue, "m", "corner"},
      {"max", &BoxPlacement::max, kRequired, kAnyValue, "m", "corner"},
      {"clearance", &BoxPlacement::clearance, kOptional, kNotNegative, "m",
       "between any two robots, beyond contact"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceGridPlacement>>& fields() {
  static const std::vector<Field<SpaceGridPlacement>> table{
      {"corner", &SpaceGridPlacement::corner, kRequired, kAnyValue, "m", "of the first robot"},
      {"spacing", &SpaceGridPlacement::spacing, kOptional, kPositive, "m", "between neighbors"},
      {"columns", &SpaceGridPlacement::columns, kRequired, kNumber, "", "robots along x"},
      {"rows", &SpaceGridPlacement::rows, kRequired, kNumber, "", "robots along y"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceOffset>>& fields() {
  static const std::vector<Field<SpaceOffset>> table{
      {"by", &SpaceOffset::by, kRequired, kAnyValue, "m", "from the start to the goal"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceBox>>& fields() {
  static const std::vector<Field<SpaceBox>> table{
      {"min", &SpaceBox::min, kRequired, kAnyValue, "m", "corner"},
      {"max", &SpaceBox::max, kRequired, kAnyValue, "m", "corner"},
      {"heading", &SpaceBox::heading, kOptional, avo::kAngle, "rad",
       "counter-clockwise from above, about the middle of the box"},
  };
  return table;
}

}  // namespace avo_io
