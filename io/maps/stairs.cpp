// SPDX-License-Identifier: Apache-2.0
// Stairs are found by their turns: corners that stick out and corners of free cells alternate, one
// cell apart.
#include "io/maps/stairs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace avo_io {
namespace {

/// A distance of so many cells to the right and up.
struct Stretch {
  std::int64_t x = 0, y = 0;
};

Stretch from_to(Corner a, Corner b) {
  return {b.x - a.x, b.y - a.y};
}

/// > 0: to the left, around a corner of free space; < 0: around a corner that sticks out into it.
std::int64_t turn(Stretch first, Stretch second) {
  return first.x * second.y - first.y * second.x;
}

std::int64_t length(Stretch stretch) {
  return std::abs(stretch.x) + std::abs(stretch.y);
}

/// The corners of a closed contour, by an index that wraps around.
struct Around {
  const Contour& contour;

  [[nodiscard]] Corner operator[](std::size_t k) const { return contour[k % contour.size()]; }
  [[nodiscard]] std::size_t before(std::size_t k, std::size_t steps = 1) const {
    return k + contour.size() - steps;
  }
  [[nodiscard]] std::int64_t turn_at(std::size_t k) const {
    const Corner here = (*this)[k];
    return turn(from_to((*this)[before(k)], here), from_to(here, (*this)[k + 1]));
  }
};

/// Returns whether it is the inner corner of a step, between two corners that stick out.
bool is_step(const Around& around, std::size_t k) {
  const Corner before = around[around.before(k)], here = around[k], next = around[k + 1];
  return around.turn_at(k) > 0 && around.turn_at(around.before(k)) < 0 &&
         around.turn_at(k + 1) < 0 && length(from_to(before, here)) == 1 &&
         length(from_to(here, next)) == 1;
}

/// Returns the corner one cell from a towards b.
Corner next_to(Corner a, Corner b) {
  const Stretch stretch = from_to(a, b);
  return {a.x + stretch.x / length(stretch), a.y + stretch.y / length(stretch)};
}

/// Returns whether the stretch has room for a cut at one end, and at the other end if that is an
/// inner corner.
bool is_long(const Around& around, std::size_t k, std::size_t end) {
  return length(from_to(around[k], around[end])) >= (around.turn_at(end) > 0 ? 3 : 2);
}

/// Moves the inner corner of a longer step before or behind steps. Its last cell is cut off there,
/// so that one wall continues along both.
Corner cut_back(const Around& around, std::size_t k) {
  const Corner here = around[k];
  const std::size_t before = around.before(k), next = k + 1;
  if (around.turn_at(k) < 0) return here;
  const bool steps_follow = around.turn_at(next) < 0 && length(from_to(here, around[next])) == 1 &&
                            is_step(around, k + 2);
  if (steps_follow && is_long(around, k, before)) return next_to(here, around[before]);
  const bool follows_steps = around.turn_at(before) < 0 &&
                             length(from_to(around[before], here)) == 1 &&
                             is_step(around, around.before(k, 2));
  if (follows_steps && is_long(around, k, next)) return next_to(here, around[next]);
  return here;
}

}  // namespace

Contour without_stairs(const Contour& contour) {
  const Around around{contour};
  Contour cut;
  for (std::size_t k = 0; k < contour.size(); ++k)
    if (!is_step(around, k)) cut.push_back(cut_back(around, k));
  Contour straight;
  const Around corners{cut};
  for (std::size_t k = 0; k < cut.size(); ++k)
    if (corners.turn_at(k) != 0) straight.push_back(cut[k]);
  return straight;
}

void restore_large_stairs(std::vector<avo::StaticObstacle>& obstacles, double radius) {
  for (avo::StaticObstacle& obstacle : obstacles) {
    if (obstacle.measured.empty()) continue;
    double cell =
        std::numeric_limits<double>::infinity();  // each shortest wall is the side of a step
    for (const avo::Chain& chain : obstacle.measured)
      for (std::size_t k = 1; k < chain.points.size(); ++k)
        cell = std::min(cell, norm(chain.points[k] - chain.points[k - 1]));
    constexpr double kRounding = 1e-9;
    if (!(4.0 * cell < (1.0 - kRounding) * radius))
      obstacle.chains = std::exchange(obstacle.measured, {});
  }
}

}  // namespace avo_io
