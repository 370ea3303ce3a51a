// SPDX-License-Identifier: Apache-2.0
// All shortest ways to one goal (docs/navigation.md).
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "navigation/corner_graph.h"
#include "walls/segment.h"

namespace avo {

/// For every point of a graph the way to the goal.
struct PathMap {
  static constexpr std::uint32_t kGoal = 0xffffffff;     // instead of a point
  static constexpr std::uint32_t kNothing = 0xfffffffe;  // likewise
  Vec2 goal = {};
  double room = 0.0;                // m, that the last leg keeps from walls
  bool is_free = false;             // whether the robot can be at the goal
  std::vector<double> length;       // m, from each corner on; infinity: no way
  std::vector<std::uint32_t> next;  // the point after it, kGoal or kNothing
  std::vector<double> top;  // m, what v²/a may be at each corner for all the turns behind it
  // of a field: what is next from the border of the lattice, ascending
  std::vector<std::uint32_t> from_outside;
  std::vector<Segment> closed = {};  // across gaps between walls: no way leads through them

  [[nodiscard]] bool is_open(Vec2 p, Vec2 q) const {
    return std::none_of(closed.begin(), closed.end(),
                        [&](const Segment& gap) { return leads_across(gap, p, q); });
  }
};

PathMap path_map(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed = {});

inline Vec2 point_of(const CornerGraph& graph, const PathMap& map, std::uint32_t target) {
  return target == PathMap::kGoal ? map.goal : graph.points[target];
}

/// m, of the way from the target on; infinity: no way.
double length_from(const CornerGraph& graph, const PathMap& map, std::uint32_t target);

/// m, what v²/a may be at p on the way to the target; and the turn there, |sin φ|, 1 beyond 90
/// degrees.
double top_before(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                  double& turn);

}  // namespace avo
