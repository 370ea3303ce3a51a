// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V). With heading θ, speed v >= 0 and curvature κ = tan(φ)/d,
//   p' = v (cos θ, sin θ),  θ' = v κ,  v' = a_lin                                     Eq. (24)
//   velocity (v, 0) and acceleration (a_lin, v² κ) in the frame turned by θ           Eq. (25)
// |a_lin| <= a_max and |v² κ| <= a_max make a square turned by θ; its incircle is the disc
// D(0, a_max) that the planner chooses from, so every choice can be turned into controls.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "robots/motion.h"

namespace avo {
namespace {

// Near v = 0 Eq. (25) asks for unbounded curvature. Below the speed that one step of braking takes
// away, a car that would have to turn by more than this first stops, and then turns in place
// about its rear axle (front wheels across), which moves neither the axle nor the disc around it.
constexpr double kTurnInPlace = 0.25;  // rad
constexpr double kEarly = 1e-9;        // of the speed, beyond rest: more is not rounding

struct Controls {
  double linear = 0.0;     // [a_lin] m/s^2
  double curvature = 0.0;  // [κ] 1/m
};

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

// Eq. (25) solved for the controls. κ is that of the highest speed in the step, so that
// |(a_lin, v² κ)| <= |a| holds all through it.
Controls controls(Vec2 acceleration, Vec2 heading, double speed, double time_step) {
  Controls result{dot(heading, acceleration), 0.0};
  const double top = std::max(speed, speed + result.linear * time_step);
  if (top > 0.0) result.curvature = cross(heading, acceleration) / (top * top);
  return result;
}

// See MotionStep. The acceleration changes by 3 a_lin v κ across the heading and by -v³ κ² along
// it, J(v) in all, which is convex in time: at most linear between J_0 and J_1. With y = v_0 t + t²
// z(t), z is an average of the acceleration, and |z(Δt) - z(t)| <= Δt (3 J_0 + J_1)/24.
double bend(double speed, double next_speed, const Controls& control, double time_step) {
  const auto jerk = [&](double v) {
    const double turning = std::abs(v * control.curvature);
    return turning * (3.0 * std::abs(control.linear) + v * turning);
  };
  return time_step * time_step * time_step * (3.0 * jerk(speed) + jerk(next_speed)) / 24.0;
}

// a turned by the angle of a unit vector.
Vec2 turned(Vec2 a, Vec2 by) {
  return {a.x * by.x - a.y * by.y, a.x * by.y + a.y * by.x};
}

// Eq. (24) with held controls: an arc of the length that the speed covers, which stops at v = 0.
// heading: the unit vector of state.heading, which elementary functions are not asked for again.
MotionStep drive(const MotionState& state, Vec2 heading, double speed, const Controls& control,
                 double time_step) {
  const bool stops = speed + control.linear * time_step <= 0.0;
  const double next_speed = stops ? 0.0 : speed + control.linear * time_step;
  const double length = stops && control.linear < 0.0 ? speed * speed / (-2.0 * control.linear)
                                                      : 0.5 * (speed + next_speed) * time_step;
  const double half_turn = 0.5 * control.curvature * length;
  const Vec2 half = elementary::direction(half_turn), middle = turned(heading, half);
  const double chord = std::abs(half_turn) < 1e-8 ? length : length * (half.y / half_turn);
  const double top = std::max(speed, next_speed);

  MotionStep step;
  step.next.position = state.position + chord * middle;
  step.next.heading = wrapped(state.heading + 2.0 * half_turn);
  step.next.velocity = next_speed * turned(middle, half);
  step.acceleration = norm(Vec2{control.linear, top * top * control.curvature});
  const bool early = speed + control.linear * time_step < -kEarly * speed;
  step.bend =
      early ? std::numeric_limits<double>::infinity() : bend(speed, next_speed, control, time_step);
  return step;
}

}  // namespace

MotionStep advance_car(const MotionState& state, const Plan& plan, const CarLimits& limits,
                       double time_step) {
  const Vec2 heading = elementary::direction(state.heading);
  const double speed = norm(state.velocity);
  const Controls control = controls(plan.acceleration, heading, speed, time_step);
  const double top = std::max(speed, speed + control.linear * time_step);
  const double slow = limits.max_braking * time_step;
  if (top > slow) {
    // what may brake harder than it surely does comes to rest at the end of the step, not within
    const bool early = speed + control.linear * time_step < -kEarly * speed;
    const Controls gentle{early ? -speed / time_step : control.linear, control.curvature};
    return drive(state, heading, speed, gentle, time_step);
  }
  const bool moves = norm(plan.new_velocity) > 0.0;
  const double turn =
      moves ? elementary::atan2(cross(heading, plan.new_velocity), dot(heading, plan.new_velocity))
            : 0.0;
  if (moves && std::abs(turn) <= kTurnInPlace) {
    return drive(state, heading, speed, control, time_step);
  }
  if (speed > 0.0) return drive(state, heading, speed, {-speed / time_step, 0.0}, time_step);

  // the front axle, one wheelbase ahead, moves at v_max at most
  const double most = limits.max_speed / limits.wheelbase * time_step;
  MotionStep step{state, 0.0};
  step.next.heading = wrapped(state.heading + std::clamp(turn, -most, most));
  return step;
}

}  // namespace avo
