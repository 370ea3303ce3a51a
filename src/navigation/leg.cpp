// SPDX-License-Identifier: Apache-2.0
#include "navigation/leg.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/plane.h"

namespace avo {
namespace {

constexpr double kPassed = 0.3;     // of the radius: so near a corner counts as passed
constexpr std::int64_t kRings = 3;  // of cells around a robot that are looked at

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
    return length_from(graph, map, target) + norm(graph.points[target] - p);
  }
  // The same, which asks for no more room than the robot takes.
  Lookout closely() const {
    Lookout closest = *this;
    closest.room = std::min(room, (1.0 - 2.0 * kLengthRounding) * radius);
    return closest;
  }
  bool sees(std::uint32_t target) const {
    const double there = target == PathMap::kGoal ? map.room : graph.room[target];
    const Vec2 place = point_of(graph, map, target);
    return map.is_open(p, place) && graph.grid.is_clear(p, place, std::min(room, there));
  }
  // Then nothing is nearer by way, but for rounding.
  bool sees_goal() const { return map.is_free && sees(PathMap::kGoal); }
};

// The target in view with the shortest way, of all.
std::uint32_t best_of_all(const Lookout& lookout) {
  const PathMap& map = lookout.map;
  std::vector<std::pair<double, std::uint32_t>>& targets = lookout.scratch.targets;
  targets.clear();
  targets.reserve(map.length.size());
  for (std::uint32_t k = 0; k < map.length.size(); ++k) {
    if (map.length[k] < kInfinity) targets.push_back({lookout.length_by(k), k});
  }
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

// The shortest way by one of several targets.
struct Choice {
  const Lookout& lookout;
  std::uint32_t best = PathMap::kNothing;
  double least = kInfinity;

  void look(std::uint32_t target) {
    const double length = lookout.length_by(target);
    if (length < least && lookout.sees(target)) best = target, least = length;
  }
  // By the points of a cell: what its sample aims at, its corners, and else the sample.
  void look_from(std::size_t cell) {
    const CornerGraph& graph = lookout.graph;
    const auto sample = static_cast<std::uint32_t>(graph.corners() + cell);
    const std::uint32_t next = lookout.map.next[sample];
    if (next != PathMap::kNothing) look(next);
    for (const std::uint32_t corner : graph.lattice.corners_in(cell)) look(corner);
    if (next != PathMap::kNothing && best == PathMap::kNothing) look(sample);
  }
  void look_around(std::int64_t away) {
    const Lattice& lattice = lookout.graph.lattice;
    lattice.for_each_around(lattice.place_of(lookout.p), away,
                            [&](std::size_t cell) { look_from(cell); });
  }
};

std::uint32_t best_in_view(const Lookout& lookout) {
  if (lookout.sees_goal()) return PathMap::kGoal;
  if (lookout.graph.lattice.empty()) return best_of_all(lookout);
  Choice choice{lookout};
  const Lattice& lattice = lookout.graph.lattice;
  if (!lattice.covers(lookout.p)) {
    for (const std::uint32_t target : lookout.map.from_outside) choice.look(target);
  }
  for (std::int64_t away = 0; away <= kRings; ++away) {
    if (away <= 1 || choice.best == PathMap::kNothing) choice.look_around(away);
  }
  return choice.best;
}

// The best one in view of those around the target, or around the robot, and, where it is in view,
// the target itself.
std::uint32_t best_around(const Lookout& lookout, std::uint32_t target, bool is_in_view) {
  Choice choice{lookout};
  if (is_in_view) choice.best = target, choice.least = lookout.length_by(target);
  if (target == PathMap::kGoal) return choice.best;
  if (lookout.sees_goal()) return PathMap::kGoal;
  if (lookout.graph.lattice.empty()) {
    for (const CornerGraph::Edge& edge : lookout.graph.edges_of(target)) choice.look(edge.to);
  } else {
    for (const std::int64_t away : {0, 1}) choice.look_around(away);
  }
  return choice.best;
}

// Whether there is a way from the target on; targets of other graphs may be asked for.
bool is_known(const PathMap& map, std::uint32_t target) {
  if (target == PathMap::kGoal) return map.is_free;
  return target < map.next.size() && map.next[target] != PathMap::kNothing;
}

// Whether what follows the target is in view, from near the target as closely as may be.
bool sees_next(const Lookout& lookout, std::uint32_t target) {
  const double left = norm(lookout.graph.points[target] - lookout.p);
  const std::uint32_t next = lookout.map.next[target];
  return left < kPassed * lookout.radius ? lookout.closely().sees(next) : lookout.sees(next);
}

std::uint32_t target_from(const Lookout& lookout, std::uint32_t target, bool looks_around) {
  if (!is_known(lookout.map, target)) return best_in_view(lookout);
  if (target != PathMap::kGoal && sees_next(lookout, target)) return lookout.map.next[target];
  // who has set out keeps on where there is less room on the way than here
  const bool is_in_view = lookout.closely().sees(target);
  if (is_in_view && !looks_around) return target;
  const std::uint32_t best = best_around(lookout, target, is_in_view);
  return best == PathMap::kNothing ? best_in_view(lookout) : best;
}

}  // namespace

Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch) {
  // half of what corners keep, so that a robot slightly off its way still sees them; one that is
  // in a wall sees what is on its own side of it
  const double room = std::clamp(graph.grid.clearance(p) - kLengthRounding * radius,
                                 kLengthRounding * radius, graph.radius + 0.5 * kSpareRoom);
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
