// SPDX-License-Identifier: Apache-2.0
// The robots' ways around walls: where each goes next, as a goal and a speed. Only the wish depends
// on it, never safety.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "navigation/corner_graph.h"
#include "navigation/free_space.h"
#include "navigation/leg.h"
#include "navigation/passages.h"
#include "sim/fleet.h"

namespace avo {

/// One robot's way. The target is the part that steps change: a corner of the graph, the goal,
/// nothing yet, or kUnreachable.
struct Travel {
  static constexpr std::uint32_t kUnreachable = 0xfffffffd;
  const CornerGraph* graph = nullptr;  // none: it heads straight for its goal
  std::shared_ptr<const PathMap> map = {};
  std::uint32_t target = PathMap::kNothing;
  bool around_movers = false;  // the graph is of walls and of movers at rest

  /// Whether it has a way to its goal.
  [[nodiscard]] bool is_known() const {
    return graph != nullptr && target != kUnreachable && target != PathMap::kNothing;
  }
};

/// Where a robot heads for: a place as far off as its goal is by way, and how fast at most.
struct Heading {
  Vec2 goal = {};                // m
  double preferred_speed = 0.0;  // m/s
};

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
  void forget_before() { before_ = nullptr; }
  /// A new way; robots of one class of radii and one goal share what it is made of.
  [[nodiscard]] Travel plan(double radius, Vec2 position, Vec2 goal);
  /// A way on which the target is known, and whether its graph is that of the very radius, and
  /// around movers at rest.
  [[nodiscard]] Travel resume(double radius, Vec2 goal, std::uint32_t target, bool is_exact,
                              bool around_movers);
  /// That a robot may have to choose from.
  [[nodiscard]] std::size_t most_targets() const;
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
  const FreeSpace& space_of(double radius);
  std::shared_ptr<const PathMap> map_to(GraphKey key, Vec2 goal);
  Travel plan_by_walls(double radius, Vec2 position, Vec2 goal);

  bool follows_ = false, heeds_passages_ = false;
  const Ways* before_ = nullptr;  // until forget_before()
  std::optional<ClearanceGrid> sight_;
  std::vector<Wall> resting_;
  std::map<GraphKey, std::unique_ptr<const CornerGraph>> graphs_;
  std::map<double, std::unique_ptr<const FreeSpace>> spaces_;
  std::map<Key, std::weak_ptr<const PathMap>> maps_;
  std::size_t most_maps_ = 0;  // beyond which those that nobody has are forgotten
  std::vector<double> passage_radii_;
};

/// What is left of it, m and its next point: by the target, unless that is unknown.
Simulation::Way rest_of_way(const Travel& travel, Vec2 position, Vec2 goal);

/// Updates the target. `looks_around` is asked for from time to time, see next_leg().
Heading follow(Travel& travel, Vec2 position, Vec2 goal, const RobotTraits& robot,
               bool looks_around, LegScratch& scratch);

/// The same of a robot of that radius whose goal a mover at rest stands on, if it heads for that:
/// it comes to rest beside the mover, on the side that it comes from.
Heading beside_resting(std::span<const Wall> resting, const Heading& heading, Vec2 position,
                       Vec2 goal, double radius);

/// Of a whole fleet.
void plan_travels(Ways& ways, const Fleet& fleet);

/// Of the same fleet among other walls. Who would set out as before, and has as far to go from its
/// target, keeps it.
void replan_travels(const Ways& before, Ways& ways, const Fleet& fleet);

/// Whether the robot looks around in this step: not all do at once.
bool looks_around(RobotId robot, std::int64_t steps);

}  // namespace avo
