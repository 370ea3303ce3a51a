// SPDX-License-Identifier: Apache-2.0
// A moving obstacle that goes from point to point, in the same steps as the robots.
#include <algorithm>
#include <cmath>

#include "avo/scenario.h"
#include "planner/arrival.h"

namespace avo {
namespace {

// m/s, of the largest next speed with which, after this step, it can still stop within the
// distance: Δt (along + v)/2 + v²/2a <= distance.
double speed_before(double distance, double along, double max_deviation, double time_step) {
  const double half = 0.5 * max_deviation * time_step;
  const double left = std::max(distance - 0.5 * time_step * along, 0.0);
  return std::sqrt(half * half + 2.0 * max_deviation * left) - half;
}

}  // namespace

PathWalk next_on_path(const MovingObstacle& obstacle, const PathWalk& walk, double time_step) {
  const auto way_to = [&](std::uint32_t target) { return obstacle.path[target] - walk.position; };
  PathWalk next = walk;
  if (norm(way_to(walk.target)) <= obstacle.radius)
    next.target = static_cast<std::uint32_t>((walk.target + 1) % obstacle.path.size());
  const Vec2 way = way_to(next.target);
  const double distance = norm(way);
  Vec2 wanted;
  if (distance > 0.0) {
    const double along = dot(walk.velocity, way) / distance;
    const double speed = speed_before(distance, along, obstacle.max_deviation, time_step);
    wanted = (std::min(speed, *obstacle.max_speed) / distance) * way;
  }
  next.velocity = approach(walk.velocity, wanted, time_step * obstacle.max_deviation);
  next.position = walk.position + (0.5 * time_step) * (walk.velocity + next.velocity);
  return next;
}

}  // namespace avo
