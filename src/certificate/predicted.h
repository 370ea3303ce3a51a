// SPDX-License-Identifier: Apache-2.0
// Where somebody who does not decide is predicted to be, and what keeps clear of it for sure
// (docs/movers.md). Places are relative to p_A, and times count from the decision.
#pragma once
#include <limits>

#include "certificate/braking_path.h"
#include "certificate/trajectory_steps.h"

namespace avo::inline certificate {

/// Somebody whom a way has to keep clear of, who keeps its acceleration for ever, or its
/// trajectory.
struct Predicted {
  Vec2 position, velocity, acceleration;  // m, m/s, m/s²; read where there is no trajectory
  TrajectorySteps* trajectory = nullptr;  // from p_A, in steps of A
  double contact = 0.0;                   ///< m, to be kept from it
  double drift = 0.0;                     ///< [e] m/s, by which its velocity may be another one
  double deviation = 0.0;                 ///< [η] m/s², likewise its acceleration
  double reaction = 0.0;                  ///< [T] s: e and η are reckoned with for so long
  /// (C2): A has to be able to be at rest when it comes, and keeps stop_contact (m) until then.
  bool asks_to_stop = false;
  double stop_contact = 0.0;
  double max_speed = std::numeric_limits<double>::infinity();  ///< [V] m/s
  /// s: for so long rest has to be clear of it, where its trajectory is not known.
  double until = std::numeric_limits<double>::infinity();
  double fastest = 0.0;  ///< m/s: neither it nor its spread ever comes nearer by more in a second

  // On a trajectory the time is a whole number of steps.
  Vec2 place_at(double time) const;
  Vec2 velocity_at(double time) const;
  /// m, by which it may be off the parabola of three points in the step that begins then.
  double bend_at(double time) const;
  /// [ρ] m, by which it may be elsewhere then.
  double spread_at(double time) const;
};

/// A's path on an interval: the Bézier points of a hull.
struct Hull {
  Vec2 start, middle, end;  // m
  double bend = 0.0;        // m, that the path may be outside of it
};

/// A's path in the interval of one step from that time on, as the other one sees it.
Hull relative_to(const Predicted& other, const Hull& own, double time, const StepLaw& law);
/// Whether all of a path is at least so far from the origin, m. Who keeps off keeps off any less.
bool keeps_off(const Hull& relative, double distance);
/// (C1) of a robot that rests at `place` from that time on, for ever or `until` then.
bool rests_clear(const Predicted& other, Vec2 place, double time);
/// (C2) of an interval that begins `elapsed` s after the time `from`, when A decides to brake and
/// sees the other one: within one of the two discs of docs/certificate/movers.md, "Movers that do
/// as they like", about where it is predicted to be seen then.
bool is_reached_at_rest(const Predicted& other, const Hull& own, double from, double elapsed,
                        const StepLaw& law);
/// m: whoever keeps off by that until so long after `from` satisfies (C2).
double kept_before_rest(const Predicted& other, double from, double elapsed);
/// m, between contact and where it may be then; until that is used up, nothing that A does matters.
double room_to(const Predicted& other, Vec2 place, double time);
/// The same, m, of the braking that was decided on `elapsed` s ago, at `from`.
double room_before_rest(const Predicted& other, Vec2 place, double from, double elapsed);

}  // namespace avo::inline certificate
