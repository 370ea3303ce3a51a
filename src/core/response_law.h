// SPDX-License-Identifier: Apache-2.0
// How gently robots move, from the options of a planner (docs/smoothness.md).
#pragma once
#include <limits>

#include "avo/planner.h"

namespace avo::inline core {

/// Means no limit of a change. It is finite, so that nothing is undefined where nothing changes.
inline constexpr double kUnlimited = std::numeric_limits<double>::max();

struct ResponseLaw {
  double time_step = 0.1, control_time = 0.1;  ///< s
  double response_time = 0.0;                  ///< [κ], in units of v_max/a_max
  double comfort_acceleration = kUnlimited;    ///< m/s², kUnlimited without a request
  double comfort_jerk = kUnlimited;            ///< m/s³, kUnlimited without a request

  /// If false, v' is adopted at once.
  bool is_gentle() const { return response_time > 0.0 || comfort_jerk < kUnlimited; }
};

inline ResponseLaw response_law(const PlannerOptions& options) {
  return {.time_step = options.time_step,
          .control_time = options.control_time,
          .response_time = options.response_time,
          .comfort_acceleration = options.comfort_acceleration.value_or(kUnlimited),
          .comfort_jerk = options.comfort_jerk.value_or(kUnlimited)};
}

}  // namespace avo::inline core
