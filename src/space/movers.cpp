// SPDX-License-Identifier: Apache-2.0
// Where moving obstacles of space are.
#include <algorithm>

#include "avo/space/mover.h"

namespace avo::space {

MoverState state_at(const MovingObstacle& obstacle, double time) {
  const std::vector<TimedPoint>& places = obstacle.trajectory;
  if (places.empty()) {
    const Vec3 velocity = obstacle.velocity + time * obstacle.acceleration;
    return {obstacle.position + (0.5 * time) * (obstacle.velocity + velocity), velocity};
  }
  const auto next = std::upper_bound(places.begin(), places.end(), time,
                                     [](double t, const TimedPoint& p) { return t < p.time; });
  if (next == places.begin()) return {next->position, {}};
  const TimedPoint& last = *(next - 1);
  if (next == places.end()) return {last.position, {}};
  const Vec3 velocity = (next->position - last.position) / (next->time - last.time);
  return {last.position + (time - last.time) * velocity, velocity};
}

Mover mover_at(const MovingObstacle& obstacle, double time) {
  const auto [position, velocity] = state_at(obstacle, time);
  Mover mover;
  mover.position = position, mover.velocity = velocity;
  mover.acceleration = obstacle.acceleration;
  mover.radius = obstacle.radius;
  mover.max_deviation = obstacle.max_deviation;
  mover.max_speed = obstacle.max_speed.value_or(mover.max_speed);
  return mover;
}

}  // namespace avo::space
