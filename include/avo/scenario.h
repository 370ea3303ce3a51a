// SPDX-License-Identifier: Apache-2.0
// A scene as data: robots, moving obstacles, and how they are simulated. SI units.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/planner.h"
#include "avo/trajectory.h"
#include "avo/vec.h"
#include "avo/wall.h"

namespace avo {

/// Some of the layers 0 to 31, by which robots choose whom they avoid.
struct LayerSet {
  std::uint32_t bits = 0;  ///< bit k: layer k
  friend constexpr bool operator==(LayerSet, LayerSet) = default;
};

/// A robot as a scene lists it: where it starts, where it goes, what it can do.
struct RobotSetup {
  Vec2 position = {};  ///< m, see disc_center()
  /// m/s; of one with wheels its length counts, along the heading, or against it where it may drive
  /// backwards and the velocity points there.
  Vec2 velocity = {};
  Vec2 goal = {};                 ///< m
  double radius = 0.5;            ///< m, > 0, about the position; see disc_radius()
  double max_speed = 2.0;         ///< m/s, > 0
  double max_acceleration = 1.0;  ///< m/s^2, > 0
  double preferred_speed = 2.0;   ///< m/s, >= 0
  MotionModel model = {};         ///< how it moves
  double heading = 0.0;           ///< rad, counter-clockwise from +x; not of holonomic ones
  double priority = 1.0;          ///< > 0, see Robot::priority
  /// Never moves and decides nothing: to the others a disc that does not move, and that nobody may
  /// touch. Its goal is its position, and its velocity is 0.
  bool parked = false;
  LayerSet layers{1};           ///< that it is in; of one that is parked the usual ones
  LayerSet avoids{0xffffffff};  ///< it avoids those who are in one of these
  /// [Δt] s, > 0, whole nanoseconds: between its own decisions. Only where Scenario::clock is free;
  /// unset: the scene's.
  std::optional<double> time_step = {};
  /// [b] m/s^2, > 0, see Robot::max_braking; unset: max_acceleration
  std::optional<double> max_braking = {};
  /// What others count on: decides, or cooperates. Who reacts to nobody is a MovingObstacle.
  Behavior behavior = Behavior::decides;
  /// How it chooses its velocities; unset: as the scene says. One of another method than the
  /// scene's has what is customary for its own, see planner_options().
  std::optional<Method> method = {};
  std::optional<double> time_horizon = {};  ///< [τ] s, > 0; unset: that of its method

