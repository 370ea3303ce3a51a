// SPDX-License-Identifier: Apache-2.0
// The robots' routes around walls: where each robot goes next, as a goal and a speed. Only the wish
// depends on it, never safety.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "avo/wall.h"
#include "guidance/travel.h"
#include "navigation/carried_graph.h"
#include "navigation/corner_graph.h"
#include "navigation/leg.h"
#include "navigation/passages.h"
#include "navigation/reachable_places.h"

namespace avo::inline guidance {

/// m: the radius rounded up, by 5 % at most, to two digits (from 1 to 2, to halves of the second
/// one). Fleets with many different radii share graphs by this; most radii that people write stay.
double radius_class(double radius);

/// What robots heed of walls.
struct RouteRules {
  bool routes = true;    // they follow routes around walls
  bool passages = true;  // with routes: they keep the rules at passages
};

/// What robots know of the walls, and of movers at rest; routes lead around movers where possible.
/// Without walls and movers at rest there are no routes.
class Routes {
 public:
  /// resting: discs. Earlier routes among mostly the same walls save time; they must stay alive
  /// while new routes are planned.
  Routes(RouteRules rules, std::span<const Wall> walls, std::vector<Wall> resting,
         const Routes* before = nullptr);

  [[nodiscard]] bool empty() const { return !sight_ && !goes_around_movers(); }
  [[nodiscard]] const std::vector<Wall>& resting() const { return resting_; }
  [[nodiscard]] bool goes_around_movers() const { return rules_.routes && !resting_.empty(); }
  void forget_before() { before_ = nullptr, carried_.clear(); }
  /// Keeps the passages of other walls, from which those of these walls are found sooner.
  void remember_passages(Routes& before) noexcept {
    earlier_ = std::move(before.passage_radii_.empty() ? before.earlier_ : before.passages);
  }
  /// Plans a new route; robots of one radius class and one goal share its data. A route that ended
  /// elsewhere than at that goal before still ends there, if nothing nearer can be reached.
  [[nodiscard]] Travel plan(double radius, Vec2 position, Vec2 goal, double arrival_distance,
                            const Travel* before = nullptr);
  /// The same route as before among other walls, where a new one would surely be the same.
  [[nodiscard]] std::optional<Travel> carry_over(const Travel& before, Vec2 position,
                                                 double radius);
  /// A route to that end with a known target. The flags say whether its graph is that of the exact
  /// radius, and around movers at rest.
  [[nodiscard]] Travel resume(double radius, Vec2 end, std::uint32_t target, bool is_exact,
                              bool around_movers);
  /// Returns whether a disc of that radius may be there. There must be walls.
  [[nodiscard]] bool is_free(double radius, Vec2 p) { return places_of(radius).is_free(p); }
  /// The largest number of targets that a robot may have to choose from.
  [[nodiscard]] std::size_t most_targets() const;
  /// Memory for planning.
  [[nodiscard]] LegScratch& scratch() { return scratch_; }
  /// Returns whether no wall lies on the straight line between them.
  [[nodiscard]] bool is_in_sight(Vec2 p, Vec2 q) const;
  /// The same. behind: a wall that may hide q, from a query nearby; it becomes the wall that does.
  [[nodiscard]] bool is_in_sight(Vec2 p, Vec2 q, const Wall*& behind) const;

  /// Finds the passages for robots of these radii, ascending, unless they are known.
  void find_passages(std::vector<double> radii);

  Passages passages;  // empty where robots do not heed passages

 private:
  using GraphKey = std::pair<bool, double>;              // around movers, radius
  using Key = std::tuple<bool, double, double, double>;  // and the goal
  const CornerGraph& graph_of(GraphKey key);
  ReachablePlaces& places_of(double radius);
  std::shared_ptr<const PathMap> map_to(GraphKey key, Vec2 end, bool is_whole = false);
  Travel lead(double radius, Vec2 position, Vec2 end, bool is_exact, bool around_movers);
  Travel lead(double radius, Vec2 position, Vec2 end);
  Vec2 reachable_end(double radius, Vec2 position, Vec2 goal, const Travel* before);

  RouteRules rules_;
  const Routes* before_ = nullptr;  // until forget_before()
  std::optional<ClearanceGrid> sight_;
  std::vector<Wall> resting_;
  std::map<GraphKey, std::unique_ptr<const CornerGraph>> graphs_;
  std::map<GraphKey, std::optional<CarriedGraph>> carried_;  // until forget_before()
  std::map<double, std::unique_ptr<ReachablePlaces>> places_;
  struct AskedGoal {
    std::weak_ptr<const PathMap> map;  // the whole map, if there is one
    std::uint32_t asked = 0;           // number of requests, before there was one
  };
  std::map<Key, AskedGoal> maps_;
  // of all whole maps that exist, where corners are many
  std::shared_ptr<std::size_t> kept_corners_ = std::make_shared<std::size_t>(0);
  LegScratch scratch_;
  std::size_t most_maps_ = 0;  // beyond this number, unused maps are forgotten
  std::vector<double> passage_radii_;
  Passages earlier_;  // until find_passages()
};

/// Plans the robot's route. before: its route among other walls, if any. The robot keeps its target
/// if it would set out as before, and has as far to go from there.
Travel plan_anew(Routes& routes, double radius, Vec2 position, Vec2 goal, double arrival_distance,
                 const Travel* before);

}  // namespace avo::inline guidance
