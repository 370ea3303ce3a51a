// SPDX-License-Identifier: Apache-2.0
// Coming to rest at a goal under Eq. (7)'s control, in discrete steps.
#include "sim/goals.h"

#include <algorithm>
#include <cmath>

#include "core/scalar.h"

namespace avo {
namespace scalar {
#include "sim/goals_kernel.h"
}  // namespace scalar
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

Vec2 limited(Vec2 a, double length) {
  const double n = norm(a);
  return n > length ? (length / n) * a : a;
}

using Way = scalar::Way<scalar::Pack<double>>;

Vec2 in_plane(const scalar::Vec<scalar::Pack<double>>& a) {
  return {a.x.value, a.y.value};
}

Way find_way(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
             const GoalLaw& law) {
  using Real = scalar::Pack<double>;
  const scalar::Traveller<Real> traveller{
      scalar::constant<Real>(position), scalar::constant<Real>(velocity),
      scalar::constant<Real>(goal),     robot.preferred_speed,
      robot.max_acceleration,           robot.max_speed};
  return scalar::way_of(traveller, law);
}

}  // namespace

GoalLaw goal_law(const Planner& planner) {
  const PlannerOptions& options = planner.options();
  return {options.method, options.time_step, options.control_time, planner.step_rate(),
          planner.step_lag()};
}

Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const GoalLaw& law) {
  const Way way = find_way(position, velocity, robot, goal, law);
  if (way.known.bit) return in_plane(way.preferred);
  const double distance = way.distance.value, left = way.left.value;
  const Vec2 direction = in_plane(way.direction);
  if (law.method == Method::avo) {
    // nearer than rounding can tell: there
    if (distance <= 0x1p-46 * (norm(position) + norm(goal))) return {};
    // it approaches v' as fast as it can, so v' needs no lead
    const double u = law.rate * law.control_time * robot.max_acceleration;
    return std::min(robot.preferred_speed, admissible_speed(left, u, law.time_step)) * direction;
  }
  // the deceleration that D(0, v_max) leaves at every speed: v' = v - v_max is always inside
  const double change = std::min(law.control_time * robot.max_acceleration, robot.max_speed);
  // 2 distance/δ: among parked robots less than the full deceleration is left, and a robot that
  // counts on it swings about its goal for ever
  const double speed = std::min(admissible_speed(left, law.rate * change, law.time_step),
                                2.0 * distance / law.control_time);
  if (speed >= robot.preferred_speed) return robot.preferred_speed * direction;

  const Vec2 wanted =
      limited((speed * direction - velocity) / law.rate, law.control_time * robot.max_acceleration);
  const Vec2 v_new = velocity + wanted;
  if (speed < way.along.value) return v_new;
  return limited(v_new, std::min(robot.preferred_speed, std::max(speed, norm(velocity))));
}

}  // namespace avo
