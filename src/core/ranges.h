// SPDX-License-Identifier: Apache-2.0
// What values the numbers of a scene may take: one place for validation, parser and schema.
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "avo/error.h"
#include "avo/vec.h"

namespace avo::inline core {

/// Lengths and limits whose squares, and those of what is made of them, do not underflow.
inline constexpr double kSmallest = 1e-60;

/// A finite interval; open_min excludes its lower end, and what is nearer to it than kSmallest.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool open_min = false;

  [[nodiscard]] constexpr bool below(double value) const {
    return open_min ? !(value > min && value >= min + kSmallest) : !(value >= min);
  }
  /// What a value below it is told: that it must be > or >= the least one.
  [[nodiscard]] constexpr bool is_open_to(double value) const { return open_min && value <= min; }
  [[nodiscard]] constexpr double least(double value) const {
    return open_min && value > min ? min + kSmallest : min;
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
/// rad: of more turns too little would be left of an angle.
inline constexpr Range kAngle{-1e6, 1e6, false};
inline constexpr Range kPositive{0.0, kLargest, true};
inline constexpr Range kNotNegative{0.0, kLargest, false};
inline constexpr Range kAtLeastOne{1.0, std::numeric_limits<std::int32_t>::max(), false};
/// Boundary samples a side: 0 (exact) or from 2. A decision takes time by their square.
inline constexpr Range kSamples{0.0, 1000.0, false};

/// m, m/s, of measurements: what is declared for it stays in range.
inline constexpr Range kNoise{0.0, 1e9, false};
/// Of the measurements that are missed: all would be nobody's sensing.
inline constexpr Range kShareMissed{0.0, 0.999, false};
/// Standard deviations.
inline constexpr Range kTruncation{0.0, 8.0, true};

/// [δ] s: (v' - v)/δ of a shorter one is rounding, and exceeds a_max.
inline constexpr double kShortestControl = 1e-6;
/// [δ]: in a longer time step e^{-Δt/δ} underflows.
inline constexpr double kMostControlTimes = 700.0;

/// Refused before anything is allocated.
inline constexpr std::int64_t kMostRobots = 1'000'000;
inline constexpr std::int64_t kMostSteps = 100'000'000;
/// With a certificate: braking from max_speed is looked at step by step.
inline constexpr std::int64_t kMostBrakingSteps = 65'000;

[[noreturn]] inline void refuse(const std::string& name, const std::string& given,
                                const std::string& allowed) {
  throw Error(name + ": found " + given + ", must be " + allowed);
}

/// Throws Error unless the range contains the value. The name, anything that a string can be made
/// of, is spelled out only then.
template <typename Name>
void require(const Name& name, double value, const Range& range, std::string_view unit) {
  if (range.contains(value)) return;
  if (!std::isfinite(value)) refuse(std::string(name), text(value), "a finite number");
  std::string allowed = "<= " + text(range.max);
  if (range.below(value))
    allowed = (range.is_open_to(value) ? "> " : ">= ") + text(range.least(value));
  if (!unit.empty()) allowed.append(" ").append(unit);
  refuse(std::string(name), text(value), allowed);
}
template <typename Name>
void require(const Name& name, Vec2 value, std::string_view unit) {
  if (kAnyValue.contains(value.x) && kAnyValue.contains(value.y)) return;
  require(std::string(name) + ".0", value.x, kAnyValue, unit);
  require(std::string(name) + ".1", value.y, kAnyValue, unit);
}

}  // namespace avo::inline core
