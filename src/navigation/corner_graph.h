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

namespace avo {

/// m, that ways keep from walls beyond the robot's radius, where there is room for it.
inline constexpr double kSpareRoom = 0.05;

struct CornerGraph {
  struct Edge {
    std::uint32_t to = 0;
    double length = 0.0;  // m
  };
  double radius = 0.0;  // m, of the robots whose ways it holds
  ClearanceGrid grid;
  std::vector<Vec2> points;
  std::vector<double> room;          // m, that its edges keep from walls, >= radius
  std::vector<Vec2> outward;         // of each point, see Corner
  std::vector<double> most_lean;     // likewise
  std::vector<std::uint32_t> first;  // of each point's edges; one more than points
  std::vector<Edge> edges;

  [[nodiscard]] std::span<const Edge> edges_of(std::size_t k) const {
    return std::span(edges).subspan(first[k], first[k + 1] - first[k]);
  }
};

/// Of any set of walls: loose, in any order and direction, touching or overlapping. The radius is
/// > 0. A graph of that radius among mostly the same walls makes it quicker, and changes no bit.
CornerGraph corner_graph(std::span<const Wall> walls, double radius,
                         const CornerGraph* before = nullptr);

}  // namespace avo
