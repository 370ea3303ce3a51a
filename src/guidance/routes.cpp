// SPDX-License-Identifier: Apache-2.0
#include "guidance/routes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/plane.h"
#include "navigation/right_of_way.h"

namespace avo::inline guidance {
namespace {

constexpr double kSightReach = 0.1;  // m
constexpr double kJoint = 1e-9;      // m: lines of sight do not pass where pieces of walls touch
// Where corners are many, a robot searches for its own route at first. A whole map is made once
// robots have asked often for its goal. This holds while all whole maps together have no more
// corners than that.
constexpr std::uint32_t kAskedOften = 4;
constexpr std::size_t kMostKeptCorners = 4'000'000;

// s: where walls have changed there may be another route where there was none.
double look_again_at(const Waiting& waiting) {
  const bool has_decided = waiting.least < kInfinity, sees_none = waiting.looks_at == kInfinity;
  return has_decided && sees_none ? waiting.waited : waiting.looks_at;
}

// A robot that waits does so among other walls as well, and goes around the same gaps where a route
// leads there.
void keep_waiting_on(const Travel& before, Vec2 position, double radius, Travel& fresh,
                     LegScratch& scratch) {
  if (!fresh.is_known() || !before.is_known() || !(fresh.map->goal == before.map->goal)) return;
  if (!before.waiting.closed.empty()) {
    Travel other = around(fresh, position, radius, before.waiting.closed, scratch);
    if (other.is_known()) fresh = std::move(other);
  }
  const Waiting& known = before.waiting;
  fresh.waiting.least = known.least, fresh.waiting.waited = known.waited;
  fresh.waiting.opens_at = known.opens_at;
  fresh.waiting.looks_at = look_again_at(known);
}

// The route where it continues, among the routes that are planned anew because walls have changed.
Travel replanned(const Travel& before, Travel fresh, Vec2 position, double radius,
                 LegScratch& scratch) {
  const auto kept = rest_of(before);
  if (!kept || !rest_of(fresh)) return fresh;
  const std::uint32_t target =
      before.target == PathMap::kGoal ? PathMap::kGoal : point_at(*fresh.graph, kept->first);
  if (target == fresh.target) return fresh;  // without another search
  Travel first = before;
  aim_at_best(first, position, radius, scratch);
  if (rest_of(first) != rest_of(fresh)) return fresh;
  Travel travel = fresh;
  aim_at(travel, target, scratch);
  return rest_of(travel) == kept ? travel : fresh;
}

}  // namespace

double radius_class(double radius) {
  constexpr double kLargestPower = 1e22;  // of ten that a double holds
  constexpr double kRounding = 1e-14;
  double scale = 1.0;
  while (radius * scale < 10.0 && scale < kLargestPower) scale *= 10.0;
  const double digits = radius * scale, per_digit = digits < 20.0 ? 2.0 : 1.0;
  if (!(digits >= 10.0 && digits < 100.0)) return radius;
  double rounded = std::ceil(digits * per_digit * (1.0 - kRounding));
  if (rounded / (per_digit * scale) < radius) rounded += 1.0;
  return rounded / (per_digit * scale);
}

Routes::Routes(RouteRules rules, std::span<const Wall> walls, std::vector<Wall> resting,
               const Routes* before)
    : rules_(rules), before_(before), resting_(std::move(resting)) {
  if (!walls.empty()) sight_.emplace(walls, kSightReach);
}

const CornerGraph& Routes::graph_of(GraphKey key) {
  const auto known = graphs_.find(key);
  if (known != graphs_.end()) return *known->second;
  const CornerGraph* before = nullptr;
  if (before_ != nullptr) {
    const auto place = before_->graphs_.find(key);
    if (place != before_->graphs_.end()) before = place->second.get();
  }
  const auto [around_movers, radius] = key;
  std::vector<Wall> walls;
  if (sight_) walls.assign(sight_->walls().begin(), sight_->walls().end());
  if (around_movers) walls.insert(walls.end(), resting_.begin(), resting_.end());
  auto graph = std::make_unique<const CornerGraph>(
      before != nullptr ? corner_graph(walls, radius, *before, carried_[key])
                        : corner_graph(walls, radius));
  return *graphs_.emplace(key, std::move(graph)).first->second;
}

ReachablePlaces& Routes::places_of(double radius) {
  const auto known = places_.find(radius);
  if (known != places_.end()) return *known->second;
  auto places = std::make_unique<ReachablePlaces>(sight_->walls(), radius);
  return *places_.emplace(radius, std::move(places)).first->second;
}

// The whole map, or the goal alone for a robot that searches for its own route.
std::shared_ptr<const PathMap> Routes::map_to(GraphKey key, Vec2 end, bool is_whole) {
  const CornerGraph& graph = graph_of(key);
  AskedGoal& goal = maps_[{key.first, key.second, end.x, end.y}];
  std::shared_ptr<const PathMap> map = goal.map.lock();
  if (map) return map;
  const std::size_t corners = graph.corners();
  const bool are_kept = *kept_corners_ + corners <= kMostKeptCorners;
  if (is_whole || !is_searched(graph) || (are_kept && goal.asked++ >= kAskedOften)) {
    auto whole = std::make_unique<const PathMap>(path_map(graph, end));
    const auto forget = [kept = kept_corners_, corners](const PathMap* old) {
      *kept -= corners;
      delete old;
    };
    // if there is no memory for the next line, `forget` subtracts them again
    *kept_corners_ += corners;
    map = std::shared_ptr<const PathMap>(whole.release(), forget);
    goal.map = map;
  } else {
    map = std::make_shared<const PathMap>(goal_of(graph, end));
  }
  if (maps_.size() > most_maps_) {
    std::erase_if(maps_, [](const auto& entry) { return entry.second.map.expired(); });
    most_maps_ = 2 * maps_.size() + kAskedOften;
  }
  return map;
}

Travel Routes::lead(double radius, Vec2 position, Vec2 end, bool is_exact, bool around_movers) {
  Travel travel = resume(radius, end, PathMap::kNothing, is_exact, around_movers);
  if (travel.graph != nullptr) aim_at_best(travel, position, radius, scratch_);
  return travel;
}

// A route around movers at rest where possible, and otherwise around the walls alone.
Travel Routes::lead(double radius, Vec2 position, Vec2 end) {
  for (const bool is_exact : {false, true}) {
    if (!goes_around_movers() || (is_exact && radius_class(radius) == radius)) break;
    Travel travel = lead(radius, position, end, is_exact, true);
    if (travel.target != PathMap::kNothing) return travel;
  }
  return sight_ ? lead(radius, position, end, false, false) : Travel{};
}

// The goal, or the nearest place to it; the robot's own place where it can reach nothing.
Vec2 Routes::reachable_end(double radius, Vec2 position, Vec2 goal, const Travel* before) {
  ReachablePlaces& places = places_of(radius);
  const Vec2 nearest = places.nearest_reached(position, goal);
  if (nearest == goal || before == nullptr || before->ends == RouteEnd::goal) return nearest;
  const Vec2 kept = before->place;
  const bool is_as_near = norm(kept - goal) <= norm(nearest - goal) + kLengthRounding * radius;
  const bool is_there = places.is_free(kept) && places.are_connected(position, kept);
  return is_as_near && is_there ? kept : nearest;
}

Travel Routes::plan(double radius, Vec2 position, Vec2 goal, double arrival_distance,
                    const Travel* before) {
  const Travel straight = lead(radius, position, goal);
  if (!sight_ || straight.target != PathMap::kNothing) return straight;
  const Vec2 end = reachable_end(radius, position, goal, before);
  const bool is_there = end == goal;
  Travel travel = is_there ? straight : lead(radius, position, end);
  if (rules_.routes && travel.target == PathMap::kNothing && radius_class(radius) != radius)
    travel = lead(radius, position, end, true, false);
  if (is_there) return travel;
  const bool is_near = norm(end - goal) <= arrival_distance + kBesideSlack * radius;
  travel.ends = is_near ? RouteEnd::beside : RouteEnd::short_of;
  travel.place = end;
  return travel;
}

Travel Routes::resume(double radius, Vec2 end, std::uint32_t target, bool is_exact,
                      bool around_movers) {
  Travel travel;
  travel.target = target;
  if (!rules_.routes || !(sight_ || around_movers)) return travel;
  const GraphKey key{around_movers, is_exact ? radius : radius_class(radius)};
  travel.graph = &graph_of(key);
  travel.map = map_to(key, end);
  travel.around_movers = around_movers;
  if (target < PathMap::kNothing) aim_at(travel, target, scratch_);
  return travel;
}

// Keeps the route where all changes lie apart from all routes of the same length: all facts about
// the old route still hold.
std::optional<Travel> Routes::carry_over(const Travel& before, Vec2 position, double radius) {
  if (!before.is_known() || before.ends != RouteEnd::goal || before.around_movers ||
      goes_around_movers() || !before.waiting.closed.empty() ||
      before.graph->radius != radius_class(radius))  // a graph that a new route tries last
    return std::nullopt;
  const GraphKey key{false, before.graph->radius};
  if (before_ != nullptr) {  // nothing is known of the changes since another graph
    const auto known = before_->graphs_.find(key);
    if (known == before_->graphs_.end() || known->second.get() != before.graph) return std::nullopt;
  }
  const CornerGraph& graph = graph_of(key);
  const std::optional<CarriedGraph>& carried = carried_[key];
  const auto rest = rest_of(before);
  if (!carried || !rest) return std::nullopt;
  const PathMap& map = *before.map;
  const double room = (1.0 - 2.0 * kLengthRounding) * std::min(radius, map.room);
  const double length = norm(rest->first - position) + rest->second;
  if (!before.graph->grid.is_clear(position, rest->first, room)) return std::nullopt;
  const std::vector<Zone> changed = zones_for(*carried, graph, map, length);
  if (may_meet(changed, position, map.goal, length * (1.0 + kRouteRounding))) return std::nullopt;
  Travel travel = before;
  travel.graph = &graph;
  travel.waiting.looks_at = look_again_at(before.waiting);
  if (before.target != PathMap::kGoal) travel.target = carried->number[before.target];
  if (map.is_whole) {
    travel.map = map_to(key, map.goal, true);
  } else {
    travel.map = std::make_shared<const PathMap>(
        carried_map(map, before.target, *before.graph, *carried, changed));
  }
  return travel;
}

std::size_t Routes::most_targets() const {
  std::size_t most = 0;
  for (const auto& [key, graph] : graphs_) {
    if (graph->lattice.empty()) most = std::max(most, graph->corners() + 1);
  }
  return most;
}

void Routes::find_passages(std::vector<double> radii) {
  if (!sight_ || !rules_.routes || !rules_.passages || radii == passage_radii_) return;
  passages = Passages(sight_->walls(), radii, kClaimRange, std::exchange(earlier_, {}));
  passage_radii_ = std::move(radii);
}

bool Routes::is_in_sight(Vec2 p, Vec2 q) const {
  return !sight_ || sight_->is_clear(p, q, kJoint);
}

bool Routes::is_in_sight(Vec2 p, Vec2 q, const Wall*& behind) const {
  if (!sight_) return true;
  if (behind == nullptr || !blocks(*behind, p, q, kJoint)) behind = sight_->blocker(p, q, kJoint);
  return behind == nullptr;
}

Travel plan_anew(Routes& routes, double radius, Vec2 position, Vec2 goal, double arrival_distance,
                 const Travel* before) {
  if (before != nullptr) {
    std::optional<Travel> carried = routes.carry_over(*before, position, radius);
    if (carried) return std::move(*carried);
  }
  Travel travel = routes.plan(radius, position, goal, arrival_distance, before);
  if (before == nullptr) return travel;
  keep_waiting_on(*before, position, radius, travel, routes.scratch());
  return replanned(*before, std::move(travel), position, radius, routes.scratch());
}

}  // namespace avo::inline guidance
