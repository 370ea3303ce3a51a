// SPDX-License-Identifier: Apache-2.0
// Clocks of the robots' own: who decides when, and where all are in between.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/fleet.h"

namespace avo {

struct World;

/// s: a longer step, or a run, counts no nanoseconds.
inline constexpr double kMostClockTime = 1e9;

/// Nothing where the time is no whole number of nanoseconds.
std::optional<Instant> whole_nanoseconds(double seconds);
inline double seconds(Instant instant) {
  return static_cast<double>(instant) / 1e9;
}

/// Of a time that is some, see whole_nanoseconds().
inline Instant nanoseconds(double seconds) {
  return static_cast<Instant>(std::llround(seconds * 1e9));
}
inline Instant step_of(const OwnClock& clock) {
  return nanoseconds(clock.time_step);
}

/// Where the robot is in the midst of a step between these two states, 0 <= time < duration.
MotionState on_the_way(const World& world, std::size_t slot, const MotionState& from,
                       const MotionState& to, Instant time, Instant duration);

/// Of a robot that has come now: it brakes until its phase, which the seed and its id tell.
void start_clock(World& world, std::size_t slot);

/// The robot, which has been put to where it has decided to be, is back at the start of that step,
/// where the one before ended.
void begin_step(World& world, std::size_t slot);

/// How many steps the robot has been through, as it counts them.
std::int64_t decisions_of(const World& world, std::size_t slot);

/// When the next step ends: who decides now has decided by then.
Instant next_instant(const World& world);

/// Moves all robots to where they are then, no later than any of their steps ends.
void carry_on(World& world, Instant instant);

}  // namespace avo
