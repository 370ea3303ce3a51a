// SPDX-License-Identifier: Apache-2.0
// How a robot decides, and what its decisions allow for. SI units.
#pragma once
#include <cstdint>
#include <optional>

#include "avo/export.h"
#include "avo/method.h"

namespace avo {

/// How the velocity changes between two decisions.
enum class Motion : std::uint8_t {
  held,         ///< the acceleration (v' - v)/δ is held over the step (§III-C's cycle)
  exponential,  ///< Eqs. (8), (9) exactly
};

/// When the robots under a certificate decide.
enum class Clock : std::uint8_t {
  common,  ///< all at the same times
  free,    ///< each robot at its own times, one time_step of its own apart
};

/// Bounds on the errors of the positions and velocities that are sensed of neighbors.
struct SensingError {
  double position = 0.0;  ///< m, >= 0
  double velocity = 0.0;  ///< m/s, >= 0
  friend constexpr bool operator==(const SensingError&, const SensingError&) = default;
};

/// Gaussian errors of each sensed coordinate, for the half-planes. The half-planes keep a margin
/// that the errors exceed only with the probability 1 - Φ(quantile). Certificates use SensingError
/// instead.
struct SensingNoise {
  double position = 0.0;  ///< [σ_p] m, >= 0
  double velocity = 0.0;  ///< [σ_v] m/s, >= 0
  double quantile = 1.0;  ///< [q] standard deviations, >= 0
  friend constexpr bool operator==(const SensingNoise&, const SensingNoise&) = default;
};

/// Returns the name that scene files use.
AVO_API const char* to_string(Motion motion);
AVO_API const char* to_string(Clock clock);

/// Options that a planner is given once. All robots must agree on the options that others count on
/// (docs/certificate.md, "What has to be common"). The usual values follow the method at
/// construction, PlannerOptions{.method = Method::orca}; a method that is set later changes no
/// other option.
struct PlannerOptions {
  Method method = Method::avo;
  Motion motion = Motion::held;
  /// [δ] s, >= 1e-6 unless v' is adopted at once, Eq. (7). Where v' is reached within a step,
  /// Planner::options() has time_step here.
  double control_time = usual_control_time(method);
  double time_horizon = usual_time_horizon(method);  ///< [τ] s, > 0, Definition 2
  /// [κ] >= 0, in units of T = v_max/a_max; 0 except with method avo. The robot approaches v' with
  /// the time constant response_time_of(), and its preferred velocity with twice that time
  /// constant. The acceleration rises from 0 to a_max in 0.8 of the time constant. The certificate
  /// may ask for more (docs/smoothness.md). 0: v' is adopted at once.
  double response_time = usual_response_time(method);
  /// m/s², > 0, of method avo: the part of a_max that is used unless the certificate asks for more.
  /// The certificate counts on all of a_max. Unset: all. Airplanes use all.
  std::optional<double> comfort_acceleration = {};
  /// m/s³, > 0, of method avo: the largest change of the acceleration in a second. Exceptions are a
  /// certificate that asks for more, and a robot that begins to come to rest (docs/smoothness.md).
  /// Unset: a_max in 0.8 of the response time.
  std::optional<double> comfort_jerk = {};
  /// [m] m, >= 0; 0 except with method avo: the clearance from others that is preferred beyond the
  /// radius. It fades in narrow places and near the robot's goal, and no promise depends on it
  /// (docs/scenes.md, "Margin").
  double margin = 0.0;
  /// [Δt] s, > 0, <= time_horizon, <= control_time where motion is held, else <= 700 control_time
  double time_step = 0.1;
  /// none except with method avo, and with methods that reach v' within a step
  Certificate certificate = usual_certificate(method);
  /// >= 1: only the nearest so many neighbors get a half-plane, except neighbors that walls keep
  /// away; unset: all. A certificate covers all neighbors in any case.
  std::optional<int> max_neighbors = {};
  SensingError sensing_error = {};  ///< for braking_trajectories; each robot declares its own error
  SensingNoise sensing_noise = {};  ///< for the half-planes
  /// [ε] m, >= 0: the error of the robot's own position among the walls. The robot must sense its
  /// neighbors relative to its true position. A certificate keeps clear of walls in spite of the
  /// error, and needs the walls that are so much farther away.
  double localization_error = 0.0;
  /// m, >= 0, from the robot's disc: all walls within this range are given, where it is farther
  /// than the certificate needs; infinite: all walls. A longer range gives a robot more evasive
  /// maneuvers before movers (docs/movers.md).
  double wall_range = 0.0;
  /// free: motion held (docs/certificate/clocks.md).
  Clock clock = Clock::common;
  /// s, >= 0, with a free clock: the largest time_step of any other robot; 0: the time_step of this
  /// robot.
  double longest_step = 0.0;
  /// m, > 0, of the robot's goal. Beside others, a robot of method avo that has been there rests
  /// within 0.9 of this distance. It rests within 3.9 of this distance where the others leave it no
  /// route back (docs/arrival.md, rule 2).
  double arrival_distance = 0.5;
  /// For method avo. true: a mover that moves as predicted touches a robot only at rest, always.
  /// false: where braking comes too late, a robot alone among movers that keep their acceleration
  /// may pass in front of a mover. It may then be unable to stop before the mover (docs/movers.md,
  /// "Rule").
  bool never_swerves = false;
};

/// Returns the usual options of the method.
AVO_API PlannerOptions default_options(Method method);

/// [T_e] s, the time constant with which a robot of these limits (m/s, m/s²) approaches v'. It is
/// min(max(response_time v_max/a_max, 2 Δt), δ), or a/(0.8 comfort_jerk) where that is more; a is
/// the used part of a_max. 0: v' is adopted at once.
AVO_API double response_time_of(const PlannerOptions& options, double max_speed,
                                double max_acceleration);

}  // namespace avo
