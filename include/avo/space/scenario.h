// SPDX-License-Identifier: Apache-2.0
// A scene of space as data (docs/space.md). SI units.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/planner.h"
#include "avo/scenario.h"
#include "avo/space/box.h"
#include "avo/space/mover.h"
#include "avo/space/quadrotor.h"
#include "avo/space/robot.h"
#include "avo/vec3.h"

namespace avo::space {

/// A robot as a scene lists it: where it starts, where it goes, what it can do.
struct RobotSetup {
  Vec3 position = {};                ///< m
  Vec3 velocity = {};                ///< m/s
  Vec3 goal = {};                    ///< m
  double radius = 0.5;               ///< m, > 0
  double max_speed = 2.0;            ///< m/s, > 0
  double max_acceleration = 1.0;     ///< m/s^2, > 0; of a quadrotor that of its limits instead
  double preferred_speed = 2.0;      ///< m/s, >= 0
  double vertical = 1.0;             ///< > 0, see Robot::vertical
  std::optional<double> climb = {};  ///< m/s, > 0; unset: no limit but the speed
  std::optional<double> sink = {};   ///< m/s, > 0; unset: no limit but the speed
  double downwash = 0.0;             ///< m, >= 0, see Robot::downwash
  double priority = 1.0;             ///< > 0
  std::optional<double> max_braking = {};  ///< m/s^2, > 0; unset: max_acceleration
  /// What flies behind its reference. The robot is the reference then: others keep its deviation
  /// more than its radius away.
  std::optional<Quadrotor> quadrotor = {};

  friend bool operator==(const RobotSetup&, const RobotSetup&) = default;
};

/// A scene of space. Its fields are keys of scene files with `space: 3`.
struct Scenario {
  std::string name = {};
  double time_step = 0.1;                    ///< [Δt] s, > 0
  double duration = 60.0;                    ///< s, >= time_step
  std::optional<double> control_time = {};   ///< [δ] s, > 0; unset: as in the plane
  std::optional<double> response_time = {};  ///< [κ] >= 0, of v_max/a_max; unset: as in the plane
  std::optional<double> comfort_acceleration = {};  ///< m/s², > 0; unset: none
  std::optional<double> comfort_jerk = {};          ///< m/s³, > 0; unset: none
  std::optional<double> time_horizon = {};          ///< [τ] s, > 0; unset: as in the plane
  /// m, > 0, between centers; unset: the radius that the robots need
  std::optional<double> sensing_radius = {};
  std::optional<int> max_neighbors =
      {};  ///< so many nearest neighbors get a half-space; unset: all
  std::optional<Certificate> certificate = {};  ///< unset: braking_trajectories
  Motion motion = Motion::held;
  bool navigation = true;         ///< robots follow routes around boxes
  double arrival_distance = 0.5;  ///< m, > 0
  std::uint64_t seed = 1;         ///< of random placements
  /// How robots sense others, as in the plane. Boxes and the own goal are off by `localization`.
  SensingModel sensing = {};
  /// The error that the robots declare to their certificate; unset: declared_error().
  std::optional<SensingError> sensing_error = {};
  bool never_swerves = false;  ///< see PlannerOptions
  std::vector<RobotSetup> robots = {};
  std::vector<MovingObstacle> moving_obstacles = {};
  std::vector<Box> boxes = {};  ///< static obstacles
  /// The number of the obstacle of the scene file that each box comes from, for messages; empty:
  /// the boxes come from no file.
  std::vector<std::int64_t> obstacle_of_box = {};
};

AVO_API PlannerOptions planner_options(const Scenario& scenario);

/// Bounds of what noise and delay of the scene's sensing make of the true states.
AVO_API SensingError declared_error(const Scenario& scenario);

/// Returns the robot of that setup, at its start. That of a quadrotor has the quadrotor's limit of
/// acceleration, and a radius that contains its deviation.
AVO_API Robot robot_of(const RobotSetup& setup);

/// [D] s: how long after their references all quadrotors of the scene fly, the largest of their
/// delays; 0 without quadrotors.
AVO_API double fleet_delay(const Scenario& scenario);

/// m: the sensing radius of the scene, or the radius that its robots need.
AVO_API double sensing_radius_of(const Scenario& scenario);

/// Throws Error that names the first fault. This may be a value out of range, or a sensing radius
/// that is too short for the certificate. It may also be a robot that touches another robot, a box
/// or a moving obstacle, or cannot brake before it.
AVO_API void validate(const Scenario& scenario);

}  // namespace avo::space
