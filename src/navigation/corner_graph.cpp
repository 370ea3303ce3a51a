// SPDX-License-Identifier: Apache-2.0
#include "navigation/corner_graph.h"

#include <algorithm>
#include <cmath>

#include "navigation/corners.h"

namespace avo {
namespace {

// Shortest ways pass a corner along its tangent, up to the angle between points around it.
bool may_bend(const Corner& corner, Vec2 direction) {
  return std::abs(dot(corner.outward, direction)) <= corner.most_lean;
}

double widest_of(std::span<const Wall> walls) {
  double widest = 0.0;
  for (const Wall& wall : walls) widest = std::max(widest, wall.radius);
  return widest;
}

}  // namespace

CornerGraph corner_graph(std::span<const Wall> walls, double radius) {
  CornerGraph graph{
      radius, ClearanceGrid(walls, corner_reach(radius, widest_of(walls))), {}, {}, {}, {}};
  const std::vector<Corner> points = corners(graph.grid, radius);
  const std::size_t count = points.size();
  struct Pair {
    std::uint32_t low, high;
    double length;
  };
  std::vector<Pair> pairs;
  graph.first.assign(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    graph.points.push_back(points[i].point);
    graph.room.push_back(points[i].room);
    for (std::size_t k = i + 1; k < count; ++k) {
      const Vec2 way = points[k].point - points[i].point;
      const double length = norm(way);
      if (!(length > 0.0)) continue;
      const Vec2 direction = way / length;
      if (!may_bend(points[i], direction) || !may_bend(points[k], direction)) continue;
      const double room = std::min(points[i].room, points[k].room);
      if (!graph.grid.is_clear(points[i].point, points[k].point, room)) continue;
      pairs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), length});
      ++graph.first[i + 1], ++graph.first[k + 1];
    }
  }
  for (std::size_t k = 1; k <= count; ++k) graph.first[k] += graph.first[k - 1];
  graph.edges.resize(2 * pairs.size());
  std::vector<std::uint32_t> end(graph.first.begin(), graph.first.end() - 1);
  for (const Pair& pair : pairs) {
    graph.edges[end[pair.low]++] = {pair.high, pair.length};
    graph.edges[end[pair.high]++] = {pair.low, pair.length};
  }
  return graph;
}

}  // namespace avo
