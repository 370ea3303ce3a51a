// SPDX-License-Identifier: Apache-2.0
// Each robot's own clock: when the robots decide, and where all robots are in between.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/columns/fleet.h"

namespace avo::inline sim {

struct World;

/// s: longer steps, or longer runs, cannot be counted in nanoseconds.
inline constexpr double kMostClockTime = 1e9;

/// None where the time is no whole number of nanoseconds.
std::optional<Instant> whole_nanoseconds(double seconds);
inline double seconds(Instant instant) {
  return static_cast<double>(instant) / 1e9;
}

/// Converts a time that is a whole number of nanoseconds, see whole_nanoseconds().
inline Instant nanoseconds(double seconds) {
  return static_cast<Instant>(std::llround(seconds * 1e9));
}
inline Instant step_of(const OwnClock& clock) {
  return nanoseconds(clock.time_step);
}

/// When each robot decides.
struct Agenda {
  using Entry = std::pair<Instant, std::uint32_t>;  // rank
  std::vector<Entry> later;                         // the earliest on top of the heap
  std::vector<std::uint32_t> now;                   // ranks
};

/// The robot's state within a step between these two states, 0 <= time < duration.
MotionState state_within(const World& world, std::size_t slot, const MotionState& from,
                         const MotionState& to, Instant time, Instant duration);

/// Starts the clock of a robot that has just come: it brakes until its phase, which follows from
/// the seed and its id.
void start_clock(World& world, std::size_t slot);

/// Begins a step: the robot is at the end state that it has decided on. It is put back to the start
/// of the step, where the step before ended.
void begin_step(World& world, std::size_t slot);

/// The number of steps that the robot has completed by its own count.
std::int64_t decisions_of(const World& world, std::size_t slot);

/// Makes the agenda of all present robots.
void make_agenda(World& world);

/// The end of the next step; robots that decide now have decided by then.
Instant next_instant(const World& world);

/// Advances the time to that instant, which is no later than the end of any robot's step; robots
/// that decided now are then in motion. No robot is moved to its present place, except by
/// catch_up().
void carry_on(World& world, Instant instant);

/// Where the robot is now.
MotionState present_state(const World& world, std::size_t slot);
/// Puts the robot into its present state.
void put_in_place(World& world, std::size_t slot);
/// Puts all robots into their present states, if they are not.
void catch_up(World& world);

}  // namespace avo::inline sim
