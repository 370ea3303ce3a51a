// SPDX-License-Identifier: Apache-2.0
// Shortest ways to one goal (docs/navigation.md).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "navigation/corner_graph.h"
#include "walls/segment.h"

namespace avo {

/// The ways to the goal from all points of a graph, or from those that one robot has asked for.
/// What it tells of a point follows from the graph and the goal alone.
struct PathMap {
  static constexpr std::uint32_t kGoal = 0xffffffff;     // instead of a point
  static constexpr std::uint32_t kNothing = 0xfffffffe;  // likewise
  Vec2 goal = {};
  double room = 0.0;     // m, that the last leg keeps from walls
  bool is_free = false;  // whether the robot can be at the goal
  bool is_whole = true;
  std::vector<std::uint32_t> corners;  // unless it is whole, of those below: one way, to the goal
  std::vector<double> length;          // m, from each corner on; infinity: no way
  std::vector<std::uint32_t> next;     // the point after it, kGoal or kNothing
  std::vector<double> top;  // m, what v²/a may be at each corner for all the turns behind it
  // of a field: what is next from the border of the lattice, ascending
  std::vector<std::uint32_t> from_outside;
  // Unless it is whole: lengths of corners beside the way, ascending; from any other corner beside
  // it, the length and the distance to `from` are `settled` m at least.
  std::vector<std::pair<std::uint32_t, double>> beside = {};
  Vec2 from = {};
  double settled = 0.0;
  std::vector<Segment> closed = {};  // across gaps between walls: no way leads through them

  [[nodiscard]] bool is_open(Vec2 p, Vec2 q) const {
    return std::none_of(closed.begin(), closed.end(),
                        [&](const Segment& gap) { return leads_across(gap, p, q); });
  }

  /// Where that point is in what it tells of points; length.size() where it tells nothing.
  [[nodiscard]] std::size_t place_of(std::uint32_t point) const {
    if (is_whole) return std::min(std::size_t{point}, next.size());
    const auto found = std::find(corners.begin(), corners.end(), point);
    return static_cast<std::size_t>(found - corners.begin());
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t point) const {
    const std::size_t place = place_of(point);
    return place < next.size() ? next[place] : kNothing;
  }
};

/// The goal alone, and nothing of any point.
PathMap goal_of(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed = {});
/// The whole map.
PathMap path_map(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed = {});

inline Vec2 point_of(const CornerGraph& graph, const PathMap& map, std::uint32_t target) {
  return target == PathMap::kGoal ? map.goal : graph.points[target];
}

/// m, of the way from the target on; infinity: no way is known.
double length_from(const CornerGraph& graph, const PathMap& map, std::uint32_t target);

/// m, what v²/a may be at p on the way to the target; and the turn there, |sin φ|, 1 beyond 90
/// degrees.
double top_before(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                  double& turn);

}  // namespace avo
