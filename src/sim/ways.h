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
#include "navigation/corner_graph.h"
#include "navigation/free_space.h"
#include "navigation/passages.h"
#include "navigation/path_map.h"
#include "sim/fleet.h"

namespace avo {

/// One robot's way. The target is the part that steps change: a corner of the graph, the goal,
/// nothing yet, or kUnreachable.
struct Travel {
  static constexpr std::uint32_t kUnreachable = 0xfffffffd;
  const CornerGraph* graph = nullptr;  // none: it heads straight for its goal
  std::shared_ptr<const PathMap> map = {};
  std::uint32_t target = PathMap::kNothing;

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

/// What robots know of the walls. Without walls there are no ways.
class Ways {
 public:
  Ways(const Scenario& settings, std::span<const Wall> walls);

  [[nodiscard]] bool empty() const { return !sight_; }
  /// A new way; robots of one radius and one goal share what it is made of.
  [[nodiscard]] Travel plan(double radius, Vec2 position, Vec2 goal);
  /// A way on which the target is known.
  [[nodiscard]] Travel resume(double radius, Vec2 goal, std::uint32_t target);
  /// That a robot may have to choose from.
  [[nodiscard]] std::size_t most_targets() const;
  /// Whether no wall lies on the straight way between them.
  [[nodiscard]] bool is_in_sight(Vec2 p, Vec2 q) const;

  /// Finds the passages for robots of these radii, ascending, unless they are known.
  void find_passages(std::vector<double> radii);

  std::vector<Travel> travels;  // by rank; none without walls
  Passages passages;            // none where nobody heeds them

 private:
  struct Radius {
    CornerGraph graph;
    FreeSpace space;
  };
  using Key = std::tuple<double, double, double>;  // radius, goal
  const Radius& of_radius(double radius);
  std::shared_ptr<const PathMap> map_to(const Radius& radius, Vec2 goal);

  bool follows_ = false, heeds_passages_ = false;
  std::vector<Wall> walls_;
  std::optional<ClearanceGrid> sight_;
  std::map<double, std::unique_ptr<const Radius>> radii_;
  std::map<Key, std::weak_ptr<const PathMap>> maps_;
  std::vector<double> passage_radii_;
};

/// Updates the target. `looks_around` is asked for from time to time, see next_leg().
Heading follow(Travel& travel, Vec2 position, Vec2 goal, const RobotTraits& robot,
               bool looks_around, LegScratch& scratch);

/// Of a whole fleet.
void plan_travels(Ways& ways, const Fleet& fleet);

/// Of the same fleet among other walls. Who would set out as before, and has as far to go from its
/// target, keeps it.
void replan_travels(const Ways& before, Ways& ways, const Fleet& fleet);

/// Whether the robot looks around in this step: not all do at once.
bool looks_around(RobotId robot, std::int64_t steps);

}  // namespace avo
