// SPDX-License-Identifier: Apache-2.0
// The times at which robots decide, and what their drives make of a decision.
#pragma once
#include <cstdint>

namespace avo::safety {

/// The deviation of some of the robots from the rest.
enum class Oddity : std::uint8_t {
  none,
  one_sided,   ///< they use plan_among_movers instead of plan
  half_steps,  ///< they decide twice as often
};

struct Acting {
  std::int64_t ticks = 1;    ///< number of ticks in a step; states are judged at each tick
  bool phases = false;       ///< each robot decides at its own ticks, a step apart
  bool free_clock = false;   ///< all robots know that, and know the longest step
  std::int64_t jitter = 0;   ///< the largest deviation of the time between two decisions, in ticks
  std::int64_t latency = 0;  ///< ticks from a decision until the drive follows it
  double strength = 1.0;     ///< the part of a_max that the drive has
  Oddity oddity = Oddity::none;  ///< for about half of the robots
  /// m/s^2: every second, obstacles get another acceleration from a disc of this radius.
  double whims = 0.0;
};

}  // namespace avo::safety
