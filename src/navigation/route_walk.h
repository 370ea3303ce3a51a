// SPDX-License-Identifier: Apache-2.0
// The pieces of a robot's route, in turn.
#pragma once
#include <cstdint>

#include "navigation/corner_graph.h"
#include "navigation/path_map.h"

namespace avo::inline navigation {

/// Radii of the robot: passages farther off do not matter yet.
inline constexpr double kLooksAhead = 24.0;

/// A straight piece of the route.
struct RoutePiece {
  Vec2 from, to;
  double before = 0.0, length = 0.0;  // m, of the route
  bool is_last = false;
};

/// Calls visit(piece) for the route until it returns false, or the route has become longer than
/// `farthest` m.
template <typename Visit>
void walk_route(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                double farthest, const Visit& visit) {
  RoutePiece piece{p, p};
  while (target != PathMap::kNothing && piece.before <= farthest) {
    piece.is_last = target == PathMap::kGoal;
    piece.to = piece.is_last ? map.goal : graph.points[target];
    piece.length = norm(piece.to - piece.from);
    if (!visit(piece) || piece.is_last) return;
    piece.before += piece.length, piece.from = piece.to;
    target = map.after(target);
  }
}

}  // namespace avo::inline navigation
