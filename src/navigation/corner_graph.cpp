// SPDX-License-Identifier: Apache-2.0
#include "navigation/corner_graph.h"

#include <algorithm>
#include <cmath>

#include "navigation/corners.h"
#include "navigation/known_edges.h"

namespace avo {
namespace {

// Whether a shortest way may lead straight from one point to the other one.
bool are_joined(const CornerGraph& graph, std::size_t i, std::size_t k) {
  const Vec2 p = graph.points[i], q = graph.points[k];
  const double length = norm(q - p);
  if (!(length > 0.0)) return false;
  const Vec2 direction = (q - p) / length;
  return graph.may_bend(i, direction) && graph.may_bend(k, direction) &&
         graph.grid.is_clear(p, q, std::min(graph.room[i], graph.room[k]));
}

// Joins all corners between which a shortest way may lead straight.
void join(CornerGraph& graph, const CornerGraph* before) {
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
}

void add_samples(CornerGraph& graph) {
  graph.lattice = make_lattice(graph.grid, graph.points, graph.radius);
  const std::size_t cells = graph.lattice.cells();
  graph.points.reserve(graph.points.size() + cells);
  graph.room.reserve(graph.points.capacity());
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto sample = sample_in(graph.lattice, cell, graph.grid, graph.radius);
    graph.points.push_back(sample ? sample->point : Vec2{});
    graph.room.push_back(sample ? sample->room : 0.0);
  }
}

}  // namespace

CornerGraph corner_graph(std::span<const Wall> walls, double radius, const CornerGraph* before,
                         std::size_t most_joined) {
  CornerGraph graph{
      radius, ClearanceGrid(walls, corner_reach(radius, widest_of(walls))), {}, {}, {}, {}, {}, {}};
  for (const Corner& corner : corners(graph.grid, radius)) {
    graph.points.push_back(corner.point);
    graph.room.push_back(corner.room);
    graph.outward.push_back(corner.outward);
    graph.most_lean.push_back(corner.most_lean);
  }
  if (graph.points.size() > most_joined)
    add_samples(graph);
  else
    join(graph, before != nullptr && before->lattice.empty() ? before : nullptr);
  return graph;
}

std::uint32_t point_at(const CornerGraph& graph, Vec2 place) {
  const auto count = static_cast<std::uint32_t>(graph.points.size());
  if (graph.lattice.empty()) {
    const auto point = std::find(graph.points.begin(), graph.points.end(), place);
    return static_cast<std::uint32_t>(point - graph.points.begin());
  }
  const std::size_t cell = graph.lattice.cell_of(place);
  const auto sample = static_cast<std::uint32_t>(graph.corners() + cell);
  if (graph.room[sample] > 0.0 && graph.points[sample] == place) return sample;
  for (const std::uint32_t corner : graph.lattice.corners_in(cell)) {
    if (graph.points[corner] == place) return corner;
  }
  return count;
}

}  // namespace avo
