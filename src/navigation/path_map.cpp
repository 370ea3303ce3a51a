// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "core/plane.h"
#include "navigation/field.h"

namespace avo::inline navigation {
namespace {

constexpr double kTurnRoom = 0.3;  // of the radius: how far a robot may be carried off its route
constexpr double kBraking = 1.6;   // of 2, the part of full braking that is used

// m, the largest allowed v²/a at a turn, see speed_limit().
double top_at(double turn, double radius) {
  return turn > 0.0 ? 2.0 * kTurnRoom * radius / (turn * turn) : kInfinity;
}

// |sin φ| of the turn from one direction into another one, 1 beyond 90 degrees.
double turn_between(Vec2 into, Vec2 out) {
  const double lengths = norm(into) * norm(out);
  if (!(lengths > 0.0)) return 0.0;
  return dot(into, out) > 0.0 ? std::min(std::abs(cross(into, out)) / lengths, 1.0) : 1.0;
}

// Dijkstra's algorithm along the edges.
void spread_along_edges(const CornerGraph& graph, PathMap& map) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t corner, double length, std::uint32_t next) {
    if (!(length < map.length[corner])) return;
    map.length[corner] = length, map.next[corner] = next;
    open.push({length, corner});
  };
  for_each_in_sight(graph, map.goal, map.room, [&](std::uint32_t k) {
    if (map.is_open(map.goal, graph.points[k]))
      reach(k, norm(map.goal - graph.points[k]), PathMap::kGoal);
  });
  while (!open.empty()) {
    const auto [length, corner] = open.top();
    open.pop();
    if (length > map.length[corner]) continue;
    for (const CornerGraph::Edge& edge : graph.edges_of(corner)) {
      if (map.is_open(graph.points[corner], graph.points[edge.to]))
        reach(edge.to, length + edge.length, corner);
    }
  }
}

// Fills the values at corners; corners nearer to the goal come first.
void fill_tops(const CornerGraph& graph, PathMap& map) {
  std::vector<std::pair<double, std::uint32_t>> known;
  for (std::uint32_t k = 0; k < map.length.size(); ++k) {
    if (map.length[k] < kInfinity) known.push_back({map.length[k], k});
  }
  std::sort(known.begin(), known.end());
  for (const auto& [length, k] : known) {
    double turn = 0.0;
    map.top[k] = top_before(graph, map, graph.points[k], map.next[k], turn);
  }
}

}  // namespace

double top_before(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                  double& turn) {
  turn = 0.0;
  if (target == PathMap::kGoal) return kInfinity;
  const Vec2 into = graph.points[target] - p;
  const std::size_t place = map.place_of(target);
  turn = turn_between(into, point_of(graph, map, map.next[place]) - graph.points[target]);
  double top = kInfinity, next_turn = 0.0;
  if (graph.is_corner(target))
    top = map.top[place];
  else
    top = top_before(graph, map, graph.points[target], map.next[place], next_turn);
  return std::min(top_at(turn, graph.radius), top) + kBraking * norm(into);
}

const PathMap::Known* PathMap::around_at(std::uint32_t corner) const {
  if (!around) return nullptr;
  const auto found =
      std::lower_bound(around->begin(), around->end(), corner,
                       [](const Known& known, std::uint32_t k) { return known.corner < k; });
  return found != around->end() && found->corner == corner ? &*found : nullptr;
}

double length_from(const CornerGraph& graph, const PathMap& map, std::uint32_t target) {
  double length = 0.0;
  while (target != PathMap::kGoal && !graph.is_corner(target)) {
    const std::uint32_t next = map.next[target];
    if (next == PathMap::kNothing) return kInfinity;
    length += norm(point_of(graph, map, next) - graph.points[target]);
    target = next;
  }
  if (target == PathMap::kGoal) return length;
  const std::size_t place = map.place_of(target);
  return place < map.length.size() ? length + map.length[place] : kInfinity;
}

PathMap goal_of(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed) {
  PathMap map;
  map.goal = goal;
  map.closed = std::move(closed);
  map.is_whole = false;
  const double clearance = graph.grid.clearance(goal);
  map.is_free = clearance >= graph.radius;
  map.room = std::min(clearance, graph.radius + kSpareRoom) - kLengthRounding * graph.radius;
  return map;
}

PathMap path_map(const CornerGraph& graph, Vec2 goal, std::vector<Segment> closed) {
  PathMap map = goal_of(graph, goal, std::move(closed));
  map.is_whole = true;
  map.length.assign(graph.corners(), kInfinity), map.top.assign(graph.corners(), kInfinity);
  map.next.assign(graph.points.size(), PathMap::kNothing);
  if (!map.is_free) return map;
  if (graph.lattice.empty())
    spread_along_edges(graph, map);
  else
    spread_field(graph, map);
  fill_tops(graph, map);
  return map;
}

}  // namespace avo::inline navigation
