// SPDX-License-Identifier: Apache-2.0
// The flight of a robot that cannot rest. `model` is its model, which keeps a minimum speed and
// turns with a limited lateral acceleration. The fallback is a circle to the robot's right, which
// it holds for ever (docs/certificate/airplanes.md).
#pragma once
#include "robots/model.h"

namespace avo::inline robots {

/// A path of constant curvature, of less than half a turn.
struct FlightArc {
  Vec2 start;              ///< m
  Vec2 heading;            ///< unit, there
  double curvature = 0.0;  ///< [κ] 1/m, > 0: to the left
  double length = 0.0;     ///< m
};

struct ArcEnd {
  Vec2 chord;    ///< m, from the arc's start
  Vec2 heading;  ///< unit
};
/// chord: the chord of the arc.
ArcEnd end_of(const FlightArc& arc, Vec2 chord);
Vec2 chord(const FlightArc& arc);

/// m: the least n·(x - start) over the points x of the arc with that end; n a unit vector.
double lowest(const FlightArc& arc, const ArcEnd& end, Vec2 n);
/// m, from p to its nearest point.
double distance(const FlightArc& arc, Vec2 p);
/// m, an upper bound of the distance of its points from its chord.
double sagitta(const FlightArc& arc);

struct FlightStep {
  MotionStep motion;  ///< with the circle that it falls back on afterwards
  FlightArc arc;
  Vec2 chord;  ///< of the path
};
/// One step with that acceleration; heading: the direction of state.heading.
FlightStep fly_along(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                     Vec2 heading, Vec2 acceleration, double time_step);

/// [a_lat] m/s², less the reserve that a controller may need to stay on a circle.
double usable_acceleration(const MotionModel& model);

/// m/s²: it holds the speed and turns right at full rate. With exactly that, a step stays on
/// state.circle.
Vec2 loitering(const MotionModel& model, const MotionState& state);

/// Returns whether no step turns it by more than kMostTurn.
bool turns_slowly(const MotionModel& model, double time_step);

}  // namespace avo::inline robots
