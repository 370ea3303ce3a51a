// SPDX-License-Identifier: Apache-2.0
// The predicted places of a mover, and proofs that a path keeps clear of them (docs/movers.md).
// Places are relative to p_A, and times count from the decision. D: of the plane, or of space.
#pragma once
#include <limits>

#include "certificate/braking_path.h"
#include "certificate/trajectory_steps.h"
#include "core/vector_of.h"

namespace avo::inline certificate {

/// A mover that an evasive maneuver must keep clear of. It keeps its acceleration for ever, or its
/// trajectory.
template <int D>
struct PredictedOf {
  using Vector = VectorOf<D>;
  Vector position, velocity, acceleration;  // m, m/s, m/s²; read where there is no trajectory
  TrajectorySteps* trajectory = nullptr;    // in the plane: from p_A, in steps of A
  double contact = 0.0;                     ///< m, to be kept from the mover by each disc of A
  double drift = 0.0;                       ///< [e] m/s, the error of its velocity
  double deviation = 0.0;                   ///< [η] m/s², the deviation of its acceleration
  double reaction = 0.0;                    ///< [T] s: e and η are counted for so long
  /// (C2): A must be able to be at rest when the mover comes, and keeps stop_contact (m) until
  /// then.
  bool asks_to_stop = false;
  double stop_contact = 0.0;
  double max_speed = std::numeric_limits<double>::infinity();  ///< [V] m/s
  /// s: rest must be clear of the mover until this time, where its trajectory is not known.
  double until = std::numeric_limits<double>::infinity();
  /// m/s: the mover and its spread never come nearer by more than this in a second
  double fastest = 0.0;

  // On a trajectory the time must be a whole number of steps.
  Vector place_at(double time) const;
  Vector velocity_at(double time) const;
  /// m, the distance of the mover from the parabola of three points in the step that begins then.
  double bend_at(double time) const;
  /// [ρ] m, the radius of its possible places at that time.
  double spread_at(double time) const;
};
using Predicted = PredictedOf<2>;

/// A's path on an interval: the Bézier points of a hull.
template <int D>
struct HullOf {
  VectorOf<D> start, middle, end;  // m
  double bend = 0.0;               // m, by which the path may leave the hull
};
using Hull = HullOf<2>;

/// A's path in the interval of one step from that time on, relative to the other body.
template <int D>
HullOf<D> relative_to(const PredictedOf<D>& other, const HullOf<D>& own, double time,
                      const StepLaw& law);
/// Returns whether a whole path is at least so far from the origin, m. If it keeps off by a
/// distance, it keeps off by any smaller one.
template <int D>
bool keeps_off(const HullOf<D>& relative, double distance);
/// Tests (C1) for a robot that rests at `place` from that time on, for ever or `until` then. Or it
/// stays within a disc about that place that is `wider` than the robot by so much, m.
template <int D>
bool rests_clear(const PredictedOf<D>& other, VectorOf<D> place, double time, double wider = 0.0);
/// Tests (C2) for an interval that begins `elapsed` s after the time `from`, when A decides to
/// brake and sees the mover. The mover is then within each of two discs: about its predicted path,
/// and about its predicted place at `from`. See docs/certificate/movers.md, "Movers that do as they
/// like". A's path must keep off one of them.
template <int D>
bool is_reached_at_rest(const PredictedOf<D>& other, const HullOf<D>& own, double from,
                        double elapsed, const StepLaw& law);
/// m: a path that keeps off by that until so long after `from` satisfies (C2).
template <int D>
double kept_before_rest(const PredictedOf<D>& other, double from, double elapsed);
/// m, between contact and the places where the mover may be then. Until that is used up, no motion
/// of A matters.
template <int D>
double room_to(const PredictedOf<D>& other, VectorOf<D> place, double time);
/// m, the same room for braking that was decided `elapsed` s ago, at `from`.
template <int D>
double room_before_rest(const PredictedOf<D>& other, VectorOf<D> place, double from,
                        double elapsed);

}  // namespace avo::inline certificate
