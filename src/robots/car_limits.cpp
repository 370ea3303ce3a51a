// SPDX-License-Identifier: Apache-2.0
// What a car may choose, and how far its motion may differ from what others expect of it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/car.h"

namespace avo::inline robots {
namespace {

// Limits of a_lin and of v² κ, m/s²; infinite where |a| <= a_max suffices. A car at rest must drive
// before it turns.
struct CarLimits {
  double along, across;
};

CarLimits own_limits(const Car& car, const Robot& robot) {
  const double infinity = std::numeric_limits<double>::infinity(), a_max = robot.max_acceleration;
  const bool exact = car.acceleration_set == AccelerationSet::exact;
  const double turning =
      turns_in_place(car) ? infinity : dot(robot.velocity, robot.velocity) * sharpest(car);
  if (exact) return {a_max, std::min(a_max, turning)};
  return {infinity, turning < a_max ? turning : infinity};
}

}  // namespace

// docs/certificate/wheels.md, "Cars"
Stray stray_of_car(const Car& car, double max_acceleration, double time_step) {
  Stray stray{2.0 * reach_of(car), 0.0};
  if (offset_of(car) == 0.0) return stray;
  const double turn = time_step * std::sqrt(max_acceleration * sharpest(car));
  stray.distance = std::abs(offset_of(car)) * turn * (1.0 + turn * turn);
  return stray;
}

// docs/certificate/clocks.md, "Robots with wheels"
SensingError unforeseen_of_car(const Car& car, double max_acceleration, double time_step) {
  const double excess = (reach_of(car) - 1.0) * max_acceleration * time_step;  // m/s
  SensingError result{0.5 * excess * time_step, excess};
  result.position += stray_of_car(car, max_acceleration, time_step).distance;
  if (offset_of(car) != 0.0 && turns_in_place(car))
    result.position += 0.5 * max_acceleration * time_step * time_step;
  return result;
}

// Others count on at most |v| + u of a robot that decides, which the corners of the square exceed.
// The disc of a car that turns about its axle moves farther than the axle.
double top_speed_of(const Car& car, const Robot& robot, double u) {
  constexpr double kForTurning = 0.9;
  if (!may_exceed_reach(model_traits(robot.model))) return std::numeric_limits<double>::infinity();
  return norm(robot.velocity) + (offset_of(car) == 0.0 ? u : kForTurning * u);
}

Vec2 within_own_limits(const Car& car, const Robot& robot, double time, Vec2 v) {
  if (v == Vec2{} && robot.velocity == v) return v;
  const Vec2 h = ahead_of(robot.heading), change = v - robot.velocity;
  const auto [along, across] = own_limits(car, robot);
  const Vec2 result =
      robot.velocity + std::clamp(dot(h, change), -along * time, along * time) * h +
      std::clamp(cross(h, change), -across * time, across * time) * perpendicular(h);
  const double speed = norm(result);
  const double top = top_speed_of(robot, robot.max_acceleration * time);
  return speed > top ? (top / speed) * result : result;
}

Vec2 approached(const Car& car, const Robot& robot, double time, double increment, Vec2 w) {
  const Vec2 h = ahead_of(robot.heading), v = robot.velocity;
  const double across = own_limits(car, robot).across * time;
  Vec2 next = approach(v, w, increment);
  const double aside = cross(h, next - v);
  if (std::abs(aside) > across) {
    const double along = std::sqrt(increment * increment - across * across);
    next = v + std::clamp(dot(h, w - v), -along, along) * h +
           std::copysign(across, aside) * perpendicular(h);
  }
  return within_own_limits(car, robot, time, next);
}

void append_own_half_planes(const Car& car, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes) {
  const Vec2 h = ahead_of(robot.heading), v = robot.velocity;
  const auto bound = [&](Vec2 normal, double most) {
    if (most == std::numeric_limits<double>::infinity()) return;
    half_planes.push_back({normal, dot(normal, v) - most * time});
    half_planes.push_back({-normal, -dot(normal, v) - most * time});
  };
  const auto [along, across] = own_limits(car, robot);
  bound(h, along), bound(perpendicular(h), across);
}

}  // namespace avo::inline robots
