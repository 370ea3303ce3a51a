// SPDX-License-Identifier: Apache-2.0
// A moving obstacle that moves from point to point, in the same steps as the robots, or that
// follows a trajectory.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "avo/scenario.h"
#include "core/plane.h"
#include "core/timed_places.h"
#include "guidance/goals_kernel.h"

namespace avo {

PathWalk next_on_path(const MovingObstacle& obstacle, const PathWalk& walk, double time_step) {
  const auto vector_to = [&](std::uint32_t target) {
    return obstacle.path[target] - walk.position;
  };
  PathWalk next = walk;
  if (norm(vector_to(walk.next_point)) <= obstacle.radius)
    next.next_point = static_cast<std::uint32_t>((walk.next_point + 1) % obstacle.path.size());
  const Vec2 to_next = vector_to(next.next_point);
  const double distance = norm(to_next);
  Vec2 wanted;
  if (distance > 0.0) {
    // after this step it can still stop there
    using Real = scalar::Pack<double>;
    const double left = distance - 0.5 * time_step * dot(walk.velocity, to_next) / distance;
    const double speed = scalar::admissible_speed(
                             Real(left), Real(time_step * obstacle.max_deviation), Real(time_step))
                             .value;
    wanted = (std::min(speed, *obstacle.max_speed) / distance) * to_next;
  }
  next.velocity = approach(walk.velocity, wanted, time_step * obstacle.max_deviation);
  next.position = walk.position + (0.5 * time_step) * (walk.velocity + next.velocity);
  return next;
}

PathWalk on_trajectory(const MovingObstacle& obstacle, double time) {
  const std::vector<TimedPlace>& places = obstacle.trajectory;
  const std::size_t next = first_later(places, time);
  const auto target = static_cast<std::uint32_t>(next);
  if (next == 0) return {places[0].position, {}, target};
  const TimedPlace& last = places[next - 1];
  if (next == places.size()) return {last.position, {}, target - 1};
  const Vec2 velocity = (places[next].position - last.position) / (places[next].time - last.time);
  return {last.position + (time - last.time) * velocity, velocity, target};
}

void start_on_trajectory(MovingObstacle& obstacle) {
  if (obstacle.trajectory.empty()) return;
  const PathWalk start = on_trajectory(obstacle, 0.0);
  obstacle.position = start.position, obstacle.velocity = start.velocity;
}

}  // namespace avo
