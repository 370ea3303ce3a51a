// SPDX-License-Identifier: Apache-2.0
// Clocks of the robots' own: who decides when, and where all are in between.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/fleet.h"

namespace avo::inline sim {

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

/// Who decides when.
struct Agenda {
  using Entry = std::pair<Instant, std::uint32_t>;  // rank
  std::vector<Entry> later;                         // the earliest on top of the heap
  std::vector<std::uint32_t> now;                   // ranks
};

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

/// Of all robots that are there.
void make_agenda(World& world);

/// When the next step ends: who decides now has decided by then.
Instant next_instant(const World& world);

/// Time goes on to then, no later than any of their steps ends, when those who decided now are on
/// their way. Nobody is put to where it is by then, but by catch_up().
void carry_on(World& world, Instant instant);

/// Where the robot is now.
MotionState present_state(const World& world, std::size_t slot);
/// Puts the robot there.
void put_in_place(World& world, std::size_t slot);
/// Puts all robots to where they are now, if they are not.
void catch_up(World& world);

}  // namespace avo::inline sim
