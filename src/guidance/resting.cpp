// SPDX-License-Identifier: Apache-2.0
#include "guidance/resting.h"

#include <cmath>
#include <numbers>

namespace avo::inline guidance {
namespace {

constexpr double kNearlyAtRest = 0.05;  // m/s
// of the radius: the places of a slow mover are rounded to steps of this size
constexpr double kMoved = 0.25;

}  // namespace

std::optional<Wall> resting_disc(Vec2 position, Vec2 velocity, double radius, bool is_exact) {
  if (!(norm_squared(velocity) <= kNearlyAtRest * kNearlyAtRest)) return std::nullopt;
  if (velocity == Vec2{} && is_exact) return Wall{position, position, radius};
  const double step = kMoved * radius;
  const Vec2 place{step * std::round(position.x / step), step * std::round(position.y / step)};
  return Wall{place, place, radius + 0.5 * std::numbers::sqrt2 * step};
}

}  // namespace avo::inline guidance
