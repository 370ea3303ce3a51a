// SPDX-License-Identifier: Apache-2.0
// A scene as data: robots, and how they are simulated. SI units.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/execution.h"
#include "avo/export.h"
#include "avo/external_method.h"
#include "avo/moving_obstacle.h"
#include "avo/planner.h"
#include "avo/sensing.h"
#include "avo/teams.h"
#include "avo/trajectory.h"
#include "avo/vec.h"
#include "avo/wall.h"

namespace avo {

/// A robot as a scene lists it: where it starts, where it goes, what it can do.
struct RobotSetup {
  Vec2 position = {};  ///< m, see disc_center()
  /// m/s; for a robot with wheels its length counts, along the heading. It counts against the
  /// heading where the robot may drive backwards and the velocity points there.
  Vec2 velocity = {};
  Vec2 goal = {};                 ///< m
  double radius = 0.5;            ///< m, > 0, about the position; see disc_radius()
  double max_speed = 2.0;         ///< m/s, > 0
  double max_acceleration = 1.0;  ///< m/s^2, > 0
  double preferred_speed = 2.0;   ///< m/s, >= 0
  MotionModel model = {};         ///< how it moves
  double heading = 0.0;           ///< rad, counter-clockwise from +x; not read for holonomic robots
  double priority = 1.0;          ///< > 0, see Robot::priority
  /// Layers that it is in; it heeds the static obstacles of these layers. A parked robot has the
  /// default.
  LayerSet layers{1};
  LayerSet avoids = kAllLayers;  ///< it avoids robots that are in one of these layers
  /// [Δt] s, > 0, whole nanoseconds: between its own decisions. Only where Scenario::clock is free;
  /// unset: the scene's.
  std::optional<double> time_step = {};
  /// [b] m/s^2, > 0, see Robot::max_braking; unset: max_acceleration
  std::optional<double> max_braking = {};
  /// What others count on. To a robot that moves_on they do not leave any share of the avoidance.
  /// They count on its velocity alone, as if it had failed. The robot itself decides as ever. A
  /// body that reacts to no robot is a MovingObstacle, or avoids no layer. The goal of a robot that
  /// is parked is its position, and its velocity is 0.
  Behavior behavior = Behavior::decides;
  /// The method that chooses its velocities; unset: the scene's. A robot with a method other than
  /// the scene's has the usual options of its own method, see planner_options().
  std::optional<Method> method = {};
  std::optional<double> time_horizon = {};      ///< [τ] s, > 0; unset: the horizon of its method
  std::optional<double> arrival_distance = {};  ///< m, > 0; unset: the scene's
  /// s, >= 0, since the start of the run. Before, the robot stands at its start: it decides with
  /// preferred velocity 0, whatever a host tells it. A robot that cannot rest and a parked robot
  /// have 0.
  double start_time = 0.0;

