// SPDX-License-Identifier: Apache-2.0
// Robots that sense each other wrongly, late, or not at all.
#include "sensing.h"

#include <algorithm>

namespace avo::safety {
namespace {

Vec2 unit(Vec2 a) {
  const double length = norm(a);
  return length > 0.0 ? a / length : Vec2{1.0, 0.0};
}

}  // namespace

Senses::Senses(const Sensing& sensing, std::size_t robots, double time_step, std::uint64_t seed)
    : sensing_(sensing), time_step_(time_step), random_(seed, 8) {
  for (std::size_t i = 0; i < robots; ++i) bias_.push_back(unit(in_unit_disc()));
}

Vec2 Senses::in_unit_disc() {
  for (;;) {
    const Vec2 point = random_.in_square(2.0);
    if (norm_squared(point) <= 1.0) return point;
  }
}

Vec2 Senses::error(std::size_t observer, Vec2 away, std::int64_t step) {
  switch (sensing_.shape) {
    case ErrorShape::uniform:
      return in_unit_disc();
    case ErrorShape::rim:
      return unit(in_unit_disc());
    case ErrorShape::farther:
      return away;
    case ErrorShape::bias:
      return bias_[observer];
    case ErrorShape::flips:
      return step % 2 == 0 ? away : -away;
  }
  return {};
}

void Senses::observe(std::size_t observer, std::span<const Robot> robots,
                     std::span<const Robot> before, std::int64_t step,
                     std::vector<Neighbor>& neighbors) {
  const Vec2 here = robots[observer].position;
  neighbors.clear();
  for (std::size_t k = 0; k < robots.size(); ++k) {
    if (k == observer) continue;
    if (sensing_.missed > 0.0 && random_.between(0.0, 1.0) < sensing_.missed) continue;
    const Robot& other = sensing_.delayed || sensing_.stale ? before[k] : robots[k];
    Neighbor neighbor;
    neighbor.position = other.position;
    neighbor.velocity = other.velocity;
    neighbor.radius = sensing_.radius * other.radius;
    neighbor.max_acceleration = other.max_acceleration;
    if (sensing_.delayed && step > 0) {
      neighbor.position = neighbor.position + time_step_ * neighbor.velocity;
    }
    const Vec2 away = unit(other.position - here);
    const Vec2 of_position = error(observer, away, step), of_velocity = error(observer, away, step);
    neighbor.position = neighbor.position + sensing_.error.position * of_position;
    neighbor.velocity = neighbor.velocity + sensing_.error.velocity * of_velocity;
    neighbors.push_back(neighbor);
  }
  std::stable_sort(neighbors.begin(), neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
    return norm_squared(a.position - here) < norm_squared(b.position - here);
  });
}

}  // namespace avo::safety
