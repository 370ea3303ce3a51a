// SPDX-License-Identifier: Apache-2.0
// Finds the pairs of boxes that come near each other: boxes are sorted along the wider axis and
// swept once.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "avo/vec.h"
#include "core/plane.h"

namespace avo::judge {

/// Low and high end along x and y, m.
struct BoundingBox {
  std::array<double, 2> low, high;
  std::size_t owner = 0;
};

/// Contains the discs of that radius, m, about all of the points and their hull.
inline BoundingBox box_around(std::span<const Vec2> points, double radius, std::size_t owner) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  BoundingBox box;
  box.owner = owner;
  const auto span = [&](std::size_t axis, double Vec2::*coordinate) {
    double low = points[0].*coordinate, high = low;
    for (const Vec2& point : points) {
      low = std::min(low, point.*coordinate);
      high = std::max(high, point.*coordinate);
    }
    const double reach = radius + kRounding * (radius + std::max(std::abs(low), std::abs(high)));
    box.low[axis] = low - reach;
    box.high[axis] = high + reach;
  };
  span(0, &Vec2::x);
  span(1, &Vec2::y);
  return box;
}

/// Contains both; the owner is that of the first one.
inline BoundingBox hull(BoundingBox a, const BoundingBox& b) {
  for (std::size_t k = 0; k < 2; ++k) {
    a.low[k] = std::min(a.low[k], b.low[k]);
    a.high[k] = std::max(a.high[k], b.high[k]);
  }
  return a;
}

/// The axis along which the boxes spread farther.
inline std::size_t wider_axis(const std::vector<BoundingBox>& boxes) {
  std::array<double, 2> least{kInfinity, kInfinity}, most{-kInfinity, -kInfinity};
  for (const BoundingBox& box : boxes) {
    for (std::size_t k = 0; k < 2; ++k) {
      least[k] = std::min(least[k], box.low[k]);
      most[k] = std::max(most[k], box.low[k]);
    }
  }
  return most[1] - least[1] > most[0] - least[0] ? 1 : 0;
}

/// Calls meet(owner, owner) for every pair of boxes less than reach() apart along both axes, for
/// some pairs twice; reach may shrink between the calls. It sorts the boxes.
template <typename Reach, typename Meet>
void sweep(std::vector<BoundingBox>& boxes, const Reach& reach, const Meet& meet) {
  const std::size_t along = wider_axis(boxes), across = 1 - along;
  std::sort(boxes.begin(), boxes.end(), [along](const BoundingBox& a, const BoundingBox& b) {
    return std::pair(a.low[along], a.owner) < std::pair(b.low[along], b.owner);
  });
  // neighbors in this order first: they shorten the reach for all others
  if (!std::isfinite(reach()))
    for (std::size_t i = 0; i + 1 < boxes.size(); ++i) meet(boxes[i].owner, boxes[i + 1].owner);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const BoundingBox& a = boxes[i];
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const BoundingBox& b = boxes[j];
      if (!(b.low[along] - a.high[along] < reach())) break;
      if (std::max(b.low[across] - a.high[across], a.low[across] - b.high[across]) < reach())
        meet(a.owner, b.owner);
    }
  }
}

}  // namespace avo::judge
