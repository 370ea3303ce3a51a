// SPDX-License-Identifier: Apache-2.0
// A moving obstacle that goes from point to point, in the same steps as the robots.
#include <algorithm>

#include "avo/scenario.h"
#include "core/plane.h"
#include "sim/goals_kernel.h"

namespace avo {

PathWalk next_on_path(const MovingObstacle& obstacle, const PathWalk& walk, double time_step) {
  const auto way_to = [&](std::uint32_t target) { return obstacle.path[target] - walk.position; };
  PathWalk next = walk;
  if (norm(way_to(walk.target)) <= obstacle.radius)
    next.target = static_cast<std::uint32_t>((walk.target + 1) % obstacle.path.size());
  const Vec2 way = way_to(next.target);
  const double distance = norm(way);
  Vec2 wanted;
  if (distance > 0.0) {
    // after this step it can still stop there
    using Real = scalar::Pack<double>;
    const double left = distance - 0.5 * time_step * dot(walk.velocity, way) / distance;
    const double speed = scalar::admissible_speed(
                             Real(left), Real(time_step * obstacle.max_deviation), Real(time_step))
                             .value;
    wanted = (std::min(speed, *obstacle.max_speed) / distance) * way;
  }
  next.velocity = approach(walk.velocity, wanted, time_step * obstacle.max_deviation);
  next.position = walk.position + (0.5 * time_step) * (walk.velocity + next.velocity);
  return next;
}

}  // namespace avo