  friend bool operator==(const RobotSetup&, const RobotSetup&) = default;
};

/// Of the disc that others sense.
inline Vec2 disc_center(const RobotSetup& robot) {
  return disc_center(robot.model, robot.position, robot.heading);
}
inline double disc_radius(const RobotSetup& robot) {
  return disc_radius(robot.model, robot.radius);
}

/// Whether A avoids B by their layers. To A, one that does not avoid A is a mover: it reacts to
/// nobody (docs/certificate/movers.md). So is one that avoids A by another method, to A of
/// method avo: it promises nothing (docs/certificate/movers.md, "Robots of other methods").
constexpr bool avoids(const RobotSetup& a, const RobotSetup& b) {
  return (a.avoids.bits & b.layers.bits) != 0;
}

/// Whether the two may not be in one place: one of them avoids the other, or is parked.
constexpr bool keep_apart(const RobotSetup& a, const RobotSetup& b) {
  return a.parked || b.parked || avoids(a, b) || avoids(b, a);
}

/// A disc that reacts to nobody. It moves with constant acceleration, along a path, or as a
/// trajectory says.
struct MovingObstacle {
  Vec2 position = {};      ///< m
  Vec2 velocity = {};      ///< m/s
  Vec2 acceleration = {};  ///< m/s^2; 0 with max_speed
  double radius = 0.5;     ///< m, > 0
  /// m/s^2, >= 0: robots count on its acceleration being so far from that one, at any time.
  double max_deviation = 0.0;
  std::optional<double> max_speed = {};  ///< m/s, > 0, with max_deviation: that it never exceeds
  /// m: it goes for these points one after the other and then for the first again, see
  /// next_on_path(). With max_deviation and max_speed; empty: it has none. Robots that sense
  /// exactly and decide at the same times know where it will be.
  std::vector<Vec2> path = {};
  /// By ascending times: it goes straight and evenly from each of these to the next. Before the
  /// first time and after the last one it stands there. Its position and velocity have to be those
  /// at 0 s, see start_on_trajectory(); it has no acceleration and no path. Empty: it has none.
  std::vector<TimedPlace> trajectory = {};
};

/// Where a moving obstacle is on its path at the beginning of a step.
struct PathWalk {
  Vec2 position, velocity;   ///< m, m/s
  std::uint32_t target = 0;  ///< index of the point that it goes for
};
/// One step on, with an acceleration held over the step that is within max_deviation: straight for
/// the target, as fast as max_speed and stopping there allow. It has reached a point when its disc
/// covers it.
AVO_API PathWalk next_on_path(const MovingObstacle& obstacle, const PathWalk& walk,
                              double time_step);

/// Where it is on its trajectory at a time, and with what velocity it goes on; at the ends of
/// steps: within a step it goes straight from one to the other. target: index of the place that it
/// goes for.
AVO_API PathWalk on_trajectory(const MovingObstacle& obstacle, double time);
/// Puts it where its trajectory has it at 0 s, if it has one.
AVO_API void start_on_trajectory(MovingObstacle& obstacle);

/// How robots on their ways know who else is about to go through a narrow passage.
enum class RightOfWay : std::uint8_t {
  none,  ///< they heed no passages
  seen,  ///< by where each one is and how it moves
  told,  ///< each one tells by which passage it goes, and in which direction
};
AVO_API const char* to_string(RightOfWay right_of_way);

/// Of MeasurementNoise.
enum class NoiseDistribution : std::uint8_t { gaussian, uniform };
AVO_API const char* to_string(NoiseDistribution distribution);

/// How far each coordinate of a measurement is off, by itself and each time anew.
struct MeasurementNoise {
  double position = 0.0;  ///< m, >= 0: standard deviation; of uniform noise the bound
  double velocity = 0.0;  ///< m/s, >= 0: likewise
  NoiseDistribution distribution = NoiseDistribution::gaussian;
  /// Gaussian noise stays within so many standard deviations, > 0, <= 8; unset: 3. Uniform noise
  /// has none.
  std::optional<double> truncated = {};
  friend constexpr bool operator==(const MeasurementNoise&, const MeasurementNoise&) = default;
};

/// How far each coordinate of where a robot takes itself to be is off, each time anew. It knows its
/// velocity and heading.
struct LocalizationNoise {
  double position = 0.0;  ///< m, >= 0: standard deviation; of uniform noise the bound
  NoiseDistribution distribution = NoiseDistribution::gaussian;
  std::optional<double> truncated = {};  ///< as of MeasurementNoise
  friend constexpr bool operator==(const LocalizationNoise&, const LocalizationNoise&) = default;
};

/// How robots sense others and themselves: what a simulation makes of the true states before
/// anybody sees them. All of it depends on the seed, the step and the two robots alone
/// (docs/scenes.md, "Sensing").
struct SensingModel {
  MeasurementNoise noise = {};
  /// Whole steps, 0 to kMostDelay, from a measurement to the decision; carried on meanwhile.
  int delay = 0;           ///< where the clock is free, steps of Scenario::time_step
  double dropped = 0.0;    ///< 0 to 0.999: share of the measurements that are missed
  bool occlusion = false;  ///< nobody is sensed whose center is behind an obstacle
  /// Others are sensed relative to the robot; what it knows of the map is off by this: walls, and
  /// its goal.
  LocalizationNoise localization = {};
  friend constexpr bool operator==(const SensingModel&, const SensingModel&) = default;

