// SPDX-License-Identifier: Apache-2.0
// The fields of scenes of space, and of their robots, quadrotors, moving obstacles and boxes.
#pragma once
#include "avo/space/scenario.h"
#include "fields/robot_fields.h"
#include "fields/scene_fields.h"

namespace avo::inline fields {

template <>
struct MembersOf<space::RobotSetup> {
  using type = MemberOf<space::RobotSetup, double, std::optional<double>, Vec3>;
};
template <>
struct MembersOf<space::Scenario> {
  using type = MemberOf<space::Scenario, double, std::optional<double>, std::optional<int>,
                        std::uint64_t, std::string, bool, std::optional<Certificate>, Motion>;
};

template <>
AVO_LOCAL inline constexpr auto kFields<space::RobotSetup> = [] {
  using Plane = RobotSetup;
  using Robot = space::RobotSetup;
  return std::to_array<Field<Robot>>({
      as_in<Plane>("position", &Robot::position),
      {"velocity", &Robot::velocity, kOptional, kAnyValue, "m/s", "at the start"},
      as_in<Plane>("goal", &Robot::goal),
      {"radius", &Robot::radius, kOptional, kPositive, "m", "of its ball"},
      as_in<Plane>("max_speed", &Robot::max_speed, ""),
      as_in<Plane>("max_acceleration", &Robot::max_acceleration, "1; of a quadrotor what it gives"),
      as_in<Plane>("preferred_speed", &Robot::preferred_speed),
      {"vertical", &Robot::vertical, kOptional, kPositive, "",
       "its limits of acceleration and speed along the vertical, as a part of the horizontal ones"},
      {"climb", &Robot::climb, kOptional, kPositive, "m/s", "the largest speed upwards",
       "no limit"},
      {"sink", &Robot::sink, kOptional, kPositive, "m/s", "the largest speed downwards",
       "no limit"},
      {"downwash", &Robot::downwash, kOptional, kNotNegative, "m",
       "no robot may be so far below it, within both radii"},
      as_in<Plane>("priority", &Robot::priority),
      as_in<Plane>("max_braking", &Robot::max_braking),
      {"quadrotor", kNested, kOptional, kNoNumber, "",
       "what flies behind the reference; it gives max_acceleration", "none"},
  });
}();

inline constexpr Range kTilt{0.0, 1.5, true};

template <>
AVO_LOCAL inline constexpr auto kFields<space::Quadrotor> = [] {
  using space::Quadrotor;
  return std::to_array<Field<Quadrotor>>({
      {"mass", &Quadrotor::mass, kRequired, kPositive, "kg", "of the vehicle"},
      {"max_thrust", &Quadrotor::max_thrust, kRequired, kPositive, "N", "of all rotors"},
      {"min_thrust", &Quadrotor::min_thrust, kOptional, kNotNegative, "N", "of all rotors",
       "a tenth of its weight"},
      {"max_tilt", &Quadrotor::max_tilt, kRequired, kTilt, "rad", "of the thrust off the vertical"},
      {"attitude_time", &Quadrotor::attitude_time, kRequired, kPositive, "s",
       "the mean delay of its acceleration behind a command"},
      {"tracking_error", &Quadrotor::tracking_error, kOptional, kNotNegative, "m",
       "the largest distance from the reference of attitude_time ago, as measured",
       "max_acceleration attitude_time^2"},
  });
}();

template <>
AVO_LOCAL inline constexpr auto kFields<space::MovingObstacle> = [] {
  using Plane = MovingObstacle;
  using Mover = space::MovingObstacle;
  return std::to_array<Field<Mover>>({
      as_in<Plane>("position", &Mover::position),
      as_in<Plane>("velocity", &Mover::velocity),
      as_in<Plane>("acceleration", &Mover::acceleration),
      {"radius", &Mover::radius, kOptional, kPositive, "m", "of its ball"},
      as_in<Plane>("max_deviation", &Mover::max_deviation),
      as_in<Plane>("max_speed", &Mover::max_speed),
      {"trajectory", kNested, kOptional, kNoNumber, "",
       "[[time, x, y, z], ...]: it moves straight from each place to the next", "none"},
  });
}();

/// In scene files a box has bounds about its own middle, and no radius.
template <>
AVO_LOCAL inline constexpr auto kFields<space::Box> = std::to_array<Field<space::Box>>({
    {"min", kNested, kOptional, kNoNumber, "m", "the lower corner; may be infinite"},
    {"max", kNested, kOptional, kNoNumber, "m", "the upper corner; may be infinite"},
    {"radius", &space::Box::radius, kOptional, kNotNegative, "m",
     "of the points that belong to it"},
    {"heading", &space::Box::heading, kOptional, kAngle, "rad",
     "counter-clockwise from above, about the origin"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<space::Scenario> = [] {
  using Plane = Scenario;
  using Scene = space::Scenario;
  return std::to_array<Field<Scene>>({
      {"version", kNested, kRequired, kNoNumber, "", "version: 1"},
      {"space", kNested, kRequired, kNoNumber, "", "space: 3, vectors have three numbers"},
      as_in<Plane>("name", &Scene::name),
      as_in<Plane>("time_step", &Scene::time_step),
      as_in<Plane>("duration", &Scene::duration),
      as_in<Plane>("control_time", &Scene::control_time, "2"),
      as_in<Plane>("response_time", &Scene::response_time, "0.1"),
      as_in<Plane>("comfort_acceleration", &Scene::comfort_acceleration),
      as_in<Plane>("comfort_jerk", &Scene::comfort_jerk),
      as_in<Plane>("time_horizon", &Scene::time_horizon, "3"),
      as_in<Plane>("sensing_radius", &Scene::sensing_radius, "what the robots need"),
      {"max_neighbors", &Scene::max_neighbors, kOptional, kAtLeastOne, "",
       "nearest neighbors that get a half-space", "no limit"},
      {"certificate", &Scene::certificate, kOptional, kNoNumber, "", "what no decision may break",
       "braking_trajectories"},
      as_in<Plane>("motion", &Scene::motion),
      {"navigation", &Scene::navigation, kOptional, kNoNumber, "",
       "robots follow routes around boxes"},
      as_in<Plane>("arrival_distance", &Scene::arrival_distance),
      as_in<Plane>("seed", &Scene::seed),
      {"sensing", kNested, kOptional, kNoNumber, "", "how robots sense others", "exactly"},
      {"sensing_error", kNested, kOptional, kNoNumber, "",
       "that the robots declare to their certificate", "what covers noise and delay"},
      {"robots", kNested, kOptional, kNoNumber, "", "one by one"},
      {"groups", kNested, kOptional, kNoNumber, "", "many of a kind"},
      {"moving_obstacles", kNested, kOptional, kNoNumber, "", "that decide nothing"},
      as_in<Plane>("never_swerves", &Scene::never_swerves),
      {"obstacles", kNested, kOptional, kNoNumber, "", "that do not move"},
  });
}();

}  // namespace avo::inline fields
