// SPDX-License-Identifier: Apache-2.0
// The valid ranges of the numbers of a scene: one place for validation, parser and schema.
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "avo/error.h"
#include "avo/vec.h"
#include "avo/vec3.h"

namespace avo::inline core {

/// Squares of lengths and limits, and of values computed from them, do not underflow above this.
inline constexpr double kSmallest = 1e-60;

/// A finite interval; open_min excludes its lower end, and values nearer to it than kSmallest.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool open_min = false;

  [[nodiscard]] constexpr bool below(double value) const {
    return open_min ? !(value > min && value >= min + kSmallest) : !(value >= min);
  }
  /// The message for a value below the range: it must be > or >= the least one.
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
  char buffer[32];  // a double has at most 24 characters
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

/// Far beyond any use, but small enough that squares and products stay finite.
inline constexpr double kLargest = 1e12;
inline constexpr Range kAnyValue{-kLargest, kLargest, false};
/// rad: with more turns an angle has too few digits left.
inline constexpr Range kAngle{-1e6, 1e6, false};
inline constexpr Range kPositive{0.0, kLargest, true};
inline constexpr Range kNotNegative{0.0, kLargest, false};
inline constexpr Range kAtLeastOne{1.0, std::numeric_limits<std::int32_t>::max(), false};

/// m, m/s, of measurements: the declared errors then stay in range.
inline constexpr Range kNoise{0.0, 1e9, false};
/// Share of the measurements that are missed: with 1 there would be no sensing.
inline constexpr Range kShareMissed{0.0, 0.999, false};
/// Standard deviations.
inline constexpr Range kTruncation{0.0, 8.0, true};

/// [δ] s: for a shorter one (v' - v)/δ is rounding, and exceeds a_max.
inline constexpr double kShortestControl = 1e-6;
/// [δ]: in a longer time step e^{-Δt/δ} underflows.
inline constexpr double kMostControlTimes = 700.0;

/// More are refused before anything is allocated.
inline constexpr std::int64_t kMostRobots = 1'000'000;
inline constexpr std::int64_t kMostSteps = 100'000'000;
/// With a certificate: the largest number of steps of braking from max_speed, which are computed
/// step by step.
inline constexpr std::int64_t kMostBrakingSteps = 65'000;

[[noreturn]] inline void refuse(const std::string& name, const std::string& given,
                                const std::string& allowed) {
  throw Error(name + ": found " + given + ", must be " + allowed);
}

/// Throws Error unless the range contains the value. The name, any type that converts to a string,
/// is converted only then.
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
template <typename Name>
void require(const Name& name, Vec3 value, std::string_view unit) {
  require(name, Vec2{value.x, value.y}, unit);
  if (!kAnyValue.contains(value.z)) require(std::string(name) + ".2", value.z, kAnyValue, unit);
}

}  // namespace avo::inline core
