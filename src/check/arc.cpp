// SPDX-License-Identifier: Apache-2.0
// With heading h, n to its left, speed s, its change a and curvature κ, ω = s κ and ω' = a κ,
//   p' = s h,  p'''' = (3 a² κ - s⁴ κ³) n - 6 a s² κ² h,
// and h'''' has the length of ω⁴ + 6 ω² ω' + 3 ω'² at most.
#include "check/arc.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/plane.h"

namespace avo::judge {
namespace {

// m, signed, length of the first part of the step.
double length_by(const Arc& arc, double fraction) {
  return fraction * arc.duration * (arc.speed + 0.5 * fraction * (arc.next_speed - arc.speed));
}

// The part of the turn by a fraction of the step, and its rate there, 1/s.
struct TurnedPart {
  double part, rate;
};

TurnedPart turned_by(const Arc& arc, double fraction) {
  const double length = length_by(arc, 1.0);
  if (length == 0.0) return {fraction * fraction, 2.0 * fraction / arc.duration};
  const double speed = arc.speed + fraction * (arc.next_speed - arc.speed);
  return {length_by(arc, fraction) / length, speed / length};
}

}  // namespace

Arc arc_of(const CheckedState& before, const CheckedState& now, double duration) {
  return {before.position,
          before.heading->angle,
          before.heading->speed,
          now.heading->speed,
          wrapped(now.heading->angle - before.heading->angle),
          duration};
}

double path_length(const Arc& arc) {
  const double from = std::abs(arc.speed), to = std::abs(arc.next_speed);
  if (!changes_direction(arc)) return 0.5 * arc.duration * (from + to);
  return 0.5 * arc.duration * (from * from + to * to) / (from + to);
}

double top_speed(const Arc& arc) {
  return std::max(std::abs(arc.speed), std::abs(arc.next_speed));
}

// s² |κ|; s/length is at most 2 over the duration: it stays finite
double lateral_acceleration(const Arc& arc) {
  const double top = top_speed(arc);
  return top > 0.0 ? top * std::abs(arc.turn) * (top / path_length(arc)) : 0.0;
}

CourseKnot knot_on(const Arc& arc, double ahead, double fraction) {
  const TurnedPart turned = turned_by(arc, fraction);
  const double length = length_by(arc, fraction), half = 0.5 * turned.part * arc.turn;
  const double chord =
      std::abs(half) < 1e-8 ? length : length * (elementary::direction(half).y / half);
  const Vec2 h = elementary::direction(arc.heading + 2.0 * half), n{-h.y, h.x};
  const double speed = arc.speed + fraction * (arc.next_speed - arc.speed);
  return {arc.from + chord * elementary::direction(arc.heading + half) + ahead * h,
          speed * h + (ahead * arc.turn * turned.rate) * n};
}

double fourth_derivative(const Arc& arc, double ahead) {
  const double top = top_speed(arc), turn = std::abs(arc.turn);
  const double change = std::abs(arc.next_speed - arc.speed) / arc.duration;
  const bool rests = !(top > 0.0);
  const double curvature = rests ? 0.0 : turn / path_length(arc);
  const double rate = rests ? 2.0 * turn / arc.duration : top * curvature;
  const double gain = rests ? rate / arc.duration : change * curvature;
  const double square = rate * rate;
  return 3.0 * change * gain + top * square * rate + 6.0 * change * square +
         std::abs(ahead) * (square * square + 6.0 * square * gain + 3.0 * gain * gain);
}

}  // namespace avo::judge
