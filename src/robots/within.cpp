// SPDX-License-Identifier: Apache-2.0
// Robots within a step, computed from its ends: for robots that decide while others are in motion.
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/car.h"
#include "robots/motion.h"

namespace avo::inline robots {
namespace {

// m/s, negative backwards.
double signed_speed(const MotionState& state) {
  const double speed = norm(state.velocity);
  return dot(state.velocity, ahead_of(state.heading)) < 0.0 ? -speed : speed;
}

double sine_ratio(double x) {
  return std::abs(x) < 1e-8 ? 1.0 : elementary::direction(x).y / x;
}

// The arc of the axle, Eq. (24): its length follows the speed, and its turn is proportional to its
// length. In place it turns evenly, or, where its disc swings, by an angle that grows with the
// square of the time.
MotionState within_axle_arc(const MotionState& from, const MotionState& to, bool swings,
                            double time, double duration) {
  const double speed = signed_speed(from), next_speed = signed_speed(to);
  const double turn = wrapped(to.heading - from.heading);
  const double length = 0.5 * (speed + next_speed) * duration;
  MotionState state = from;
  if (length == 0.0) {  // in place, or not at all
    const double part = time / duration;
    state.heading = wrapped(from.heading + turn * (swings ? part * part : part));
    return state;
  }
  const double change = (next_speed - speed) / duration;
  const double covered = time * (speed + 0.5 * time * change);
  const double half_turn = 0.5 * turn * (covered / length);
  const Vec2 half = elementary::direction(half_turn);
  const Vec2 middle = turned(ahead_of(from.heading), half);
  state.position = from.position + (covered * sine_ratio(half_turn)) * middle;
  state.heading = wrapped(from.heading + 2.0 * half_turn);
  state.velocity = (speed + time * change) * turned(middle, half);
  return state;
}

// The state with its position moved ahead, m.
MotionState moved(MotionState state, double ahead) {
  state.position = state.position + ahead * ahead_of(state.heading);
  return state;
}

}  // namespace

MotionState within_arc(const Car& car, const MotionState& from, const MotionState& to, double time,
                       double duration) {
  const double offset = offset_of(car);
  if (offset == 0.0) return within_axle_arc(from, to, false, time, duration);
  return moved(within_axle_arc(moved(from, -offset), moved(to, -offset), true, time, duration),
               offset);
}

MotionState within(const MotionState& from, const MotionState& to, bool at_once, double time,
                   double duration) {
  const double part = time / duration;
  if (at_once)
    return {from.position + part * (to.position - from.position), to.velocity, from.heading};
  const Vec2 change = to.velocity - from.velocity;
  return {from.position + (time * from.velocity + (0.5 * time * part) * change),
          from.velocity + part * change, from.heading};
}

}  // namespace avo::inline robots
