// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers: motions of a robot A that keep clear of all predicted movers, for ever
// (docs/movers.md). Places are of A's disc, relative to p_A, and times count from the decision.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/evasion_discs.h"
#include "certificate/predicted.h"
#include "walls/segment.h"

namespace avo::inline certificate {

/// A wall for the test of evasive maneuvers.
struct KeptWall {
  Segment segment;
  double kept = 0.0;         ///< m, by the center of A's disc, or of each disc of its footprint
  double clear_until = 0.0;  ///< s, until then no motion of A can touch it; 0: not known
};

/// A state on an evasive maneuver.
struct EvasionState {
  Vec2 position, velocity;  // m, m/s
  double time = 0.0;        // s
  double heading = 0.0;     // rad; not of holonomic robots
};

/// The common values of all evasive maneuvers of one decision.
struct EvasionOptions {
  StepLaw law;
  double increment = 0.0;  ///< m/s a step, while the evasive maneuver approaches its velocity
  double decrement = 0.0;  ///< [u_b] m/s a step, of full braking
  double max_speed = 0.0;  ///< m/s, that the disc never exceeds
  double longest = 0.0;    ///< s, until A brakes
  /// m: the center stays within this distance of p_A, where A knows the walls.
  double known = std::numeric_limits<double>::infinity();
  const Robot* wheels = nullptr;  ///< A, unless it is holonomic
  Footprint footprint = {};       ///< of A; none: one disc about its position
  double lever = 0.0;             ///< m, from A's position to the farthest center of its footprint
};

/// An interval of braking, once it has been computed.
struct KnownInterval {
  Hull path;
  std::uint64_t braking = 0;  // number of the braking path to which the interval belongs
};

/// Scratch memory; allocates only while it grows.
struct Surroundings {
  std::vector<Predicted> others;
  std::vector<TrajectorySteps> trajectories;  // of the movers with known trajectories
  std::vector<KeptWall> walls;
  // s, until these times no motion of A matters to each of the others. They are counted from now
  // on, from the first step on, and from the last state of an evasive maneuver on.
  std::vector<double> clear_now, clear_after, clear_until;
  EvasionState after;  // the state after the first step
  // of a robot that flies: the state in which the last evasive maneuver begins to circle
  EvasionState last;
  double brakes_at = 0.0;  // s: the time at which the last clear evasive maneuver begins to brake
  std::vector<KnownInterval> intervals;  // of the last braking path
  std::uint64_t brakings = 0;            // number of braking paths until now
  EvasionDiscs discs;                    // of a robot with a footprint
  // index of the mover that touched A in the last evasive maneuver that was not clear
  std::size_t refused_by = 0;
  /// The work that is left for this decision; no evasive maneuver counts as clear once it is used
  /// up.
  int work = std::numeric_limits<int>::max();

  void reserve(std::size_t most_others, std::size_t braking_steps);
};

/// Begins the search of evasive maneuvers among the others and walls in `around`.
void begin_evasions(const EvasionOptions& options, Surroundings& around);

/// Tests (C1) of one step, of each of A's discs.
bool keeps_off_movers(const EvasionOptions& options, Surroundings& around, const EvasionState& from,
                      std::span<const Hull> discs);

/// [v_1] m/s, the next velocity of an evasive maneuver towards the velocity w.
Vec2 next_towards(const EvasionOptions& options, const EvasionState& from, Vec2 w);

/// Returns whether the first step, to v_1, keeps clear, (C1) and (C3). The functions below test
/// the motion after it.
bool take_first_step(const EvasionOptions& options, Surroundings& around, const EvasionState& now,
                     Vec2 next_velocity);
/// Returns whether A keeps clear, (C1) to (C3), if it brakes.
bool may_brake(const EvasionOptions& options, Surroundings& around);
/// Returns whether A keeps clear, (C1) to (C3), if it moves towards the velocity w for some steps,
/// and then brakes.
bool may_approach(const EvasionOptions& options, Surroundings& around, Vec2 w);

/// Tests (C2) of a step and of braking after it: the certificate's demand on A towards movers.
bool stops_in_time(const EvasionOptions& options, Surroundings& around, const EvasionState& now,
                   Vec2 next_velocity);

}  // namespace avo::inline certificate
