// SPDX-License-Identifier: Apache-2.0
#include "navigator/simplified_route.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/plane.h"
#include "walls/segment.h"

namespace avo::inline navigator {
namespace {

// The point of a chain that is farthest off its chord.
struct Farthest {
  std::size_t at = 0;
  double deviation = 0.0;  // m
};

// A chain that runs back along its chord deviates by as much, so that the order is kept.
Farthest farthest_of(std::span<const Waypoint> points, std::size_t first, std::size_t last) {
  const Segment chord{points[first].place, points[last].place};
  const double length = norm(chord.b - chord.a);
  const Vec2 direction = length > 0.0 ? (chord.b - chord.a) / length : Vec2{};
  Farthest farthest;
  double ahead = 0.0;  // m, along the chord
  for (std::size_t k = first + 1; k < last; ++k) {
    const double along = dot(points[k].place - chord.a, direction);
    ahead = std::max(ahead, along);
    const double deviation = std::max(distance(points[k].place, chord), ahead - along);
    if (deviation > farthest.deviation) farthest = {k, deviation};
  }
  return farthest;
}

}  // namespace

SimplifiedRoute simplified_route(std::span<const Waypoint> points, double most_deviation) {
  std::vector<char> is_kept(points.size(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> chains;
  is_kept[0] = 1;
  for (std::size_t k = 1, first = 0; k < points.size(); ++k) {
    if (k + 1 < points.size() && points[k].stages == 0 && points[k].wait == 0.0) continue;
    chains.emplace_back(first, k);
    first = k;
  }
  SimplifiedRoute route;
  while (!chains.empty()) {
    const auto [first, last] = chains.back();
    chains.pop_back();
    is_kept[last] = 1;
    const Farthest farthest = farthest_of(points, first, last);
    if (farthest.deviation > most_deviation) {
      chains.emplace_back(first, farthest.at);
      chains.emplace_back(farthest.at, last);
    } else {
      route.deviation = std::max(route.deviation, farthest.deviation);
    }
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (is_kept[k] != 0) route.points.push_back(points[k]);
  return route;
}

}  // namespace avo::inline navigator
