// SPDX-License-Identifier: Apache-2.0
// Shortest routes to one goal (docs/navigation.md).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "navigation/corner_graph.h"
#include "walls/segment.h"

namespace avo::inline navigation {

/// The routes to the goal from all points of a graph, or from the points that one robot has asked
/// for. Its entry for a point follows from the graph and the goal alone.
struct PathMap {
  static constexpr std::uint32_t kGoal = 0xffffffff;     // in place of a point
  static constexpr std::uint32_t kNothing = 0xfffffffe;  // in place of a point
  Vec2 goal = {};
  double room = 0.0;     // m, that the last leg keeps from walls
  bool is_free = false;  // whether the robot can be at the goal
  bool is_whole = true;
  // unless it is whole, the corners of the vectors below: one route, to the goal
  std::vector<std::uint32_t> corners;
  std::vector<double> length;       // m, from each corner on; infinity: no route
  std::vector<std::uint32_t> next;  // the point after it, kGoal or kNothing
  std::vector<double> top;  // m, the largest allowed v²/a at each corner for all the turns after it
  // of a field: the next points from the border of the lattice, ascending
  std::vector<std::uint32_t> from_outside;
  /// A known corner.
  struct Known {
    std::uint32_t corner = 0, next = 0;
    double length = 0.0;  // m
  };
  // Unless it is whole: known corners, ascending. They are within `reach` of `from`, or an edge
  // joins them to a corner of `beside`, or they are others. For any other corner there, the sum of
  // its length and its distance to `from` is at least `settled` m.
  std::shared_ptr<const std::vector<Known>> around = {};
  std::vector<std::uint32_t> beside;
  Vec2 from = {};
  double reach = 0.0, settled = 0.0;  // m
  double longest_edge = 0.0;          // m, of the examined edges
  std::vector<Segment> closed = {};   // across gaps between walls: no route leads through them

  [[nodiscard]] bool is_open(Vec2 p, Vec2 q) const {
    return std::none_of(closed.begin(), closed.end(),
                        [&](const Segment& gap) { return leads_across(gap, p, q); });
  }

  /// The index of that point in the entries of points; length.size() where there is none.
  [[nodiscard]] std::size_t place_of(std::uint32_t point) const {
    if (is_whole) return std::min(std::size_t{point}, next.size());
    const auto found = std::find(corners.begin(), corners.end(), point);
    return static_cast<std::size_t>(found - corners.begin());
  }
  [[nodiscard]] const Known* around_at(std::uint32_t corner) const;
  [[nodiscard]] std::uint32_t after(std::uint32_t point) const {
    const std::size_t place = place_of(point);
    return place < next.size() ? next[place] : kNothing;
  }
};

/// A map of the goal alone, without entries of points.
PathMap goal_of(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed = {});
/// The whole map.
PathMap path_map(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed = {});

inline Vec2 point_of(const CornerGraph& graph, const PathMap& map, std::uint32_t target) {
  return target == PathMap::kGoal ? map.goal : graph.points[target];
}

/// Adds the route from that corner on to a map without one, if `known` has an entry for each corner
/// on it. Returns false if an entry is missing.
template <typename Known>
bool add_route(const CornerGraph& graph, std::uint32_t corner, const Known& known, PathMap& map);

/// m, of the route from the target on; infinity: no route is known.
double length_from(const CornerGraph& graph, const PathMap& map, std::uint32_t target);

/// m, the largest allowed v²/a at p on the route to the target; and the turn there, |sin φ|, 1
/// beyond 90 degrees.
double top_before(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                  double& turn);

template <typename Known>
bool add_route(const CornerGraph& graph, std::uint32_t corner, const Known& known, PathMap& map) {
  while (corner != PathMap::kGoal) {
    const std::optional<PathMap::Known> here = known(corner);
    if (!here) return false;
    map.corners.push_back(corner);
    map.length.push_back(here->length);
    map.next.push_back(here->next);
    corner = here->next;
  }
  map.top.assign(map.corners.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = map.corners.size(); k-- > 0;) {
    double turn = 0.0;
    map.top[k] = top_before(graph, map, graph.points[map.corners[k]], map.next[k], turn);
  }
  return true;
}

}  // namespace avo::inline navigation
