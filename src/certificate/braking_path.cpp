// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps.
#include "certificate/braking_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "robots/motion.h"

namespace avo {

double braking_steps(double speed, double decrement) {
  return speed > 0.0 ? std::floor(speed / decrement) + 1.0 : 0.0;
}

double braking_steps_at_least(double speed, double decrement) {
  const double steps = speed / decrement;
  // of each of the subtractions that lead to it
  const double rounding = 0x1p-30 + 0x1p-51 * steps * steps;
  return std::max(std::ceil(steps - rounding), 0.0);
}

double stopping_length(double speed, double decrement, const StepLaw& law) {
  // speed = (k + f) u: k full steps, and a last one that takes off the rest, f u
  const double k = std::floor(speed / decrement);
  const double rest = std::max(speed - k * decrement, 0.0);
  return law.time_step * k * (0.5 * (k - 1.0) * decrement + rest) +
         law.lag * (k * decrement + rest);
}

Vec2 braked(Vec2 velocity, double decrement) {
  const double speed = norm(velocity);
  return speed > decrement ? ((speed - decrement) / speed) * velocity : Vec2{};
}

void BrakingDistances::brake(double speed, double decrement, const StepLaw& law, int intervals) {
  const auto count = static_cast<std::size_t>(std::max(intervals, 0));
  if (start.size() < count) start.resize(count), middle.resize(count), end.resize(count);
  const double lead = law.time_step - law.lag;
  double distance = 0.0;
  for (std::size_t m = 0; m < count; ++m) {
    start[m] = distance;
    middle[m] = distance + law.lag * speed;
    speed = std::max(speed - decrement, 0.0);
    distance = middle[m] + lead * speed;
    end[m] = distance;
  }
}

Plan plan_to(const Robot& robot, Vec2 next_velocity, const StepLaw& law) {
  const double rate = law.braking_time / law.control_time;
  Plan plan;
  plan.new_velocity = robot.velocity + (next_velocity - robot.velocity) / rate;
  plan.acceleration = (plan.new_velocity - robot.velocity) / law.control_time;
  return plan;
}

void follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law, int intervals,
            CandidatePath& path) {
  path.bend = 0.0;
  path.first = law.lag * robot.velocity + (law.time_step - law.lag) * next_velocity;
  path.next_velocity = next_velocity;
  if (robot.car) {
    const MotionStep step =
        advance_car({{}, robot.velocity, robot.car->heading}, plan_to(robot, next_velocity, law),
                    {robot.car->wheelbase, robot.max_acceleration, robot.max_speed}, law.time_step);
    path.first = step.next.position;
    path.next_velocity = step.next.velocity;
    path.bend = step.bend;
  }
  const double decrement = braking_decrement(robot.max_acceleration, law);
  path.speed = norm(path.next_velocity);
  path.direction = path.speed > 0.0 ? path.next_velocity / path.speed : Vec2{};
  const bool stays = path.speed == 0.0 && robot.velocity == Vec2{};
  constexpr double kForEver = 1e9;  // more than any wall's interval
  const double steps = std::min(braking_steps(path.speed, decrement), kForEver);
  path.moving = stays ? 0 : 1 + static_cast<int>(steps);
  path.braking.brake(path.speed, decrement, law, intervals);
}

}  // namespace avo
