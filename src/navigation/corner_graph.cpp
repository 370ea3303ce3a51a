// SPDX-License-Identifier: Apache-2.0
#include "navigation/corner_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/plane.h"
#include "navigation/corners.h"

namespace avo::inline navigation {
namespace {

// with more corners, there would be too many edges
constexpr std::size_t kMostJoinedCorners = 10000;
constexpr double kAllWithin = 64.0;  // radii: long edges are longer

// Returns whether a shortest route may lead straight from one point to the other one.
bool are_joined(const CornerGraph& graph, std::uint32_t i, std::uint32_t k, double length) {
  const Vec2 direction = (graph.points[k] - graph.points[i]) / length;
  if (!graph.may_bend(i, direction) || !graph.may_bend(k, direction)) return false;
  const double room = std::min(graph.room[i], graph.room[k]);
  return graph.grid.is_clear(graph.points[std::min(i, k)], graph.points[std::max(i, k)], room);
}

// Closes the directions that no route comes from or goes to.
void close_aside(const CornerGraph& graph, std::uint32_t corner, Horizons& horizons) {
  const Vec2 outward = graph.outward[corner];
  const double least = graph.most_lean[corner];
  const auto& borders = Horizons::borders();
  for (std::size_t k = 0; k < Horizons::kSectors; ++k) {
    const double one = dot(outward, borders[k]);
    const double other = dot(outward, borders[(k + 1) % Horizons::kSectors]);
    // the sine has no least value within a sector if both of its borders are beyond
    if (std::min(std::abs(one), std::abs(other)) > least + kLengthRounding && one * other > 0.0)
      horizons.close(k, 0.0);
  }
}

// The edges. Beyond all_within, only the nearest corner in each sector without a nearer one gets an
// edge. Sectors do not depend on each other.
CornerGraph::Edges edges_from(const CornerGraph& graph, std::uint32_t i,
                              const CornerGraph::SomeEdges* known) {
  const Vec2 p = graph.points[i];
  CornerGraph::Edges found;
  std::vector<CornerGraph::Edge>& edges = found.all;
  std::array<CornerGraph::Edge, Horizons::kSectors> farther;
  farther.fill({kNoCorner, kInfinity});
  Horizons horizons(p, graph.radius);
  close_aside(graph, i, horizons);
  if (known != nullptr) horizons.close_all_but(known->open), edges = known->edges.all;
  const double most_lean = graph.most_lean[i] * (1.0 + kLengthRounding);
  graph.view.look(p, horizons, [&](std::uint32_t k, Vec2 q) {
    const Vec2 line = q - p;
    const double lean = dot(graph.outward[i], line);
    if (lean * lean > most_lean * most_lean * norm_squared(line) || horizons.is_hidden(q)) return;
    const double length = norm(line);
    if (!(length > 0.0)) return;
    const std::size_t sector = Horizons::sector_of(line);
    CornerGraph::Edge& best = farther[sector];
    const bool is_near = length <= graph.all_within;
    if (!is_near && (length > best.length || (length == best.length && k > best.to))) return;
    if (!are_joined(graph, i, k, length)) return;
    horizons.close(sector, std::max(length, graph.all_within));
    if (is_near)
      edges.push_back({k, length}), best = {kNoCorner, graph.all_within};
    else
      best = {k, length};
  });
  for (const CornerGraph::Edge& edge : farther)
    if (edge.to != kNoCorner) edges.push_back(edge);
  std::sort(edges.begin(), edges.end(),
            [](const auto& one, const auto& other) { return one.to < other.to; });
  found.reach = horizons.reach();
  for (std::size_t k = 0; known != nullptr && k < found.reach.size(); ++k)
    found.reach[k] = std::max(found.reach[k], known->edges.reach[k]);
  return found;
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

CornerGraph graph_among(std::span<const Wall> walls, double radius, ClearanceGrid grid,
                        Corners found, Joining joining) {
  CornerGraph graph;
  graph.radius = radius;
  graph.grid = std::move(grid);
  graph.found = std::move(found);
  for (const Corner& corner : graph.found.all) {
    graph.points.push_back(corner.point);
    graph.room.push_back(corner.room);
    graph.outward.push_back(corner.outward);
    graph.most_lean.push_back(corner.most_lean);
  }
  if (joining == Joining::by_number) {
    const std::size_t count = graph.corners();
    joining = count <= kMostJoinedCorners ? Joining::all : Joining::near;
    if (joining == Joining::near && static_cast<double>(count) > lattice_cells(graph.grid, radius))
      joining = Joining::lattice;
  }
  if (joining == Joining::lattice && graph.corners() > 0) {
    add_samples(graph);
    return graph;
  }
  graph.all_within = joining == Joining::all ? kInfinity : kAllWithin * radius;
  graph.view = ViewIndex(walls, graph.points);
  graph.edges = Memo<CornerGraph::Edges>(graph.corners());
  graph.some_edges = Memo<CornerGraph::SomeEdges>(graph.corners());
  return graph;
}

ClearanceGrid corner_grid(std::span<const Wall> walls, double radius) {
  return {walls, corner_reach(radius, widest_of(walls))};
}

std::span<const CornerGraph::Edge> CornerGraph::edges_of(std::size_t k) const {
  const auto find = [&] {
    return edges_from(*this, static_cast<std::uint32_t>(k), some_edges.known(k));
  };
  return edges.get(k, find).all;
}

CornerGraph corner_graph(std::span<const Wall> walls, double radius, Joining joining) {
  ClearanceGrid grid = corner_grid(walls, radius);
  Corners found = corners(grid, radius);
  return graph_among(walls, radius, std::move(grid), std::move(found), joining);
}

std::uint32_t point_at(const CornerGraph& graph, Vec2 place) {
  auto found = static_cast<std::uint32_t>(graph.points.size());
  if (graph.lattice.empty()) {
    graph.view.for_each_near(place, [&](std::uint32_t k) {
      if (graph.points[k] == place) found = std::min(found, k);
    });
    return found;
  }
  const std::size_t cell = graph.lattice.cell_of(place);
  const auto sample = static_cast<std::uint32_t>(graph.corners() + cell);
  if (graph.room[sample] > 0.0 && graph.points[sample] == place) return sample;
  for (const std::uint32_t corner : graph.lattice.corners_in(cell)) {
    if (graph.points[corner] == place) return corner;
  }
  return found;
}

}  // namespace avo::inline navigation