  friend bool operator==(const RobotSetup&, const RobotSetup&) = default;
};

/// Returns whether a robot with that start_time, s, stands at its start at that time, s. Times are
/// sums of steps, which are rounded.
constexpr bool waits_to_start(double start_time, double time) {
  return start_time > time * (1.0 + 1e-12);
}

/// Returns the center of the disc that others sense.
inline Vec2 disc_center(const RobotSetup& robot) {
  return disc_center(robot.model, robot.position, robot.heading);
}
inline double disc_radius(const RobotSetup& robot) {
  return disc_radius(robot.model, robot.radius);
}

constexpr bool is_parked(const RobotSetup& robot) {
  return robot.behavior == Behavior::parked;
}

/// Returns whether A avoids B: by their layers, or because one of them is parked. A parked robot
/// and a deciding robot avoid each other, two parked robots do not. If B does not avoid A, B is a
/// mover to A: it reacts to no other (docs/certificate/movers.md). If A has method avo, B is also a
/// mover to A if it has another method: B promises nothing (docs/certificate/movers.md, "Robots of
/// other methods").
constexpr bool avoids(const RobotSetup& a, const RobotSetup& b) {
  if (is_parked(a) || is_parked(b)) return is_parked(a) != is_parked(b);
  return (a.avoids.bits & b.layers.bits) != 0;
}

/// Returns whether the two may not be in one place: one of them avoids the other, or both are
/// parked.
constexpr bool keep_apart(const RobotSetup& a, const RobotSetup& b) {
  return (is_parked(a) && is_parked(b)) || avoids(a, b) || avoids(b, a);
}

/// How robots on their routes know which other robots are about to pass a narrow passage.
enum class RightOfWay : std::uint8_t {
  none,  ///< they ignore passages
  seen,  ///< from the place and the motion of each robot
};
AVO_API const char* to_string(RightOfWay right_of_way);

/// A scene: the moving bodies, their surroundings, and how they are simulated. Its fields are the
/// keys of scene files.
struct Scenario {
  std::string name = {};
  double time_step = 0.1;  ///< [Δt] s, > 0; whole nanoseconds where the clock is free
  double duration = 60.0;  ///< s, >= time_step
  std::optional<double> control_time = {};  ///< [δ] s, > 0; unset: default_options(method)
  /// [κ] >= 0, in units of T = v_max/a_max; unset: default_options(method)
  std::optional<double> response_time = {};
  /// m/s², > 0, of method avo: see PlannerOptions; unset: none
  std::optional<double> comfort_acceleration = {};
  /// m/s³, > 0, of method avo: see PlannerOptions; unset: none
  std::optional<double> comfort_jerk = {};
  double margin = 0.0;                      ///< [m] m, >= 0, of method avo: see PlannerOptions
  bool never_swerves = false;               ///< of method avo: see PlannerOptions
  std::optional<double> time_horizon = {};  ///< [τ] s, > 0; unset: default_options(method)
  /// m, > 0, between centers; unset: the radius that the robots need
  std::optional<double> sensing_radius = {};
  /// so many nearest neighbors get a half-plane; unset: all
  std::optional<int> max_neighbors = {};
  Method method = Method::avo;
  std::optional<Certificate> certificate = {};  ///< unset: default_options(method)
  Motion motion = Motion::held;
  double arrival_distance = 0.5;  ///< m, > 0
  std::uint64_t seed = 1;         ///< of random placements
  std::vector<RobotSetup> robots = {};
  std::vector<MovingObstacle> moving_obstacles = {};
  /// They do not move; no robot of their layers may touch them.
  std::vector<StaticObstacle> obstacles = {};
  std::vector<Team> teams = {};  ///< robots with one task; the simulation leads them, see lead()
  /// The preferred velocity follows a route around the obstacles, and around moving obstacles at
  /// rest; unset: where there are any.
  std::optional<bool> navigation = {};
  RightOfWay right_of_way = RightOfWay::seen;  ///< at passages, with navigation
  SensingModel sensing = {};
  /// The error that the robots declare to braking_trajectories; unset: declared_error() of
  /// `sensing`.
  std::optional<SensingError> sensing_error = {};
  /// How the bases of all robots execute commands; unset: exactly. Each body then follows a
  /// reference, for which its robot decides, and the robots tell each other their references. With
  /// `sensing` they measure the bodies instead. Views, metrics and recordings are of the bodies.
  /// For holonomic robots and drives that start at rest.
  std::optional<ExecutionModel> execution = {};
  /// m, >= 0, with `execution`: what each robot adds to its radius; unset: execution_error().
  std::optional<double> execution_error = {};
  /// free: each robot decides at its own times, one time_step of its own apart, from a phase that
  /// the seed gives it (docs/scenes.md, "Clocks").
  Clock clock = Clock::common;
  /// s, where the clock is free: the longest time_step that any robot may have, including robots
  /// that are added later; unset: that of the scene's robots.
  std::optional<double> longest_step = {};
  /// Simulations of the scene are made whatever broken_assumptions() finds. Robots may be added and
  /// moved to places where they break the assumptions of the certificate, as onto others. They part
  /// then, and nothing is promised until they have parted.
  bool allow_broken_assumptions = false;
  /// The name of the method of robots with method external or external_clamped, 1 to 64 bytes; not
  /// read where there are none.
  std::string external_method = {};
  /// Its function, which is no key of scene files. A simulation without it can be made, and takes
  /// no step.
  ExternalMethod external = {};
};

/// s, between decisions of a robot of the scene.
constexpr double time_step_of(const Scenario& scenario, const RobotSetup& robot) {
  return robot.time_step.value_or(scenario.time_step);
}

/// The method by which a robot of the scene chooses.
constexpr Method method_of(const Scenario& scenario, const RobotSetup& robot) {
  return robot.method.value_or(scenario.method);
}

/// The name of the method in tables: the scene's own where that is external.
inline std::string_view method_name(const Scenario& scenario) {
  if (is_external(scenario.method)) return scenario.external_method;
  return to_string(scenario.method);
}

/// The certificate that the robot's decisions never break.
constexpr Certificate certificate_of(const Scenario& scenario, const RobotSetup& robot) {
  const Method method = method_of(scenario, robot);
  const Certificate usual = usual_certificate(method);
  return method == scenario.method ? scenario.certificate.value_or(usual) : usual;
}

/// Returns whether another planner chooses the velocities of some of its robots.
AVO_API bool has_external(const Scenario& scenario);

/// [τ] s, > 0, of a robot of the scene: its own, the scene's, or the usual one of its method.
constexpr double time_horizon_of(const Scenario& scenario, const RobotSetup& robot) {
  if (robot.time_horizon) return *robot.time_horizon;
  const Method method = method_of(scenario, robot);
  const double usual = usual_time_horizon(method);
  return method == scenario.method ? scenario.time_horizon.value_or(usual) : usual;
}

/// m, > 0: the sensing radius that its robots need, whatever its sensing_radius. It covers the
/// range of their certificate (sensing_need()) and of their method's rules (docs/scenes.md, "How
/// far robots sense"). The scene must pass validate().
AVO_API double needed_sensing_radius(const Scenario& scenario);
/// m: how far its robots sense at the start: sensing_radius, or the radius that they need where
/// that is unset.
AVO_API double sensing_radius_of(const Scenario& scenario);

/// The error that covers the noise and the delay of the scene's robots. It is the bounds of the
/// noise, and the change of motion that the strongest of them can make within the delay. With
/// execution it adds how far a body is from its reference at most. Missed measurements are told by
/// Neighbor::age.
AVO_API SensingError declared_error(const Scenario& scenario);

/// m, > 0: a robot of the scene has arrived once it is that near to its goal.
constexpr double arrival_distance_of(const Scenario& scenario, const RobotSetup& robot) {
  return robot.arrival_distance.value_or(scenario.arrival_distance);
}

/// Throws Error naming the first field out of range, e.g. "robots.3.radius: found -0.2, must be
/// > 0 m".
AVO_API void validate(const Scenario& scenario);

/// The walls that a simulation makes of the parked robots, in their order.
AVO_API std::vector<Wall> parked_discs(const std::vector<RobotSetup>& robots);

/// The scene's settings; settings that it leaves unset have the values of its method.
AVO_API PlannerOptions planner_options(const Scenario& scenario);
/// The settings of one of its robots. The scene's control_time, response_time, comfort, margin,
/// time_horizon, certificate and sensing_error apply to robots of the scene's method. Other robots
/// have the usual options of their method.
AVO_API PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot);

/// Number of the last step that begins no later than `time` >= 0 (s), of a common clock: step k is
/// at k * time_step. A run of the whole scene takes last_step(scenario, scenario.duration) steps.
/// With either clock Simulation::can_step_by() tells whether it goes on.
AVO_API std::int64_t last_step(const Scenario& scenario, double time);

/// Returns one line for each setting (δ, τ, Δt, sensing radius) that does not fit the robots, with
/// the arithmetic. The list is empty if all is well. broken_assumptions() tells about the
/// assumptions of a certificate.
AVO_API std::vector<std::string> advice(const Scenario& scenario);

}  // namespace avo
