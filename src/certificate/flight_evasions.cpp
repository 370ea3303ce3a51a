// SPDX-License-Identifier: Apache-2.0
#include "certificate/flight_evasions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/elementary.h"
#include "core/plane.h"

namespace avo::inline certificate {
namespace {

// The largest distance of a step from the parabola with the same ends and the same first velocity.
// It is 2 h³/81 times the largest third derivative, which is 3 a s κ to the left and -s³ κ² ahead.
double bend_of(double speed, double next_speed, double curvature, double h) {
  const double top = std::max(speed, next_speed), turn = top * std::abs(curvature);  // rad/s
  const double change = std::abs(next_speed - speed) / h;
  return (2.0 / 81.0) * h * h * h * turn * (3.0 * change + top * turn);
}

// A step along an arc.
struct ArcStep {
  EvasionState from, next;
  Hull path;
  double sagitta = 0.0;  // m
};

// The steps of one control. Nearly all of them turn by the same angle.
class Flown {
 public:
  Flown(const EvasionOptions& options, const FlightControl& control)
      : options_(options),
        target_(control.speed),
        most_(options.wheels->max_acceleration * options.law.time_step),
        across_(control.turn * usable_acceleration(options.wheels->model)) {}

  // By the equations of fly_along().
  ArcStep from(const EvasionState& state) {
    const double h = options_.law.time_step, speed = norm(state.velocity);
    const double next_speed = std::clamp(target_, speed - most_, speed + most_);
    const double top = std::max(speed, next_speed), curvature = across_ / (top * top);
    const FlightArc arc{state.position, state.velocity / speed, curvature,
                        0.5 * (speed + next_speed) * h};
    turn_by(0.5 * curvature * arc.length);
    const Vec2 middle = turned(arc.heading, half_);
    const Vec2 end = state.position + (arc.length * straightness_) * middle;
    return {state,
            {end, next_speed * turned(middle, half_), state.time + h},
            {state.position, state.position + options_.law.lag * state.velocity, end,
             bend_of(speed, next_speed, curvature, h)},
            sagitta(arc)};
  }

 private:
  void turn_by(double half_turn) {
    if (half_turn == half_turn_) return;
    half_turn_ = half_turn;
    half_ = elementary::direction(half_turn);
    straightness_ = std::abs(half_turn) < 1e-8 ? 1.0 : half_.y / half_turn;
  }

  const EvasionOptions& options_;
  double target_, most_, across_;  // m/s, m/s, m/s²
  double half_turn_ = 0.0;         // rad
  Vec2 half_ = {1.0, 0.0};         // its direction
  double straightness_ = 1.0;      // length of the chord, in lengths of the arc
};

LoiterCircle circle_from(const EvasionOptions& options, const EvasionState& state) {
  return *circle_of(options.wheels->model, state.position, state.velocity);
}

// Tests (C1) of one step, and (C3) of this step and of the circle after it.
bool is_clear(const EvasionOptions& options, Surroundings& around, const ArcStep& step) {
  if (around.work < 0 || !keeps_off_movers(options, around, step.from, {&step.path, 1}))
    return false;
  const LoiterCircle circle = circle_from(options, step.next);
  const Segment chord{step.path.start, step.path.end};
  return norm(circle.center) + circle.radius <= options.known &&
         std::all_of(around.walls.begin(), around.walls.end(), [&](const KeptWall& wall) {
           return distance(circle.center, wall.segment) - circle.radius >= wall.kept &&
                  (wall.clear_until >= step.next.time ||
                   distance(chord, wall.segment) - step.sagitta >= wall.kept);
         });
}

// Returns whether no mover ever touches the disc in which A circles from that state on, (C1).
bool is_circle_clear(const EvasionOptions& options, Surroundings& around,
                     const EvasionState& state) {
  const LoiterCircle circle = circle_from(options, state);
  const auto is_clear_of = [&](std::size_t k) {
    return rests_clear(around.others[k], circle.center, state.time, circle.radius);
  };
  const std::size_t count = around.others.size(), first = around.refused_by;
  around.work -= static_cast<int>(count);
  // the mover that crossed the last circle often crosses the next one, too
  if (first < count && !is_clear_of(first)) return false;
  for (std::size_t k = 0; k < count; ++k) {
    if (k == first || is_clear_of(k)) continue;
    around.refused_by = k;
    return false;
  }
  return true;
}

}  // namespace

bool take_first_flight(const EvasionOptions& options, Surroundings& around, const MotionState& now,
                       const FlightStep& step) {
  const MotionState& next = step.motion.next;
  const double h = options.law.time_step;
  const Hull path{now.position, now.position + options.law.lag * now.velocity, next.position,
                  bend_of(norm(now.velocity), norm(next.velocity), step.arc.curvature, h)};
  around.after = {next.position, next.velocity, h};
  around.clear_until = around.clear_now;
  const bool clear = is_clear(
      options, around, {{now.position, now.velocity}, around.after, path, sagitta(step.arc)});
  around.clear_after = around.clear_until;
  return clear;
}

void take_no_flight(Surroundings& around, Vec2 velocity) {
  around.after = {{}, velocity};
  around.clear_after = around.clear_now;
}

bool may_circle(const EvasionOptions& options, Surroundings& around) {
  around.last = around.after;
  return is_circle_clear(options, around, around.after);
}

bool may_circle_after(const EvasionOptions& options, Surroundings& around,
                      const FlightControl& control) {
  around.clear_until = around.clear_after;
  Flown flown(options, control);
  EvasionState& state = around.last;
  for (state = around.after; state.time < options.longest;) {
    const ArcStep step = flown.from(state);
    if (!is_clear(options, around, step)) return false;
    state = step.next;
    if (is_circle_clear(options, around, state)) return true;
  }
  return false;
}

}  // namespace avo::inline certificate
