// SPDX-License-Identifier: Apache-2.0
// Ways out: motions of a robot A that keep clear of all who are predicted, for ever
// (docs/movers.md). Places are of A's disc, relative to p_A, and times count from the decision.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/predicted.h"
#include "walls/segment.h"

namespace avo::inline certificate {

/// A wall, as ways see it.
struct KeptWall {
  Segment segment;
  double kept = 0.0;         ///< m, by A's center
  double clear_until = 0.0;  ///< s, whatever A does; 0: not known
};

/// A state on a way.
struct WayState {
  Vec2 position, velocity;  // m, m/s
  double time = 0.0;        // s
  double heading = 0.0;     // rad; not of holonomic robots
};

/// What all ways of one decision have in common.
struct WayOptions {
  StepLaw law;
  double increment = 0.0;  ///< m/s a step, on the way
  double decrement = 0.0;  ///< [u_b] m/s a step, of braking, which is full
  double max_speed = 0.0;  ///< m/s, that the disc never exceeds
  double longest = 0.0;    ///< s, until A brakes
  /// m: the center stays that near to p_A, where A knows the walls.
  double known = std::numeric_limits<double>::infinity();
  const Robot* wheels = nullptr;  ///< A, unless it is holonomic
};

/// An interval of braking, once somebody has asked for it.
struct KnownInterval {
  Hull path;
  std::uint64_t braking = 0;  // number of the braking path whose interval it is
};

/// Scratch memory; allocates only while it grows.
struct Surroundings {
  std::vector<Predicted> others;
  std::vector<TrajectorySteps> trajectories;  // of those of the others whose trajectories are known
  std::vector<KeptWall> walls;
  // s, until which nothing that A does matters to each of the others: from now on, from the first
  // step on, and from the last state of a way on
  std::vector<double> clear_now, clear_after, clear_until;
  WayState after;          // the first step
  double brakes_at = 0.0;  // s: when the last way begins to brake that was found clear
  std::vector<KnownInterval> intervals;  // of the last braking path
  std::uint64_t brakings = 0;            // paths of braking until now
  std::size_t in_the_way = 0;  // of the others, who touched A in the last that was not clear
  /// So much may still be looked at in this decision; no way is clear once that is used up.
  int work = std::numeric_limits<int>::max();

  void reserve(std::size_t most_others, std::size_t braking_steps);
};

/// Begins ways among others and walls that have been filled in.
void begin_ways(const WayOptions& options, Surroundings& around);

/// [v_1] m/s, by which a way goes on towards the velocity w.
Vec2 next_towards(const WayOptions& options, const WayState& from, Vec2 w);

/// Whether the first step, to v_1, keeps clear, (C1) and (C3). The following are of what comes
/// behind it.
bool take_first_step(const WayOptions& options, Surroundings& around, const WayState& now,
                     Vec2 next_velocity);
/// Whether A keeps clear, (C1) to (C3), if it brakes.
bool may_brake(const WayOptions& options, Surroundings& around);
/// The same if it goes on towards the velocity w for some steps, and brakes then.
bool may_approach(const WayOptions& options, Surroundings& around, Vec2 w);

/// (C2) of a step and of braking after it: what the certificate asks of A towards movers.
bool stops_in_time(const WayOptions& options, const Surroundings& around, const WayState& now,
                   Vec2 next_velocity);

}  // namespace avo::inline certificate
