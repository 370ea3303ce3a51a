// SPDX-License-Identifier: Apache-2.0
// Coming to rest at a goal under Eq. (7)'s control, in discrete steps.
#include "sim/goals.h"

#include <algorithm>
#include <cmath>

namespace avo {
namespace {

// Highest next speed from which full braking, `decrement` m/s a step, ends within `distance`
// of where the robot will be. Braking from (k + f) q, q = decrement, after a step that ends with
// this speed, takes Δt q (k + 1)(k/2 + f) in all.
double admissible_speed(double distance, double decrement, double time_step) {
  if (!(distance > 0.0)) return 0.0;
  const double y = distance / (decrement * time_step);
  const double k = std::floor(0.5 * (std::sqrt(1.0 + 8.0 * y) - 1.0));
  const double f = (y - 0.5 * k * (k + 1.0)) / (k + 1.0);
  return (k + f) * decrement;
}

// Whether admissible_speed() is at least `speed`, told without root or floor: with x = k + f,
// (k + 1)(k/2 + f) <= (x + 1) x. False where it is not as clear as that.
bool surely_admits(double distance, double speed, double decrement, double time_step) {
  constexpr double kMargin = 1.001;  // for rounding
  return distance * decrement > kMargin * time_step * speed * (speed + decrement);
}

Vec2 limited(Vec2 a, double length) {
  const double n = norm(a);
  return n > length ? (length / n) * a : a;
}

}  // namespace

Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const Planner& planner) {
  const PlannerOptions& options = planner.options();
  const Vec2 way = goal - position;
  const double distance = norm(way);
  const Vec2 direction = distance > 0.0 ? way / distance : Vec2{};
  if (adopts_at_once(options.method)) {
    return std::min(robot.preferred_speed, distance / options.time_step) * direction;
  }

  if (options.method == Method::avo) {
    // nearer than rounding can tell: there
    if (distance <= 0x1p-46 * (norm(position) + norm(goal))) return {};
    // it approaches v' as fast as it can, so v' needs no lead
    const double u = planner.step_rate() * options.control_time * robot.max_acceleration;
    const double left = distance - planner.step_lag() * dot(velocity, direction);
    if (surely_admits(left, robot.preferred_speed, u, options.time_step)) {
      return robot.preferred_speed * direction;
    }
    const double speed = admissible_speed(left, u, options.time_step);
    return std::min(robot.preferred_speed, speed) * direction;
  }
  // the deceleration that D(0, v_max) leaves at every speed: v' = v - v_max is always inside
  const double change = std::min(options.control_time * robot.max_acceleration, robot.max_speed);
  const double rate = planner.step_rate();
  const double along = dot(velocity, direction);
  const double left = distance - planner.step_lag() * along;
  if (surely_admits(left, robot.preferred_speed, rate * change, options.time_step) &&
      2.0 * distance >= 1.001 * options.control_time * robot.preferred_speed) {
    return robot.preferred_speed * direction;
  }
  // 2 distance/δ: among parked robots less than the full deceleration is left, and a robot that
  // counts on it swings about its goal for ever
  const double speed = std::min(admissible_speed(left, rate * change, options.time_step),
                                2.0 * distance / options.control_time);
  if (speed >= robot.preferred_speed) return robot.preferred_speed * direction;

  const Vec2 wanted =
      limited((speed * direction - velocity) / rate, options.control_time * robot.max_acceleration);
  const Vec2 v_new = velocity + wanted;
  if (speed < along) return v_new;
  return limited(v_new, std::min(robot.preferred_speed, std::max(speed, norm(velocity))));
}

}  // namespace avo
