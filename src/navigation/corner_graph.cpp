// SPDX-License-Identifier: Apache-2.0
#include "navigation/corner_graph.h"

#include <algorithm>
#include <cmath>

#include "navigation/corners.h"
#include "navigation/known_edges.h"

namespace avo {
namespace {

// Shortest ways pass a corner along its tangent, up to the angle between points around it.
bool may_bend(const CornerGraph& graph, std::size_t k, Vec2 direction) {
  return std::abs(dot(graph.outward[k], direction)) <= graph.most_lean[k];
}

// Whether a shortest way may lead straight from one point to the other one.
bool are_joined(const CornerGraph& graph, std::size_t i, std::size_t k) {
  const Vec2 p = graph.points[i], q = graph.points[k];
  const double length = norm(q - p);
  if (!(length > 0.0)) return false;
  const Vec2 direction = (q - p) / length;
  return may_bend(graph, i, direction) && may_bend(graph, k, direction) &&
         graph.grid.is_clear(p, q, std::min(graph.room[i], graph.room[k]));
}

double widest_of(std::span<const Wall> walls) {
  double widest = 0.0;
  for (const Wall& wall : walls) widest = std::max(widest, wall.radius);
  return widest;
}

}  // namespace

CornerGraph corner_graph(std::span<const Wall> walls, double radius, const CornerGraph* before) {
  CornerGraph graph{
      radius, ClearanceGrid(walls, corner_reach(radius, widest_of(walls))), {}, {}, {}, {}, {}, {}};
  for (const Corner& corner : corners(graph.grid, radius)) {
    graph.points.push_back(corner.point);
    graph.room.push_back(corner.room);
    graph.outward.push_back(corner.outward);
    graph.most_lean.push_back(corner.most_lean);
  }
  const std::size_t count = graph.points.size();
  struct Pair {
    std::uint32_t low, high;
    double length;
  };
  std::vector<Pair> pairs;
  graph.first.assign(count + 1, 0);
  KnownEdges known(graph, before);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::uint32_t k : known.candidates(i)) {
      const std::optional<bool> answer = known.are_joined(i, k);
      if (!(answer ? *answer : are_joined(graph, i, k))) continue;
      pairs.push_back({i, k, norm(graph.points[k] - graph.points[i])});
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
