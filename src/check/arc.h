// SPDX-License-Identifier: Apache-2.0
// A body that moves along its heading from row to row, with constant curvature and constant change
// of speed.
#pragma once
#include "avo/check.h"

namespace avo::judge {

/// The place of a body, and its velocity there.
struct CourseKnot {
  Vec2 position, velocity;  // m, m/s
};

struct Arc {
  Vec2 from;                             // m
  double heading = 0.0;                  // rad, at the start
  double speed = 0.0, next_speed = 0.0;  // m/s, < 0: backwards
  double turn = 0.0;                     // rad, in (-π, π]
  double duration = 0.0;                 // s
};

/// Both rows must have a heading.
Arc arc_of(const CheckedState& before, const CheckedState& now, double duration);

/// Returns whether it drives backwards at one end and forwards at the other: then there is no arc.
inline bool changes_direction(const Arc& arc) {
  return arc.speed * arc.next_speed < 0.0;
}
/// m, the length of the path.
double path_length(const Arc& arc);
/// m/s, the higher speed.
double top_speed(const Arc& arc);
/// m/s^2: across the heading, for a body with the higher speed on the arc; 0 at rest.
double lateral_acceleration(const Arc& arc);

/// The point `ahead` m ahead of the arc, at a fraction of the step. At rest the angle grows with
/// the square of the time.
CourseKnot knot_on(const Arc& arc, double ahead, double fraction);
/// m/s^4, an upper bound of the fourth derivative of that place.
double fourth_derivative(const Arc& arc, double ahead);

}  // namespace avo::judge
