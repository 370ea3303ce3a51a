// SPDX-License-Identifier: Apache-2.0
// What values the numbers of a scene may take: one place for validation, parser and schema.
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace avo {

/// A finite interval; open_min excludes its lower end.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool open_min = false;

  [[nodiscard]] constexpr bool below(double value) const {
    return open_min ? !(value > min) : !(value >= min);
  }
  [[nodiscard]] bool contains(double value) const {
    return std::isfinite(value) && !below(value) && value <= max;
  }
};

/// The shortest form of a number that reads back to it.
inline std::string text(double value) {
  char buffer[32];  // of a double at most 24 characters
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

/// Far beyond any use, small enough that squares and products stay finite.
inline constexpr double kLargest = 1e12;
inline constexpr Range kAnyValue{-kLargest, kLargest, false};
inline constexpr Range kPositive{0.0, kLargest, true};
inline constexpr Range kNotNegative{0.0, kLargest, false};
inline constexpr Range kAtLeastOne{1.0, std::numeric_limits<std::int32_t>::max(), false};
/// Boundary samples a side: 0 (exact) or from 2. A decision takes time by their square.
inline constexpr Range kSamples{0.0, 1000.0, false};

/// [δ] s: (v' - v)/δ of a shorter one is rounding, and exceeds a_max.
inline constexpr double kShortestControl = 1e-6;
/// [δ]: in a longer time step e^{-Δt/δ} underflows.
inline constexpr double kMostControlTimes = 700.0;

/// Refused before anything is allocated.
inline constexpr std::int64_t kMostRobots = 1'000'000;
inline constexpr std::int64_t kMostSteps = 100'000'000;
/// With a certificate: braking from max_speed is looked at step by step.
inline constexpr std::int64_t kMostBrakingSteps = 65'000;

}  // namespace avo
