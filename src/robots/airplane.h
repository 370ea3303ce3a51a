// SPDX-License-Identifier: Apache-2.0
// Airplanes: a minimum speed, and turns that a lateral acceleration limits. The fallback of an
// airplane is a circle to its right, which it holds for ever (docs/certificate/airplanes.md).
#pragma once
#include <vector>

#include "robots/model.h"

namespace avo::inline robots {

/// A path of constant curvature, of less than half a turn.
struct Arc {
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
ArcEnd end_of(const Arc& arc, Vec2 chord);
Vec2 chord(const Arc& arc);

/// m: the least n·(x - start) over the points x of the arc with that end; n a unit vector.
double lowest(const Arc& arc, const ArcEnd& end, Vec2 n);
/// m, from p to its nearest point.
double distance(const Arc& arc, Vec2 p);
/// m, an upper bound of the distance of its points from its chord.
double sagitta(const Arc& arc);

struct FlightStep {
  MotionStep motion;  ///< with the circle that it falls back on afterwards
  Arc way;
  Vec2 chord;  ///< of the path
};
FlightStep fly(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
               const Plan& plan, double time_step);
/// The same for an acceleration, where the direction of state.heading is known.
FlightStep fly_along(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
                     Vec2 heading, Vec2 acceleration, double time_step);

/// [a_lat] m/s², less the reserve that a controller may need to stay on a circle.
double usable_acceleration(const Airplane& airplane);

/// m/s²: it holds the speed and turns right at full rate. With exactly that, fly() stays on
/// state.circle.
Vec2 loitering(const Airplane& airplane, const MotionState& state);

void append_own_half_planes(const Airplane& airplane, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes);
Vec2 steered(const Airplane& airplane, const Robot& robot);
Vec2 within_steering(const Airplane& airplane, const Robot& robot, Vec2 v);

}  // namespace avo::inline robots
