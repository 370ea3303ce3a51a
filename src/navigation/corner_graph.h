// SPDX-License-Identifier: Apache-2.0
// The places where shortest ways around walls bend, and which of them see each other
// (docs/navigation.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "navigation/clearance_grid.h"
#include "navigation/lattice.h"

namespace avo {

/// Of more corners, looking at all pairs takes too long.
inline constexpr std::size_t kMostJoinedCorners = 10000;

struct CornerGraph {
  struct Edge {
    std::uint32_t to = 0;
    double length = 0.0;  // m
  };
  double radius = 0.0;  // m, of the robots whose ways it holds
  ClearanceGrid grid;
  std::vector<Vec2> points;          // corners; with a lattice, then the sample of each cell
  std::vector<double> room;          // m, that ways there keep from walls, >= radius; 0: no sample
  std::vector<Vec2> outward;         // of each corner, see Corner
  std::vector<double> most_lean;     // likewise
  std::vector<std::uint32_t> first;  // of each corner's edges; one more than corners
  std::vector<Edge> edges;
  Lattice lattice = {};  // instead of edges, where corners are many

  [[nodiscard]] std::size_t corners() const { return outward.size(); }
  [[nodiscard]] bool is_corner(std::size_t k) const { return k < corners(); }
  [[nodiscard]] std::span<const Edge> edges_of(std::size_t k) const {
    return std::span(edges).subspan(first[k], first[k + 1] - first[k]);
  }
  /// Whether a shortest way may bend at the corner, if it comes or goes in that unit direction:
  /// it passes along the tangent, up to the angle between points around a wall's end.
  [[nodiscard]] bool may_bend(std::size_t corner, Vec2 direction) const {
    const double lean = dot(outward[corner], direction);
    return lean <= most_lean[corner] && -lean <= most_lean[corner];
  }
};

/// Of any set of walls: loose, in any order and direction, touching or overlapping. The radius is
/// > 0. A graph of that radius among mostly the same walls makes it quicker, and changes no bit.
/// Of more corners than `most_joined` it has a lattice.
CornerGraph corner_graph(std::span<const Wall> walls, double radius,
                         const CornerGraph* before = nullptr,
                         std::size_t most_joined = kMostJoinedCorners);

/// The point at exactly that place; the number of points where there is none.
std::uint32_t point_at(const CornerGraph& graph, Vec2 place);

}  // namespace avo
