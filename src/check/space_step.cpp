// SPDX-License-Identifier: Apache-2.0
#include "check/space_step.h"

#include <algorithm>

#include "core/elementary.h"

namespace avo::judge {

SpaceStep step_of(std::size_t robot, const Cubic& path) {
  SpaceStep step{robot, path, {}, {}};
  step.low = step.high = step.path[0];
  for (const Vec3& point : step.path) {
    step.low = {std::min(step.low.x, point.x), std::min(step.low.y, point.y),
                std::min(step.low.z, point.z)};
    step.high = {std::max(step.high.x, point.x), std::max(step.high.y, point.y),
                 std::max(step.high.z, point.z)};
  }
  return step;
}

Cubic path_of(const space::CheckedState& before, const space::CheckedState& now, double duration) {
  return cubic_of(before.position, before.velocity, now.position, now.velocity, duration);
}

Cubic straight_path(Vec3 from, Vec3 to) {
  const Vec3 third = (to - from) / 3.0;
  return {from, from + third, to - third, to};
}

Cubic in_frame_of(const space::Box& box, const Cubic& path) {
  const auto [c, s] = elementary::direction(box.heading);
  Cubic turned;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3& a = path[i];
    turned[i] = {c * a.x + s * a.y, c * a.y - s * a.x, a.z};
  }
  return turned;
}

double gap(const SpaceStep& a, const SpaceStep& b) {
  return std::max({a.low.x - b.high.x, b.low.x - a.high.x, a.low.y - b.high.y, b.low.y - a.high.y,
                   a.low.z - b.high.z, b.low.z - a.high.z});
}

bool hides(const space::Box& box, Vec3 position, Vec3 goal) {
  constexpr double kEnough = 1e-9, kTouch = 1e-11;  // m
  const auto touches = [&](const Cubic& path) {
    return least_distance(in_frame_of(box, path), Block{box.min, box.max}, box.radius + kEnough) <=
           box.radius + kTouch;
  };
  return touches(straight_path(position, goal)) && !touches(straight_path(goal, goal));
}

double weighed(Vec3 a, double vertical) {
  return norm(Vec3{a.x, a.y, a.z / vertical});
}

bool slows_straight(Vec3 from, Vec3 to) {
  const double speed = norm(from);
  return norm(to) <= speed && dot(from, to) >= 0.0 && norm(cross(from, to)) <= 1e-9 * speed * speed;
}

}  // namespace avo::judge
