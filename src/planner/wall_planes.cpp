// SPDX-License-Identifier: Apache-2.0
// Speeds with which a robot can still stop before a wall.
#include "planner/wall_planes.h"

#include <algorithm>
#include <cmath>

#include "certificate/wall_constraints.h"
#include "walls/segment.h"

namespace avo {

// With k whole steps of u and a fraction f of one, V = (k + f) u and
// V Δt + l(V) = u [Δt k (k + 1)/2 + k s + f (Δt (k + 1) + s)]: a quadratic in k, linear in f.
double speed_before(double gap, double max_acceleration, const StepLaw& law) {
  if (!(gap > 0.0)) return 0.0;
  const double u = braking_decrement(max_acceleration, law), h = law.time_step, s = law.lag;
  const auto way_of = [&](double k) { return u * (0.5 * h * k * (k + 1.0) + k * s); };
  const double half = 0.5 * h + s;
  double steps = std::floor((std::sqrt(half * half + 2.0 * h * gap / u) - half) / h);
  if (way_of(steps) > gap) steps -= 1.0;  // rounding
  const double fraction = (gap - way_of(steps)) / (u * (h * (steps + 1.0) + s));
  return u * (steps + std::clamp(fraction, 0.0, 1.0));
}

void append_speed_planes(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                         std::vector<HalfPlane>& half_planes) {
  const double reach =
      wall_reach(norm(robot.velocity), robot.max_speed, robot.max_acceleration, law);
  for (const Wall& wall : walls) {
    const Vec2 away = robot.position - nearest_on({wall.a, wall.b}, robot.position);
    const double distance = norm(away), gap = distance - robot.radius - wall.radius;
    if (!(gap < reach) || !(distance > 0.0)) continue;
    const double speed = speed_before(gap, robot.max_acceleration, law);
    half_planes.push_back({away / distance, -std::min(speed, robot.max_speed)});
  }
}

}  // namespace avo