  /// Others look as they are, and all know where they are.
  [[nodiscard]] constexpr bool is_exact() const { return *this == SensingModel{}; }
  /// Some may be sensed in one step and not in the next, and are carried on meanwhile.
  [[nodiscard]] constexpr bool misses() const { return dropped > 0.0 || occlusion; }
};
inline constexpr double kUsualTruncation = 3.0;  ///< standard deviations
inline constexpr int kMostDelay = 100;           ///< steps
/// Steps for which one that is missed is carried on, with its Neighbor::age; then it is forgotten.
inline constexpr int kMostCarried = 10;

/// A scene: who moves, among what, and how that is simulated. Its fields are the keys of scene
/// files.
struct Scenario {
  std::string name = {};
  double time_step = 0.1;  ///< [Δt] s, > 0; whole nanoseconds where the clock is free
  double duration = 60.0;  ///< s, >= time_step
  std::optional<double> control_time = {};   ///< [δ] s, > 0; unset: default_options(method)
  std::optional<double> response_time = {};  ///< [κ] >= 0, of T = v_max/a_max; likewise
  /// m/s², > 0, of method avo: see PlannerOptions; unset: none
  std::optional<double> comfort_acceleration = {};
  std::optional<double> comfort_jerk = {};    ///< m/s³, likewise
  double margin = 0.0;                        ///< [m] m, >= 0, of method avo: see PlannerOptions
  bool never_swerves = false;                 ///< of method avo: see PlannerOptions
  std::optional<double> time_horizon = {};    ///< [τ] s, > 0; likewise
  std::optional<double> sensing_radius = {};  ///< m, > 0, between centers; unset: what they need
  std::optional<int> max_neighbors = {};  ///< nearest neighbors that get a half-plane; unset: all
  Method method = Method::avo;
  std::optional<Certificate> certificate = {};  ///< unset: default_options(method)
  Motion motion = Motion::held;
  int samples = 0;                ///< 0: exact half-planes; 2 to 1000: the paper's samples
  double arrival_distance = 0.5;  ///< m, > 0
  std::uint64_t seed = 1;         ///< of random placements
  std::vector<RobotSetup> robots = {};
  std::vector<MovingObstacle> moving_obstacles = {};
  std::vector<StaticObstacle> obstacles = {};  ///< that do not move; nobody may touch them
  /// The preferred velocity follows a path around the obstacles, and around moving ones at rest;
  /// unset: where there are any.
  std::optional<bool> navigation = {};
  RightOfWay right_of_way = RightOfWay::seen;  ///< at passages, with navigation
  SensingModel sensing = {};
  /// What the robots declare to braking_trajectories; unset: declared_error() of `sensing`.
  std::optional<SensingError> sensing_error = {};
  /// free: each robot decides at times of its own, its own time_step apart, from a phase that the
  /// seed gives it (docs/scenes.md, "Clocks").
  Clock clock = Clock::common;
  /// s, where the clock is free: the longest time_step that any robot may have, those that are
  /// added later too; unset: that of the scene's robots.
  std::optional<double> longest_step = {};
  /// Simulations of the scene are made whatever broken_assumptions() finds, and robots may be added
  /// and moved to wherever they break what the certificate assumes, as onto others. They part then,
  /// and nothing is promised until they have.
  bool allow_broken_assumptions = false;
};

/// s, between decisions of one of the scene's robots.
constexpr double time_step_of(const Scenario& scenario, const RobotSetup& robot) {
  return robot.time_step.value_or(scenario.time_step);
}

/// By which one of the scene's robots chooses.
constexpr Method method_of(const Scenario& scenario, const RobotSetup& robot) {
  return robot.method.value_or(scenario.method);
}

/// What its decisions never break.
constexpr Certificate certificate_of(const Scenario& scenario, const RobotSetup& robot) {
  const Method method = method_of(scenario, robot);
  const Certificate usual = usual_certificate(method);
  return method == scenario.method ? scenario.certificate.value_or(usual) : usual;
}

/// [τ] s, > 0, of one of the scene's robots: its own, the scene's, or what its method is used with.
constexpr double time_horizon_of(const Scenario& scenario, const RobotSetup& robot) {
  if (robot.time_horizon) return *robot.time_horizon;
  const Method method = method_of(scenario, robot);
  const double usual = usual_time_horizon(method);
  return method == scenario.method ? scenario.time_horizon.value_or(usual) : usual;
}

/// m, > 0: the sensing radius that its robots need, whatever its sensing_radius: the range of their
/// certificate (sensing_need()) and of their method's rules (docs/scenes.md, "How far robots
/// sense"). The scene has to pass validate().
AVO_API double needed_sensing_radius(const Scenario& scenario);
/// m: how far its robots sense at the start: sensing_radius, or where that is unset what they need.
AVO_API double sensing_radius_of(const Scenario& scenario);

/// What covers the noise and the delay of the scene's robots: the bounds of the noise, and what the
/// strongest of them can do within the delay. Missed measurements are told by Neighbor::age.
AVO_API SensingError declared_error(const Scenario& scenario);

/// Throws Error naming the first field out of range, e.g. "robots.3.radius: found -0.2, must be
/// > 0 m".
AVO_API void validate(const Scenario& scenario);

/// What a simulation makes of the parked robots, in their order.
AVO_API std::vector<Wall> parked_discs(const std::vector<RobotSetup>& robots);

/// The scene's settings, with its method's own for what it leaves unset.
AVO_API PlannerOptions planner_options(const Scenario& scenario);
/// Those of one of its robots. What the scene says of control_time, response_time, comfort, margin,
/// time_horizon, certificate and sensing_error is said to robots of the scene's method; others have
/// what is customary for theirs.
AVO_API PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot);

/// Number of the last step that begins no later than `time` >= 0 (s), of a common clock: step k is
/// at k * time_step. A run of the whole scene takes last_step(scenario, scenario.duration) steps.
/// With either clock Simulation::can_step_by() tells whether it goes on.
AVO_API std::int64_t last_step(const Scenario& scenario, double time);

/// One line for each setting that does not fit the robots (δ, τ, Δt, sensing radius), with the
/// arithmetic; empty where all is well. What a certificate assumes is told by broken_assumptions().
AVO_API std::vector<std::string> advice(const Scenario& scenario);

}  // namespace avo
