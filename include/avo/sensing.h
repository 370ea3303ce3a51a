// SPDX-License-Identifier: Apache-2.0
// How a simulated robot senses others, and how its measurements err. SI units.
#pragma once
#include <cstdint>
#include <optional>

#include "avo/export.h"

namespace avo {

/// The distribution of MeasurementNoise.
enum class NoiseDistribution : std::uint8_t { gaussian, uniform };
AVO_API const char* to_string(NoiseDistribution distribution);

/// The error of each coordinate of a measurement, independent and new each time.
struct MeasurementNoise {
  double position = 0.0;  ///< m, >= 0: standard deviation; for uniform noise the bound
  double velocity = 0.0;  ///< m/s, >= 0: standard deviation; for uniform noise the bound
  NoiseDistribution distribution = NoiseDistribution::gaussian;
  /// Gaussian noise stays within so many standard deviations, > 0, <= 8; unset: 3. Uniform noise
  /// has no truncation.
  std::optional<double> truncated = {};
  friend constexpr bool operator==(const MeasurementNoise&, const MeasurementNoise&) = default;
};

/// The error of each coordinate of a robot's own position, new each time. A robot knows its
/// velocity and heading.
struct LocalizationNoise {
  double position = 0.0;  ///< m, >= 0: standard deviation; for uniform noise the bound
  NoiseDistribution distribution = NoiseDistribution::gaussian;
  std::optional<double> truncated = {};  ///< see MeasurementNoise
  friend constexpr bool operator==(const LocalizationNoise&, const LocalizationNoise&) = default;
};

/// How robots sense others and themselves: what a simulation makes of the true states before a
/// robot uses them. All of it depends on the seed, the step and the two robots alone
/// (docs/scenes.md, "Sensing").
struct SensingModel {
  MeasurementNoise noise = {};
  /// Whole steps, 0 to kMostDelay, from a measurement to the decision; states are extrapolated
  /// meanwhile.
  int delay = 0;           ///< where the clock is free, steps of Scenario::time_step
  double dropped = 0.0;    ///< 0 to 0.999: share of the measurements that are missed
  bool occlusion = false;  ///< a robot is not sensed if its center is behind an obstacle
  /// Others are sensed relative to the robot. This is the error of the map that it knows: walls,
  /// and its goal.
  LocalizationNoise localization = {};
  friend constexpr bool operator==(const SensingModel&, const SensingModel&) = default;

  /// Returns whether robots sense the true states of others and of themselves.
  [[nodiscard]] constexpr bool is_exact() const { return *this == SensingModel{}; }
  /// Returns whether a robot may be sensed in one step and not in the next; it is extrapolated
  /// meanwhile.
  [[nodiscard]] constexpr bool misses() const { return dropped > 0.0 || occlusion; }
};
inline constexpr double kUsualTruncation = 3.0;  ///< standard deviations
inline constexpr int kMostDelay = 100;           ///< steps
/// Steps for which a missed robot is extrapolated, with its Neighbor::age; then it is forgotten.
inline constexpr int kMostCarried = 10;

}  // namespace avo
