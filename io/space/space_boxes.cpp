// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_boxes.h"

#include <algorithm>

#include "core/elementary.h"

namespace avo_io {

using avo::Vec3;
using avo::space::Box;

Box box_of(const SpaceBox& bounds) {
  const Vec3 center = 0.5 * (bounds.min + bounds.max), half = bounds.max - center;
  const avo::Vec2 axis = avo::elementary::direction(bounds.heading);
  const Vec3 in{axis.x * center.x + axis.y * center.y, axis.x * center.y - axis.y * center.x,
                center.z};
  return {in - half, in + half, bounds.heading, 0.0};
}

Box box_of(const avo::Wall& wall, double low, double high) {
  const avo::Vec2 line = wall.b - wall.a;
  Box box;
  box.heading = line == avo::Vec2{} ? 0.0 : avo::elementary::atan2(line.y, line.x);
  const avo::Vec2 axis = avo::elementary::direction(box.heading);
  const auto along = [&](avo::Vec2 a) { return axis.x * a.x + axis.y * a.y; };
  const auto across = [&](avo::Vec2 a) { return axis.x * a.y - axis.y * a.x; };
  box.min = {std::min(along(wall.a), along(wall.b)), std::min(across(wall.a), across(wall.b)), low};
  box.max = {std::max(along(wall.a), along(wall.b)), std::max(across(wall.a), across(wall.b)),
             high};
  box.radius = wall.radius;
  return box;
}

}  // namespace avo_io
