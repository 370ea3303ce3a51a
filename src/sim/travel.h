// SPDX-License-Identifier: Apache-2.0
// One robot's way: what it aims at, what it makes of that in a step, and ways around gaps.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "navigation/corner_graph.h"
#include "navigation/leg.h"
#include "sim/fleet.h"

namespace avo::inline sim {

/// Of the radius: as much farther off than arrival_distance counts as there, of a goal that cannot
/// be reached, because the nearest place keeps a little more than the radius off walls.
inline constexpr double kBesideSlack = 1e-5;

/// Where a robot's way ends.
enum class WayEnd : std::uint8_t {
  goal,
  beside,    ///< the nearest place that it gets to, within arrival_distance: it has arrived then
  short_of,  ///< the nearest place that it gets to, farther off
};

/// What a robot remembers where passages are held (docs/arrival.md, rule 13).
struct Waiting {
  double least = std::numeric_limits<double>::infinity();  // m, that have been left of its way
  double waited = 0.0;                                     // s, since then
  // s, of waiting, after which it looks for another way
  double looks_at = std::numeric_limits<double>::infinity();
  std::vector<Segment> closed = {};          // gaps that it does not go through
  double opens_at = 0.0;                     // m, of its way left, before which they stay closed
  std::shared_ptr<const PathMap> open = {};  // the map without these; none where there are none
};

/// One robot's way. The target is the part that steps change: a corner of the graph, the end, or
/// nothing yet.
struct Travel {
  const CornerGraph* graph = nullptr;  // none: it heads straight for its end
  std::shared_ptr<const PathMap> map = {};
  std::uint32_t target = PathMap::kNothing;
  bool around_movers = false;  // the graph is of walls and of movers at rest
  WayEnd ends = WayEnd::goal;
  Vec2 place = {};  // m, where it ends, if not at the goal
  Waiting waiting = {};

  /// Whether it has a way to its end.
  [[nodiscard]] bool is_known() const { return graph != nullptr && target != PathMap::kNothing; }
  /// m, where it ends, of a robot with that goal.
  [[nodiscard]] Vec2 end(Vec2 goal) const { return ends == WayEnd::goal ? goal : place; }
  /// m, what such a robot heads for in the end: the goal itself without navigation.
  [[nodiscard]] Vec2 heads_for(Vec2 goal) const { return graph != nullptr ? end(goal) : goal; }
};

/// Where a robot heads for: a place as far off as its goal is by way, and how fast at most.
struct Heading {
  Vec2 goal = {};                // m
  double preferred_speed = 0.0;  // m/s
  Vec2 next = {};                // m, of its way: the goal itself, or a corner before it
  bool yields = false;           // to others at a passage
};

inline Heading straight_to(Vec2 end, const RobotTraits& robot) {
  return {.goal = end, .preferred_speed = robot.preferred_speed, .next = end};
}

/// Where the target is, and m, how far it is from there to the end; nothing where there is no
/// target.
std::optional<std::pair<Vec2, double>> rest_of(const Travel& travel);

/// Makes the one on the shortest way its target, of all in view.
void aim_at_best(Travel& travel, Vec2 position, double radius, LegScratch& scratch);

/// Whether a robot on that graph may search for its own way: there are many corners.
bool is_searched(const CornerGraph& graph);

/// A way to the same end that leads around those gaps, of a robot that begins to wait anew; its
/// target is unknown where there is none.
Travel around(const Travel& travel, Vec2 position, double radius, std::vector<Segment> closed,
              LegScratch& scratch);

/// The way that is open again, of one that leads around gaps.
Travel reopened(const Travel& travel, Vec2 position, double radius, LegScratch& scratch);

/// Makes that its target, and has its map tell of it.
void aim_at(Travel& travel, std::uint32_t target, LegScratch& scratch);

/// m, from there to its end by way of the target, which is known.
double length_of(const Travel& travel, Vec2 position);

/// What is left of it, of a robot with that goal: by the target, unless that is unknown.
Simulation::Way rest_of_way(const Travel& travel, Vec2 position, Vec2 goal);

/// Updates the target. end: of the way, or the goal where there are no walls. `looks_around` is
/// asked for from time to time, see next_leg(). A robot that finds its own way within `own_way` m
/// of the end heads for it there, unless the way around is much longer.
Heading follow(Travel& travel, Vec2 position, Vec2 end, const RobotTraits& robot, double own_way,
               bool looks_around, LegScratch& scratch);

/// The same of a robot of that radius on whose end a mover at rest stands, if it heads for that: it
/// comes to rest beside the mover, on the side that it comes from.
Heading beside_resting(std::span<const Wall> resting, const Heading& heading, Vec2 position,
                       Vec2 end, double radius);

/// Whether the robot looks around in this step: not all do at once.
bool looks_around(RobotId robot, std::int64_t steps);

}  // namespace avo::inline sim
