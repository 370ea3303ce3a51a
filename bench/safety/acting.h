// SPDX-License-Identifier: Apache-2.0
// When robots decide, and what their drives make of a decision.
#pragma once
#include <cstdint>

namespace avo::safety {

/// What some of the robots do otherwise than the rest.
enum class Oddity : std::uint8_t {
  none,
  one_sided,   ///< plan_among_obstacles instead of plan
  capsules,    ///< certificate stopping_capsules
  half_steps,  ///< they decide twice as often
};

struct Acting {
  std::int64_t ticks = 1;        ///< a step has so many; states are judged at each
  bool phases = false;           ///< each robot decides at ticks of its own, a step apart
  bool free_clock = false;       ///< and all of them know that, and the longest step
  std::int64_t jitter = 0;       ///< ticks by which the time between two decisions differs, at most
  std::int64_t latency = 0;      ///< ticks from a decision until the drive follows it
  double strength = 1.0;         ///< part of a_max that the drive has
  Oddity oddity = Oddity::none;  ///< of about half of the robots
  /// m/s^2: obstacles get another acceleration every second, in a disc of this radius.
  double whims = 0.0;
};

}  // namespace avo::safety
