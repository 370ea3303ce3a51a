// SPDX-License-Identifier: Apache-2.0
#include "navigation/pockets.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace avo::inline navigation {
namespace {

constexpr double kFreeSight = 0.999;  // of the radius, on segments around a pocket
constexpr double kPocket = 1.1;       // radii behind a gap: the place of a robot in a pocket
constexpr double kOutOfPocket = 2.0;  // radii from there: a robot that gets so far is in no pocket

}  // namespace

bool leads_into_pocket(const ClearanceGrid& grid, const Gap& gap) {
  if (gap.two_lanes) return false;
  const double room = kFreeSight * gap.radius, farther = kOutOfPocket * gap.radius;
  const Vec2 middle = gap.middle();
  for (const Vec2 ahead : {gap.ahead(), -1.0 * gap.ahead()}) {
    const Vec2 inside = middle + kPocket * gap.radius * ahead, left = perpendicular(ahead);
    const std::array directions{ahead, left, -1.0 * left, (ahead + left) / std::numbers::sqrt2,
                                (ahead - left) / std::numbers::sqrt2};
    const bool has_room = grid.is_clear(middle, inside, room);
    if (has_room && std::none_of(directions.begin(), directions.end(), [&](Vec2 direction) {
          return grid.is_clear(inside, inside + farther * direction, room);
        }))
      return true;
  }
  return false;
}

}  // namespace avo::inline navigation
