// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V). With heading θ, speed v and curvature κ = tan(φ)/d,
//   p' = v (cos θ, sin θ),  θ' = v κ,  v' = a_lin                                     Eq. (24)
//   velocity (v, 0) and acceleration (a_lin, v² κ) in the frame turned by θ           Eq. (25)
// |a_lin| <= a_max and |v² κ| <= a_max make a square turned by θ, Fig. 6(b). Holonomic robots
// choose from its incircle, the disc D(0, a_max), so every choice can be turned into controls. κ
// turns at once. It is held through a step, as a_lin is.
//
// With h along the heading and n to its left, a disc that is e ahead of the axle has the velocity
// v h + e v κ n. A car that drives backwards drives forward with h, n and e turned round.
#include "robots/car.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <variant>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/directions.h"

namespace avo::inline robots {
namespace {

// Rest is exactly 0. A car with the speed that rounding leaves would creep on for ever. The sign of
// that speed would decide where the car may drive. As a part of the speed before the step:
constexpr double kRestRounding = 0x1p-48;
// Part of the speed that one step of braking takes off: a smaller change is no decision. The
// choices of a certificate are drawn by as much on the safe side, and rounding of places increases
// this.
constexpr double kLeastDecided = 0x1p-30;

struct CarControls {
  double linear = 0.0;     // [a_lin] m/s^2
  double curvature = 0.0;  // [κ] 1/m
};

// The car as it drives forward, or as it drives backwards, seen from its rear.
struct Driving {
  Vec2 heading;   // [h] unit
  double angle;   // [θ] rad, of h
  double speed;   // [v] m/s, >= 0
  double offset;  // [e] m
};

// Returns whether it drives backwards; for a car at rest, whether it should.
bool is_reversing(const Car& car, Vec2 heading, Vec2 velocity, Vec2 wanted) {
  if (!car.reverse) return false;
  return dot(heading, is_rest(velocity) ? wanted : velocity) < 0.0;
}

Driving driving_of(const Car& car, const MotionState& state, Vec2 wanted) {
  const Vec2 heading = ahead_of(state.heading);
  const double speed = norm(state.velocity), offset = offset_of(car);
  if (is_reversing(car, heading, state.velocity, wanted))
    return {-heading, state.heading + std::numbers::pi, speed, -offset};
  return {heading, state.heading, speed, offset};
}

// Eq. (25) solved for the controls. κ is that of the highest speed in the step, so that |v² κ|
// stays below the decided value all through it. The car comes to rest at the end of a step at the
// earliest. A car that brakes weakly could turn by more than kMostTurn at low speed; this is
// limited. slow: m/s, the speed from which it can brake within the step.
CarControls controls(const Car& car, Vec2 acceleration, const Driving& driving, double slow,
                     double time_step) {
  CarControls result;
  result.linear = std::max(dot(driving.heading, acceleration), -driving.speed / time_step);
  if (driving.speed <= slow && driving.speed + result.linear * time_step < kLeastDecided * slow)
    result.linear = -driving.speed / time_step;
  const double next_speed = std::max(0.0, driving.speed + result.linear * time_step);
  const double top = std::max(driving.speed, next_speed);
  if (!(top > 0.0)) return result;
  const double length = 0.5 * (driving.speed + next_speed) * time_step;
  const double most = std::min(sharpest(car), kMostTurn / length);
  result.curvature = std::clamp(cross(driving.heading, acceleration) / (top * top), -most, most);
  return result;
}

// See MotionStep. With s = v κ the disc's acceleration changes by s (3 a_lin - e v s κ) across the
// heading and by -s (v s + 3 e a_lin κ) along it. Together it is less than J(v), which is convex in
// time: at most linear between J_0 and J_1. With y = v_0 t + t² z(t), z is an average of the
// acceleration, and |z(Δt) - z(t)| <= Δt (3 J_0 + J_1)/24.
double bend(const Driving& driving, double next_speed, const CarControls& control,
            double time_step) {
  const double lever = 1.0 + std::abs(driving.offset * control.curvature);
  const auto jerk = [&](double v) {
    const double turning = std::abs(v * control.curvature);
    return turning * (3.0 * std::abs(control.linear) + v * turning) * lever;
  };
  return time_step * time_step * time_step * (3.0 * jerk(driving.speed) + jerk(next_speed)) / 24.0;
}

// m/s²: the value that its limit applies to, along and across separately or both together.
double largest(const Car& car, Vec2 acceleration) {
  if (car.acceleration_set == AccelerationSet::incircle) return norm(acceleration);
  return std::max(std::abs(acceleration.x), std::abs(acceleration.y));
}

// The turn of a step is known before the step's end.
struct Begun {
  Driving driving;
  bool stays = false;  // whether it turns in place; otherwise it drives
  CarControls control = {};
  double next_speed = 0.0;  // m/s
  double length = 0.0;      // m, of its arc
  double angle = 0.0;       // rad: half of the turn on an arc, the whole turn in place
};

// Eq. (24) with held controls: an arc of the length that the speed covers.
Begun drive(const Driving& driving, const CarControls& control, double time_step) {
  double next_speed = std::max(0.0, driving.speed + control.linear * time_step);
  if (next_speed < kRestRounding * driving.speed) next_speed = 0.0;
  const double length = 0.5 * (driving.speed + next_speed) * time_step;
  return {driving, false, control, next_speed, length, 0.5 * control.curvature * length};
}

// half: the direction of half of the turn.
MotionStep driven(const Car& car, const MotionState& state, const Begun& begun, Vec2 half,
                  double time_step) {
  const auto& [driving, stays, control, next_speed, length, half_turn] = begun;
  const Vec2 middle = turned(driving.heading, half);
  const double chord = std::abs(half_turn) < 1e-8 ? length : length * (half.y / half_turn);
  const double top = std::max(driving.speed, next_speed);
  const Vec2 next_heading = turned(middle, half);

  MotionStep step;
  step.next.position = state.position + chord * middle;
  step.next.heading = wrapped(state.heading + 2.0 * half_turn);
  step.next.velocity = next_speed * next_heading;
  step.acceleration = largest(car, {control.linear, top * top * control.curvature});
  step.bend = bend(driving, next_speed, control, time_step);
  step.length = length * (1.0 + std::abs(driving.offset * control.curvature));
  if (driving.offset != 0.0) {
    step.next.position = step.next.position + driving.offset * (next_heading - driving.heading);
    step.swing =
        (driving.offset * driving.speed * control.curvature) * perpendicular(driving.heading);
  }
  return step;
}

// A turn at rest, by an angle that grows with the square of the time. The disc then starts at rest
// as well, and stays within e times the angle's square of a straight line. by: the direction of the
// angle.
MotionStep turned_in_place(const MotionState& state, const Driving& driving, double angle,
                           Vec2 by) {
  MotionStep step{state, 0.0};
  step.next.heading = wrapped(state.heading + angle);
  if (driving.offset == 0.0) return step;
  const Vec2 next_heading = turned(driving.heading, by);
  step.next.position = state.position + driving.offset * (next_heading - driving.heading);
  step.length = std::abs(driving.offset * angle);
  step.bend = step.length * std::abs(angle);
  return step;
}

Begun begin(const Car& car, const MotionLimits& limits, const MotionState& state, const Plan& plan,
            double time_step) {
  const Driving driving = driving_of(car, state, plan.new_velocity);
  const double slow = limits.planned_braking * time_step;
  const CarControls control = controls(car, plan.acceleration, driving, slow, time_step);
  const double top = std::max(driving.speed, driving.speed + control.linear * time_step);
  if (top > slow || !turns_in_place(car)) return drive(driving, control, time_step);
  const bool moves =
      norm(plan.new_velocity) > 0.0 &&
      (driving.speed > 0.0 || norm(plan.acceleration) * time_step >= kLeastDecided * slow);
  const double turn = moves ? elementary::atan2(cross(driving.heading, plan.new_velocity),
                                                dot(driving.heading, plan.new_velocity))
                            : 0.0;
  if (moves && std::abs(turn) <= kTurnInPlace) return drive(driving, control, time_step);
  if (driving.speed > 0.0) return drive(driving, {-driving.speed / time_step, 0.0}, time_step);

  // the front axle, one wheelbase ahead, moves at v_max at most, and so do discs of a footprint
  const double lever =
      car.footprint ? std::max(car.wheelbase, farthest_center(car.footprint)) : car.wheelbase;
  double most = std::min(limits.max_speed / lever * time_step, kMostTurn);
  // and the disc accelerates by a_max at most; the turn rate at the end is twice the mean
  if (driving.offset != 0.0)
    most = std::min(0.5 * most, 0.5 * slow * time_step / std::abs(driving.offset));
  Begun begun{driving, true};
  begun.angle = std::clamp(turn, -most, most);
  return begun;
}

// by: the direction of the angle of the turn so far.
MotionStep finish(const Car& car, const MotionState& state, const Begun& begun, Vec2 by,
                  double time_step) {
  if (begun.stays) return turned_in_place(state, begun.driving, begun.angle, by);
  return driven(car, state, begun, by, time_step);
}

}  // namespace

MotionStep advance_car(const Car& car, const MotionLimits& limits, const MotionState& state,
                       const Plan& plan, double time_step) {
  const Begun begun = begin(car, limits, state, plan, time_step);
  return finish(car, state, begun, elementary::direction(begun.angle), time_step);
}

void advance_cars(std::span<ModelStep* const> steps, double time_step) {
  std::array<Begun, kMostModelSteps> begun;
  std::array<double, kMostModelSteps + kSpareAngles> angle{}, x, y;
  const auto car_of = [](const ModelStep& step) -> const Car& {
    return std::get<Car>(*step.model);
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const ModelStep& step = *steps[k];
    begun[k] = begin(car_of(step), step.limits, step.state, *step.plan, time_step);
    angle[k] = begun[k].angle;
  }
  find_directions(angle.data(), steps.size(), x.data(), y.data());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    ModelStep& step = *steps[k];
    step.result = finish(car_of(step), step.state, begun[k], {x[k], y[k]}, time_step);
  }
}

void advance_discs(const Car& car, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step, std::span<MotionStep> discs) {
  Begun begun = begin(car, limits, state, plan, time_step);
  const Vec2 by = elementary::direction(begun.angle);
  // a car that drives backwards is seen from its rear
  const bool reverses = dot(begun.driving.heading, ahead_of(state.heading)) < 0.0;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const double ahead = car.footprint.ahead(static_cast<int>(k));
    begun.driving.offset = reverses ? -ahead : ahead;
    discs[k] = finish(car, state, begun, by, time_step);
  }
}

Vec2 turning_first(const Car& car, const Robot& robot, Vec2 v) {
  constexpr double kEnough = 1.01 * kTurnInPlace;
  const Driving driving = driving_of(car, {robot.position, {}, robot.heading}, v);
  const double turn = elementary::atan2(cross(driving.heading, v), dot(driving.heading, v));
  if (std::abs(turn) >= kEnough) return v;
  return norm(v) * turned(driving.heading, elementary::direction(std::copysign(kEnough, turn)));
}

}  // namespace avo::inline robots
