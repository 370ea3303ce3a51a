// SPDX-License-Identifier: Apache-2.0
// The robots' ways around walls: where each goes next, as a goal and a speed. Only the wish depends
// on it, never safety.
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

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "navigation/carried_graph.h"
#include "navigation/corner_graph.h"
#include "navigation/leg.h"
#include "navigation/passages.h"
#include "navigation/reachable_places.h"
#include "sim/fleet.h"
#include "sim/travel.h"

namespace avo::inline sim {

/// m: the radius rounded up, by 5 % at most, to two digits (from 1 to 2, to halves of the second
/// one). Fleets in which all radii differ share graphs so; most radii that people write stay.
double radius_class(double radius);

/// What robots know of the walls, and of movers at rest, which ways lead around where that can be
/// done. Without any of them there are no ways.
class Ways {
 public:
  /// resting: discs. Ways among mostly the same walls save time; they have to stay while new ways
  /// are planned.
  Ways(const Scenario& settings, std::span<const Wall> walls, std::vector<Wall> resting,
       const Ways* before = nullptr);

  [[nodiscard]] bool empty() const { return !sight_ && !goes_around_movers(); }
  [[nodiscard]] const std::vector<Wall>& resting() const { return resting_; }
  [[nodiscard]] bool goes_around_movers() const { return follows_ && !resting_.empty(); }
  void forget_before() { before_ = nullptr, carried_.clear(); }
  /// Passages of other walls, from which those of these walls are found sooner.
  void remember_passages(Ways& before) noexcept {
    earlier_ = std::move(before.passage_radii_.empty() ? before.earlier_ : before.passages);
  }
  /// A new way; robots of one class of radii and one goal share what it is made of. One that ended
  /// elsewhere than at that goal before still ends there, if nothing nearer can be reached.
  [[nodiscard]] Travel plan(double radius, Vec2 position, Vec2 goal,
                            const Travel* before = nullptr);
  /// The same way as before among other walls, where it is sure that a new one would be the same.
  [[nodiscard]] std::optional<Travel> carry_over(const Travel& before, Vec2 position,
                                                 double radius);
  /// A way to that end on which the target is known, and whether its graph is that of the very
  /// radius, and around movers at rest.
  [[nodiscard]] Travel resume(double radius, Vec2 end, std::uint32_t target, bool is_exact,
                              bool around_movers);
  /// Whether a disc of that radius may be there. There are walls.
  [[nodiscard]] bool is_free(double radius, Vec2 p) { return places_of(radius).is_free(p); }
  /// That a robot may have to choose from.
  [[nodiscard]] std::size_t most_targets() const;
  /// Memory to plan with.
  [[nodiscard]] LegScratch& scratch() { return scratch_; }
  /// Whether no wall lies on the straight way between them.
  [[nodiscard]] bool is_in_sight(Vec2 p, Vec2 q) const;

  /// Finds the passages for robots of these radii, ascending, unless they are known.
  void find_passages(std::vector<double> radii);

  std::vector<Travel> travels;  // by rank; none without walls
  Passages passages;            // none where nobody heeds them

 private:
  using GraphKey = std::pair<bool, double>;              // around movers, radius
  using Key = std::tuple<bool, double, double, double>;  // and the goal
  const CornerGraph& graph_of(GraphKey key);
  ReachablePlaces& places_of(double radius);
  std::shared_ptr<const PathMap> map_to(GraphKey key, Vec2 end, bool is_whole = false);
  Travel lead(double radius, Vec2 position, Vec2 end, bool is_exact, bool around_movers);
  Travel lead(double radius, Vec2 position, Vec2 end);
  Vec2 reachable_end(double radius, Vec2 position, Vec2 goal, const Travel* before);

  bool follows_ = false, heeds_passages_ = false;
  double arrival_distance_ = 0.0;  // m
  const Ways* before_ = nullptr;   // until forget_before()
  std::optional<ClearanceGrid> sight_;
  std::vector<Wall> resting_;
  std::map<GraphKey, std::unique_ptr<const CornerGraph>> graphs_;
  std::map<GraphKey, std::optional<CarriedGraph>> carried_;  // until forget_before()
  std::map<double, std::unique_ptr<ReachablePlaces>> places_;
  struct Goal {
    std::weak_ptr<const PathMap> map;  // the whole one, if there is one
    std::uint32_t asked = 0;           // times, before there was one
  };
  std::map<Key, Goal> maps_;
  // of all whole maps that there are, where corners are many
  std::shared_ptr<std::size_t> kept_corners_ = std::make_shared<std::size_t>(0);
  LegScratch scratch_;
  std::size_t most_maps_ = 0;  // beyond which those that nobody has are forgotten
  std::vector<double> passage_radii_;
  Passages earlier_;  // until find_passages()
};

/// Of a whole fleet; of the same one as before among other walls: who would set out as before, and
/// has as far to go from its target, keeps it.
void plan_travels(Ways& ways, const Fleet& fleet, const Ways* before = nullptr);

}  // namespace avo::inline sim
