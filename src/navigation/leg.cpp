// SPDX-License-Identifier: Apache-2.0
#include "navigation/leg.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/plane.h"

namespace avo::inline navigation {
namespace {

constexpr double kPassed = 0.3;        // of the radius: a corner this near counts as passed
constexpr double kSearchMargin = 4.0;  // radii
constexpr std::int64_t kRings = 3;     // of cells around a robot that are examined

// The state of one robot's search for its next target.
struct Lookout {
  const CornerGraph& graph;
  std::shared_ptr<const PathMap>& known;
  Vec2 p;
  double radius;  // m
  double room;    // m, that its route keeps where it has it
  LegScratch& scratch;

  const PathMap& map() const { return *known; }
  // m, by which a search goes beyond the best route, so that a robot that is pushed aside need not
  // search again.
  double margin() const { return kSearchMargin * radius; }
  double length_by(std::uint32_t target) const {
    if (target == PathMap::kGoal) return map().is_free ? norm(map().goal - p) : kInfinity;
    return length_from(graph, map(), target) + norm(graph.points[target] - p);
  }
  // The same with no more room than the robot takes.
  Lookout closely() const {
    Lookout closest = *this;
    closest.room = std::min(room, (1.0 - 2.0 * kLengthRounding) * radius);
    return closest;
  }
  bool sees(std::uint32_t target) const {
    const double there = target == PathMap::kGoal ? map().room : graph.room[target];
    const Vec2 aim = point_of(graph, map(), target);
    return map().is_open(p, aim) && graph.grid.is_clear(p, aim, std::min(room, there));
  }
  // If true, no other route is shorter, up to rounding.
  bool sees_goal() const { return map().is_free && sees(PathMap::kGoal); }
};

// The target in view with the shortest route, among all targets.
std::uint32_t best_of_all(const Lookout& lookout) {
  const PathMap& map = lookout.map();
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

// The shortest route through one of several targets.
struct LegChoice {
  const Lookout& lookout;
  std::uint32_t best = PathMap::kNothing;
  double least = kInfinity;

  void look(std::uint32_t target) {
    const double length = lookout.length_by(target);
    if (length < least && lookout.sees(target)) best = target, least = length;
  }
  // Tries the points of a cell: the aim of its sample, its corners, and otherwise the sample.
  void look_from(std::size_t cell) {
    const CornerGraph& graph = lookout.graph;
    const auto sample = static_cast<std::uint32_t>(graph.corners() + cell);
    const std::uint32_t next = lookout.map().next[sample];
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

// The same by a search. The search settles targets in the order of their routes, so the first one
// in view is the best, up to rounding.
std::uint32_t best_by_search(const Lookout& lookout) {
  if (!lookout.map().is_free) return PathMap::kNothing;
  Horizons horizons(lookout.p, std::min(lookout.room, lookout.graph.radius));
  lookout.graph.view.look(lookout.p, horizons, [](std::uint32_t, Vec2) {});
  PathSearch search(lookout.graph, lookout.map(), lookout.p, lookout.scratch.search);
  std::pair<double, std::uint32_t> best{kInfinity, PathMap::kNothing};
  search.settle(kInfinity, [&](std::uint32_t corner, double length) {
    if (std::pair(length, corner) < best && !horizons.is_hidden(lookout.graph.points[corner]) &&
        lookout.sees(corner))
      best = {length, corner};
    return best.first + lookout.margin();
  });
  if (best.second != PathMap::kNothing)
    lookout.known = std::make_shared<const PathMap>(search.route_from(best.second));
  return best.second;
}

std::uint32_t best_in_view(const Lookout& lookout) {
  if (lookout.sees_goal()) return PathMap::kGoal;
  if (!lookout.map().is_whole) return best_by_search(lookout);
  if (lookout.graph.lattice.empty()) return best_of_all(lookout);
  LegChoice choice{lookout};
  const Lattice& lattice = lookout.graph.lattice;
  if (!lattice.covers(lookout.p)) {
    for (const std::uint32_t target : lookout.map().from_outside) choice.look(target);
  }
  for (std::int64_t away = 0; away <= kRings; ++away) {
    if (away <= 1 || choice.best == PathMap::kNothing) choice.look_around(away);
  }
  return choice.best;
}

// m, of the route from that corner on; none where it is not known.
std::optional<double> known_length(const PathMap& map, std::uint32_t corner) {
  const std::size_t place = map.place_of(corner);
  if (place < map.length.size()) return map.length[place];
  const PathMap::Known* known = map.around_at(corner);
  return known != nullptr ? std::optional(known->length) : std::nullopt;
}

// Returns whether an unknown corner is surely no better than the known ones. is_beside: an edge
// joins it to a corner with known neighbors.
bool is_surely_longer(const Lookout& lookout, std::uint32_t corner, bool is_beside, double least) {
  const PathMap& map = lookout.map();
  const Vec2 q = lookout.graph.points[corner];
  const double to_from = norm(q - map.from);
  const double settled = is_beside || to_from <= map.reach ? map.settled - to_from : 0.0;
  const double from_there = std::max(settled, norm(q - map.goal));
  return (from_there + norm(q - lookout.p)) * (1.0 - kRouteRounding) >= least;
}

// Tries the entries of a map of one route for everything that best_around() examines; false: the
// entries do not suffice.
bool look_beside(LegChoice& choice, std::uint32_t target) {
  const Lookout& lookout = choice.lookout;
  const std::vector<std::uint32_t>& beside = lookout.map().beside;
  const bool is_beside = std::find(beside.begin(), beside.end(), target) != beside.end();
  for (const CornerGraph::Edge& edge : lookout.graph.edges_of(target)) {
    const std::optional<double> known = known_length(lookout.map(), edge.to);
    if (!known && !is_surely_longer(lookout, edge.to, is_beside, choice.least) &&
        lookout.sees(edge.to))
      return false;
    const double length =
        known.value_or(kInfinity) + norm(lookout.graph.points[edge.to] - lookout.p);
    if (length < choice.least && lookout.sees(edge.to))
      choice.best = edge.to, choice.least = length;
  }
  return true;
}

// Makes the map one of the route from that corner on; false where it does not know all of it.
bool turn_to(const Lookout& lookout, std::uint32_t corner) {
  const PathMap& map = lookout.map();
  PathMap turned;
  turned.goal = map.goal, turned.room = map.room, turned.is_free = map.is_free;
  turned.is_whole = false;
  turned.around = map.around, turned.beside = map.beside;
  turned.from = map.from, turned.reach = map.reach;
  turned.settled = map.settled, turned.longest_edge = map.longest_edge;
  turned.closed = map.closed;
  const auto known = [&](std::uint32_t k) -> std::optional<PathMap::Known> {
    const std::size_t place = map.place_of(k);
    if (place < map.length.size()) return PathMap::Known{k, map.next[place], map.length[place]};
    const PathMap::Known* around = map.around_at(k);
    return around != nullptr ? std::optional(*around) : std::nullopt;
  };
  if (!add_route(lookout.graph, corner, known, turned)) return false;
  lookout.known = std::make_shared<const PathMap>(std::move(turned));
  return true;
}

// The best target around the present one, where a part of the map is known.
std::uint32_t best_beside(const Lookout& lookout, std::uint32_t target, bool is_in_view) {
  LegChoice choice{lookout};
  if (is_in_view) choice.best = target, choice.least = lookout.length_by(target);
  const std::uint32_t before = choice.best;
  const double least = choice.least;
  if (look_beside(choice, target) &&
      (choice.best == before || lookout.map().place_of(choice.best) < lookout.map().length.size() ||
       turn_to(lookout, choice.best)))
    return choice.best;
  choice.best = before, choice.least = least;
  PathSearch search(lookout.graph, lookout.map(), lookout.p, lookout.scratch.search);
  double limit = least;
  const std::span<const CornerGraph::Edge> around = lookout.graph.edges_of(target);
  search.settle(limit + lookout.margin(), [&](std::uint32_t corner, double length) {
    const auto edge = std::lower_bound(around.begin(), around.end(), corner,
                                       [](const auto& one, std::uint32_t k) { return one.to < k; });
    const bool is_around = edge != around.end() && edge->to == corner;
    if (length < limit && is_around && lookout.sees(corner)) limit = length;
    return limit + lookout.margin();
  });
  for (const CornerGraph::Edge& edge : around) {
    if (!search.is_settled(edge.to)) continue;
    const double length = search.length(edge.to) + norm(lookout.graph.points[edge.to] - lookout.p);
    if (length < choice.least && lookout.sees(edge.to))
      choice.best = edge.to, choice.least = length;
  }
  if (choice.best != PathMap::kNothing)
    lookout.known = std::make_shared<const PathMap>(search.route_from(choice.best));
  return choice.best;
}

// The best target in view of those around the present target, or around the robot. The present
// target counts where it is in view.
std::uint32_t best_around(const Lookout& lookout, std::uint32_t target, bool is_in_view) {
  LegChoice choice{lookout};
  if (is_in_view) choice.best = target, choice.least = lookout.length_by(target);
  if (target == PathMap::kGoal) return choice.best;
  if (lookout.sees_goal()) return PathMap::kGoal;
  if (!lookout.map().is_whole) return best_beside(lookout, target, is_in_view);
  if (lookout.graph.lattice.empty()) {
    for (const CornerGraph::Edge& edge : lookout.graph.edges_of(target)) choice.look(edge.to);
  } else {
    for (const std::int64_t away : {0, 1}) choice.look_around(away);
  }
  return choice.best;
}

// Returns whether there is a route from the target on; the target may be of another graph.
bool is_known(const PathMap& map, std::uint32_t target) {
  if (target == PathMap::kGoal) return map.is_free;
  return target < PathMap::kNothing && map.after(target) != PathMap::kNothing;
}

// Returns whether the point after the target is in view; near the target the least room suffices.
bool sees_next(const Lookout& lookout, std::uint32_t target) {
  const double left = norm(lookout.graph.points[target] - lookout.p);
  const std::uint32_t next = lookout.map().after(target);
  return left < kPassed * lookout.radius ? lookout.closely().sees(next) : lookout.sees(next);
}

std::uint32_t target_from(const Lookout& lookout, std::uint32_t target, bool looks_around) {
  if (!is_known(lookout.map(), target)) return best_in_view(lookout);
  if (target != PathMap::kGoal && sees_next(lookout, target)) return lookout.map().after(target);
  // a robot on its route continues where there is less room on the route than here
  const bool is_in_view = lookout.closely().sees(target);
  if (is_in_view && !looks_around) return target;
  const std::uint32_t best = best_around(lookout, target, is_in_view);
  return best == PathMap::kNothing ? best_in_view(lookout) : best;
}

}  // namespace

Leg next_leg(const CornerGraph& graph, std::shared_ptr<const PathMap>& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch) {
  // half of what corners keep, so that a robot slightly off its route still sees them. A robot in a
  // wall sees the places on its own side of the wall.
  const double room = std::clamp(graph.grid.clearance(p) - kLengthRounding * radius,
                                 kLengthRounding * radius, graph.radius + 0.5 * kSpareRoom);
  const Lookout lookout{graph, map, p, radius, room, scratch};
  Leg leg{p, target_from(lookout, target, looks_around)};
  if (leg.target == PathMap::kNothing) return leg;
  leg.aim = point_of(graph, *map, leg.target);
  leg.length = lookout.length_by(leg.target);
  leg.top = top_before(graph, *map, p, leg.target, leg.turn);
  return leg;
}

Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch) {
  std::shared_ptr<const PathMap> whole(std::shared_ptr<void>(), &map);
  return next_leg(graph, whole, p, radius, target, looks_around, scratch);
}

PathMap route_from(const CornerGraph& graph, const PathMap& goal, std::uint32_t corner,
                   PathScratch& scratch) {
  if (!goal.is_free || !graph.is_corner(corner)) return goal;
  PathSearch search(graph, goal, graph.points[corner], scratch);
  search.settle(kInfinity, [&](std::uint32_t found, double length) {
    return found == corner ? length : kInfinity;
  });
  return search.is_settled(corner) ? search.route_from(corner) : goal;
}

double speed_limit(const Leg& leg, double max_acceleration) {
  return std::sqrt(leg.top * max_acceleration);
}

}  // namespace avo::inline navigation
