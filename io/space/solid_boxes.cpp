// SPDX-License-Identifier: Apache-2.0
#include "io/space/solid_boxes.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::Box;

constexpr double kThickness = 0.1;   // m, of floors, ceilings and walls
constexpr double kMargin = 2.0;      // m, of infinite boxes around all starts and goals
constexpr double kLeastHalf = 5e-4;  // m: viewers need some thickness

/// The place of all starts and goals, m.
struct Extent {
  Vec3 low, high;

  void include(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

Extent extent_of(const avo::space::Scenario& scene) {
  Extent extent{scene.robots.front().position, scene.robots.front().position};
  const Vec3 margin{kMargin, kMargin, kMargin};
  for (const avo::space::RobotSetup& robot : scene.robots) {
    for (const Vec3& place : {robot.position, robot.goal}) {
      extent.include(place - margin);
      extent.include(place + margin);
    }
  }
  return extent;
}

void make_finite(double& min, double& max, double low, double high) {
  if (std::isinf(min) && std::isinf(max))
    min = low, max = high;
  else if (std::isinf(min))
    min = max - kThickness;
  else if (std::isinf(max))
    max = min + kThickness;
}

SolidBox solid(const Box& box, const Extent& extent) {
  Vec3 min = box.min, max = box.max, low = extent.low, high = extent.high;
  if (box.heading != 0.0) {  // in the frame of the box
    const double reach = norm(avo::Vec2{std::max(std::abs(low.x), std::abs(high.x)),
                                        std::max(std::abs(low.y), std::abs(high.y))});
    low.x = low.y = -reach, high.x = high.y = reach;
  }
  make_finite(min.x, max.x, low.x, high.x);
  make_finite(min.y, max.y, low.y, high.y);
  make_finite(min.z, max.z, low.z, high.z);
  const Vec3 in = 0.5 * (min + max);
  const avo::Vec2 axis = avo::elementary::direction(box.heading);
  const auto half_of = [&](double from, double to) {
    return std::max(0.5 * (to - from) + box.radius, kLeastHalf);
  };
  return {{axis.x * in.x - axis.y * in.y, axis.y * in.x + axis.x * in.y, in.z},
          {half_of(min.x, max.x), half_of(min.y, max.y), half_of(min.z, max.z)},
          avo::elementary::direction(0.5 * box.heading)};
}

}  // namespace

std::vector<SolidBox> solid_boxes_of(const avo::space::Scenario& scene) {
  const Extent extent = extent_of(scene);
  std::vector<SolidBox> boxes;
  for (const Box& box : scene.boxes) boxes.push_back(solid(box, extent));
  return boxes;
}

}  // namespace avo_io
