// SPDX-License-Identifier: Apache-2.0
// Coming to rest at a goal under Eq. (7)'s control, in discrete steps.
#ifndef AVO_GUIDANCE_GOALS_KERNEL_H
#define AVO_GUIDANCE_GOALS_KERNEL_H

#include <limits>

#include "core/response_law_kernel.h"
#include "core/scalar.h"
#include "robots/motion.h"

AVO_BEGIN_KERNELS

/// The inputs of preferred_velocity().
template <typename Real>
struct Traveller {
  Vec<Real> position, velocity, goal;
  Real preferred_speed, planned_braking, max_speed, max_acceleration;
  Real is_holonomic;  // 1 or 0: other robots come to rest with full braking
};

template <typename Real>
struct GoalLine {
  Real distance;        // m, to the goal
  Vec<Real> direction;  // unit, or 0 at the goal
  Real along;           // m/s, velocity in that direction
  Real left;            // m, of the distance, that is left when the next decision takes effect
};

/// Highest next speed from which full braking, `decrement` m/s a step, ends within `distance` of
/// the robot's next place. Braking from (k + f) q, q = decrement, after a step that ends with this
/// speed, takes Δt q (k + 1)(k/2 + f) in all.
template <typename Real>
AVO_KERNEL Real admissible_speed(Real distance, Real decrement, Real time_step) {
  const Real zero(0.0), half(0.5), one(1.0), most(0x1p30);
  const Real y = distance / (decrement * time_step);
  const Real steps = half * (sqrt(one + Real(8.0) * y) - one);
  // of so many, a fraction does not matter
  const Real k = select(steps < most, floor(select(steps < most, steps, zero)), steps);
  const Real f = (y - half * k * (k + one)) / (k + one);
  return select(distance > zero, (k + f) * decrement, zero);
}

/// Returns whether admissible_speed() is surely at least `speed`, without root or floor: with x = k
/// + f, (k + 1)(k/2 + f) <= (x + 1) x. False where this test does not prove it.
template <typename Real>
AVO_KERNEL auto surely_admits(Real distance, Real speed, Real decrement, Real time_step) {
  const Real margin(1.001);  // for rounding
  return distance * decrement > margin * time_step * speed * (speed + decrement);
}

template <typename Real>
AVO_KERNEL Vec<Real> limited(Vec<Real> a, Real length) {
  const Real n = norm(a);
  const auto is_longer = n > length;
  return select(is_longer, (length / select(is_longer, n, Real(1.0))) * a, a);
}

template <typename Real>
AVO_KERNEL GoalLine<Real> line_to_goal(const Traveller<Real>& robot, const StepResponse& step) {
  const Vec<Real> to_goal = robot.goal - robot.position;
  GoalLine<Real> result;
  result.distance = norm(to_goal);
  const auto is_away = result.distance > Real(0.0);
  result.direction =
      select(is_away, to_goal / select(is_away, result.distance, Real(1.0)), constant<Real>({}));
  result.along = dot(robot.velocity, result.direction);
  result.left = result.distance - Real(step.lag) * result.along;
  return result;
}

/// The deceleration at the end of a soft landing, as a part of the planned braking.
inline constexpr double kLanding = 0.25;

/// Highest next speed of a braking that begins, and ends, without a jolt. It follows speed²/2b +
/// speed T of the distance, T = (T_e + Δt)/2, so that it takes hold within T. Where it would creep,
/// it follows the curve of a quarter of b or of the possible change of the acceleration.
template <typename Real>
AVO_KERNEL Real soft_speed(Real distance, Real braking, Real response_time, Real time_step) {
  const Real lead = braking * Real(0.5) * (response_time + time_step);
  const Real speed = sqrt(lead * lead + Real(2.0) * braking * max(distance, Real(0.0))) - lead;
  const Real softly = min(Real(kLanding), time_step / response_time) * braking * time_step;
  return max(speed, admissible_speed(distance, softly, time_step));
}

/// A method without lag reaches v' in one step, so v' needs only the lead of a soft landing.
template <typename Real>
AVO_KERNEL Vec<Real> approach(const Traveller<Real>& robot, const GoalLine<Real>& line,
                              const StepResponse& step) {
  const Real speed = robot.preferred_speed, time_step(step.time_step);
  const auto is_soft = robot.is_holonomic > Real(step.law.is_gentle() ? 0.0 : 1.0);
  const Real braking = used_of(robot.planned_braking, robot.max_speed, step.law);
  const Real all = min(robot.planned_braking, Real(step.law.comfort_acceleration));
  const Real braking_time = Real(step.rate) * Real(step.control_time);
  const Real u = braking_time * select(is_soft, braking, all);
  const Real time = response_time(robot.max_speed, robot.max_acceleration, braking, step.law);
  const Real response = select(is_soft, time, Real(0.0));
  const Vec<Real> at_speed = speed * line.direction, p = robot.position, goal = robot.goal;
  // more than twice the sum of norms below
  const Real around = Real(0x1p-45) * ((abs(p.x) + abs(p.y)) + (abs(goal.x) + abs(goal.y)));
  const auto known =
      surely_admits(line.left - speed * response, speed, u, time_step) & (line.distance > around);
  if (!any(!known)) return at_speed;
  // nearer than rounding can tell counts as there
  const auto there = line.distance <= Real(0x1p-46) * (norm(p) + norm(goal));
  const Real hard = admissible_speed(line.left, u, time_step);
  const Real stops = select(is_soft, soft_speed(line.left, u / time_step, time, time_step), hard);
  const Vec<Real> slower = min(stops, speed) * line.direction;
  return select(known, at_speed, select(there, constant<Real>({}), slower));
}

/// For a method that approaches v' with the lag of Eq. (7).
template <typename Real>
AVO_KERNEL Vec<Real> lead(const Traveller<Real>& robot, const GoalLine<Real>& line,
                          const StepResponse& step) {
  const Real top = robot.preferred_speed, time_step(step.time_step), rate(step.rate);
  const Real control_time(step.control_time), reach = control_time * robot.planned_braking;
  // the deceleration that D(0, v_max) leaves at every speed: v' = v - v_max is always inside
  const Real change = min(robot.max_speed, reach);
  const Vec<Real> at_speed = top * line.direction;
  const auto known = surely_admits(line.left, top, rate * change, time_step) &
                     (Real(2.0) * line.distance >= Real(1.001) * control_time * top);
  if (!any(!known)) return at_speed;
  // 2 distance/δ: among parked robots less than the full deceleration is left. A robot that counts
  // on the full deceleration oscillates about its goal for ever.
  const Real speed = min(Real(2.0) * line.distance / control_time,
                         admissible_speed(line.left, rate * change, time_step));
  const Vec<Real> v = robot.velocity;
  const Vec<Real> v_new = v + limited((speed * line.direction - v) / rate, reach);
  const Vec<Real> slower = limited(v_new, min(max(norm(v), speed), top));
  return select(known | (speed >= top), at_speed, select(speed < line.along, v_new, slower));
}

/// See preferred_velocity().
template <typename Real>
AVO_KERNEL Vec<Real> preferred_velocity(const Traveller<Real>& robot, const GoalLine<Real>& line,
                                        const StepResponse& step) {
  if (method_traits(step.method).lags) return lead(robot, line, step);
  if (!adopts_at_once(step.method)) return approach(robot, line, step);
  return min(line.distance / Real(step.time_step), robot.preferred_speed) * line.direction;
}

AVO_END_KERNELS

#endif  // once per pass
