// SPDX-License-Identifier: Apache-2.0
// The places where shortest routes around walls bend, and which of them see each other
// (docs/navigation.md).
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "core/memo.h"
#include "navigation/clearance_grid.h"
#include "navigation/corners.h"
#include "navigation/lattice.h"
#include "navigation/view.h"

namespace avo::inline navigation {

struct CornerGraph {
  struct Edge {
    std::uint32_t to = 0;
    double length = 0.0;  // m
  };
  struct Edges {
    std::vector<Edge> all;
    std::array<float, Horizons::kParts> reach;  // m: nothing farther off affects the edges
  };
  /// The edges outside of some sectors, which have not been searched yet.
  struct SomeEdges {
    Edges edges;
    Horizons::Sectors open;
  };
  double radius = 0.0;  // m, of the robots for which it holds routes
  ClearanceGrid grid;
  std::vector<Vec2> points;       // corners; with a lattice, then the sample of each cell
  std::vector<double> room;       // m, that routes there keep from walls, >= radius; 0: no sample
  std::vector<Vec2> outward;      // of each corner, see Corner
  std::vector<double> most_lean;  // of each corner, see Corner
  double all_within = 0.0;        // m: within this distance there are all edges
  ViewIndex view;
  Memo<Edges> edges;           // of each corner, once requested
  Memo<SomeEdges> some_edges;  // known before a request
  Corners found;
  Lattice lattice = {};  // instead of edges, where nearly every place has corners

  [[nodiscard]] std::size_t corners() const { return outward.size(); }
  [[nodiscard]] bool is_corner(std::size_t k) const { return k < corners(); }
  /// Ascending, to all corners to which a shortest route may lead straight; callable from any
  /// thread.
  [[nodiscard]] std::span<const Edge> edges_of(std::size_t k) const;
  /// Returns whether a shortest route may bend at the corner, if it comes or goes in that unit
  /// direction. It passes along the tangent, up to the angle between points around a wall's end.
  [[nodiscard]] bool may_bend(std::size_t corner, Vec2 direction) const {
    const double lean = dot(outward[corner], direction);
    return lean <= most_lean[corner] && -lean <= most_lean[corner];
  }
};

/// Which places see each other.
enum class Joining : std::uint8_t {
  by_number,  ///< by the number of the corners, and their density
  all,        ///< all corners that see each other
  near,       ///< corners that are near, and otherwise the nearest one in each direction
  lattice,    ///< an any-angle field over a lattice takes the place of edges
};

/// Makes the graph for any set of walls: loose, in any order and direction, touching or
/// overlapping. The radius must be > 0.
CornerGraph corner_graph(std::span<const Wall> walls, double radius,
                         Joining joining = Joining::by_number);

/// The two parts of making it: the grid that finds walls in the range on which corners depend, and
/// the graph of the found corners.
ClearanceGrid corner_grid(std::span<const Wall> walls, double radius);
CornerGraph graph_among(std::span<const Wall> walls, double radius, ClearanceGrid grid,
                        Corners found, Joining joining);

/// Calls visit(corner) for each corner in sight of a place, where the segment keeps that room, m,
/// or the corner's where that is less.
template <typename Visit>
void for_each_in_sight(const CornerGraph& graph, Vec2 place, double room, const Visit& visit) {
  Horizons horizons(place, std::min(room, graph.radius));
  graph.view.look(place, horizons, [&](std::uint32_t k, Vec2 q) {
    if (!horizons.is_hidden(q) && graph.grid.is_clear(place, q, std::min(room, graph.room[k])))
      visit(k);
  });
}

/// The point at exactly that place; the number of points if there is none.
std::uint32_t point_at(const CornerGraph& graph, Vec2 place);

}  // namespace avo::inline navigation
