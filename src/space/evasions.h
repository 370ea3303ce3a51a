// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers in space: motions of a robot A that keep clear of all predicted moving
// obstacles, for ever (docs/movers.md). Places are relative to p_A, and times count from the
// decision.
#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "avo/space/box.h"
#include "avo/space/decision_trace.h"
#include "avo/space/robot.h"
#include "certificate/predicted.h"
#include "space/boxes.h"
#include "space/kernels.h"

namespace avo::space {

using Predicted = PredictedOf<3>;
using Hull = HullOf<3>;

/// A state on an evasive maneuver.
struct EvasionState {
  Vec3 position, velocity;  // m, m/s
  double time = 0.0;        // s
};

/// Full braking from a state.
struct FullBraking {
  Braking braking;
  Vec3 start, end;     // m
  double steps = 0.0;  // until rest
};

/// What a robot keeps clear of, and its limits. Scratch memory; allocates only while it grows.
struct EvasionSearch {
  StepLaw law;
  Robot robot;             ///< A
  double increment = 0.0;  ///< m/s a step, in its own space, while it approaches a velocity
  double max_speed = 0.0;  ///< m/s, that it never exceeds
  double longest = 0.0;    ///< s, until it brakes
  /// m: it stays within this distance of p_A, where it knows the boxes
  double known = std::numeric_limits<double>::infinity();
  std::vector<Predicted> others;  ///< `fastest` without the effect of the acceleration
  std::vector<Box> boxes;
  BoxConstraints of_boxes;
  // s, until these times no motion of A matters to each of the others. They are counted from now
  // on, from the first step on, and from the last state of an evasive maneuver on.
  std::vector<double> clear_now, clear_after, clear_until;
  EvasionState after;       // the state after the first step
  double brakes_at = 0.0;   // s: the time at which the last clear evasive maneuver begins to brake
  std::vector<Hull> hulls;  // of the last braking path, those that are known
  std::vector<char> has_hull;
  std::size_t refused_by = 0;  // the moving obstacle that refused the last evasive maneuver
  /// The work that is left for this decision; no evasive maneuver counts as clear once it is used
  /// up.
  int work = std::numeric_limits<int>::max();
  /// Of the last decision that evades: its evasive maneuver, and the next velocity that it has
  /// rejected, m/s.
  Evasion chosen;
  Vec3 put_aside;
};

/// Begins the search of evasive maneuvers among others and boxes.
void begin_evasions(EvasionSearch& search);

/// [v_1] m/s, the next velocity of an evasive maneuver towards the velocity w.
Vec3 next_towards(const EvasionSearch& search, const EvasionState& from, Vec3 w);

/// Returns whether the first step, to v_1, keeps clear, (C1) and (C3). The functions below test
/// the motion after it.
bool take_first_step(EvasionSearch& search, Vec3 next_velocity);
/// Returns whether A keeps clear, (C1) to (C3), if it brakes.
bool may_brake(EvasionSearch& search);
/// Returns whether A keeps clear, (C1) to (C3), if it moves towards the velocity w for some steps,
/// and then brakes.
bool may_approach(EvasionSearch& search, Vec3 w);

/// Tests (C2) of a step and of braking after it: the certificate's demand on A towards moving
/// obstacles.
bool stops_in_time(const EvasionSearch& search, Vec3 next_velocity);

}  // namespace avo::space
