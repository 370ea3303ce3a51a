// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTurnRoom = 0.3;   // of the radius: how far a robot may be carried off its way
constexpr double kBraking = 1.6;    // of 2, the part of full braking that is counted upon
constexpr double kRounding = 1e-9;  // of the radius
constexpr double kPassed = 0.3;     // of the radius: so near a corner counts as passed

// m, what v²/a may be at a turn, see speed_limit().
double top_at(double turn, double radius) {
  return turn > 0.0 ? 2.0 * kTurnRoom * radius / (turn * turn) : kInfinity;
}

// |sin φ| of the turn from one direction into another one, 1 beyond 90 degrees.
double turn_between(Vec2 into, Vec2 out) {
  const double lengths = norm(into) * norm(out);
  if (!(lengths > 0.0)) return 0.0;
  return dot(into, out) > 0.0 ? std::min(std::abs(cross(into, out)) / lengths, 1.0) : 1.0;
}

Vec2 point_of(const CornerGraph& graph, const PathMap& map, std::uint32_t target) {
  return target == PathMap::kGoal ? map.goal : graph.points[target];
}

// What v²/a may be at p on the way to the target.
double top_before(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
                  double& turn) {
  turn = 0.0;
  if (target == PathMap::kGoal) return kInfinity;
  const Vec2 into = graph.points[target] - p;
  turn = turn_between(into, point_of(graph, map, map.next[target]) - graph.points[target]);
  return std::min(top_at(turn, graph.radius), map.top[target]) + kBraking * norm(into);
}

// One robot's looking for its next target.
struct Lookout {
  const CornerGraph& graph;
  const PathMap& map;
  Vec2 p;
  double radius;  // m
  double room;    // m, that its way keeps where it has it
  LegScratch& scratch;

  double length_by(std::uint32_t target) const {
    if (target == PathMap::kGoal) return map.is_free ? norm(map.goal - p) : kInfinity;
    return map.length[target] + norm(graph.points[target] - p);
  }
  bool sees(std::uint32_t target) const {
    const double there = target == PathMap::kGoal ? map.room : graph.room[target];
    return graph.grid.is_clear(p, point_of(graph, map, target), std::min(room, there));
  }
};

std::uint32_t nearest_in_view(const Lookout& lookout) {
  const PathMap& map = lookout.map;
  std::vector<std::pair<double, std::uint32_t>>& targets = lookout.scratch.targets;
  targets.clear();
  targets.reserve(map.length.size() + 1);
  for (std::uint32_t k = 0; k < map.length.size(); ++k) {
    if (map.length[k] < kInfinity) targets.push_back({lookout.length_by(k), k});
  }
  if (map.is_free) targets.push_back({lookout.length_by(PathMap::kGoal), PathMap::kGoal});
  const auto farther = std::greater<>();
  std::make_heap(targets.begin(), targets.end(), farther);
  while (!targets.empty()) {
    const std::uint32_t target = targets.front().second;
    if (lookout.sees(target)) return target;
    std::pop_heap(targets.begin(), targets.end(), farther);
    targets.pop_back();
  }
  return PathMap::kNothing;
}

// The best one in view, of those that the target sees and, where it is in view, the target itself.
std::uint32_t best_around(const Lookout& lookout, std::uint32_t target, bool is_in_view) {
  std::uint32_t best = is_in_view ? target : PathMap::kNothing;
  if (target == PathMap::kGoal) return best;
  double least = is_in_view ? lookout.length_by(target) : kInfinity;
  const auto look = [&](std::uint32_t other) {
    const double length = lookout.length_by(other);
    if (length < least && lookout.sees(other)) best = other, least = length;
  };
  for (const CornerGraph::Edge& edge : lookout.graph.edges_of(target)) look(edge.to);
  look(PathMap::kGoal);
  return best;
}

// Whether there is a way from the target on; targets of other graphs may be asked for.
bool is_known(const PathMap& map, std::uint32_t target) {
  if (target == PathMap::kGoal) return map.is_free;
  return target < map.next.size() && map.next[target] != PathMap::kNothing;
}

// Whether what follows the target is in view, from near the target as closely as may be.
bool sees_next(const Lookout& lookout, std::uint32_t target) {
  Lookout closely = lookout;
  const double left = norm(lookout.graph.points[target] - lookout.p);
  if (left < kPassed * lookout.radius) closely.room = lookout.radius;
  return closely.sees(lookout.map.next[target]);
}

std::uint32_t target_from(const Lookout& lookout, std::uint32_t target, bool looks_around) {
  if (!is_known(lookout.map, target)) return nearest_in_view(lookout);
  if (target != PathMap::kGoal && sees_next(lookout, target)) return lookout.map.next[target];
  const bool is_in_view = lookout.sees(target);
  if (is_in_view && !looks_around) return target;
  const std::uint32_t best = best_around(lookout, target, is_in_view);
  return best == PathMap::kNothing ? nearest_in_view(lookout) : best;
}

}  // namespace

PathMap path_map(const CornerGraph& graph, Vec2 goal) {
  const std::size_t count = graph.points.size();
  PathMap map{goal, 0.0, false, {}, {}, {}};
  map.length.assign(count, kInfinity), map.top.assign(count, kInfinity);
  map.next.assign(count, PathMap::kNothing);
  const double clearance = graph.grid.clearance(goal);
  map.is_free = clearance >= graph.radius;
  if (!map.is_free) return map;
  map.room = std::min(clearance, graph.radius + kSpareRoom) - kRounding * graph.radius;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t corner, double length, std::uint32_t next) {
    if (!(length < map.length[corner])) return;
    map.length[corner] = length, map.next[corner] = next;
    open.push({length, corner});
  };
  for (std::uint32_t k = 0; k < count; ++k) {
    if (graph.grid.is_clear(goal, graph.points[k], std::min(map.room, graph.room[k])))
      reach(k, norm(goal - graph.points[k]), PathMap::kGoal);
  }
  while (!open.empty()) {
    const auto [length, corner] = open.top();
    open.pop();
    if (length > map.length[corner]) continue;
    double turn = 0.0;  // the next one's is final: it is nearer to the goal
    map.top[corner] = top_before(graph, map, graph.points[corner], map.next[corner], turn);
    for (const CornerGraph::Edge& edge : graph.edges_of(corner)) {
      reach(edge.to, length + edge.length, corner);
    }
  }
  return map;
}

Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch) {
  // half of what corners keep, so that a robot slightly off its way still sees them
  const double room = std::clamp(graph.grid.clearance(p) - kRounding * radius,
                                 (1.0 - 2.0 * kRounding) * radius, graph.radius + 0.5 * kSpareRoom);
  const Lookout lookout{graph, map, p, radius, room, scratch};
  Leg leg{p, target_from(lookout, target, looks_around)};
  if (leg.target == PathMap::kNothing) return leg;
  leg.aim = point_of(graph, map, leg.target);
  leg.length = lookout.length_by(leg.target);
  leg.top = top_before(graph, map, p, leg.target, leg.turn);
  return leg;
}

double speed_limit(const Leg& leg, double max_acceleration) {
  return std::sqrt(leg.top * max_acceleration);
}

}  // namespace avo
