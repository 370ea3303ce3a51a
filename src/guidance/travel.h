// SPDX-License-Identifier: Apache-2.0
// One robot's route: its target, its heading in a step, and routes around gaps.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/simulation.h"
#include "guidance/traits.h"
#include "navigation/corner_graph.h"
#include "navigation/leg.h"

namespace avo::inline guidance {

/// A part of the radius. At a goal that it cannot reach, a robot may be this much farther off than
/// arrival_distance and still count as there. The nearest place keeps a little more than the radius
/// from walls.
inline constexpr double kBesideSlack = 1e-5;

/// Where a robot's route ends.
enum class RouteEnd : std::uint8_t {
  goal,
  beside,    ///< the nearest reachable place, within arrival_distance: the robot has arrived then
  short_of,  ///< the nearest reachable place, farther off
};

/// What a robot remembers where passages are held (docs/arrival.md, rule 11).
struct Waiting {
  // m, the least remaining length of its route so far
  double least = std::numeric_limits<double>::infinity();
  double waited = 0.0;  // s, since then
  // s, of waiting, after which it searches for another route
  double looks_at = std::numeric_limits<double>::infinity();
  std::vector<Segment> closed = {};  // gaps that it does not go through
  // m, of its remaining route: they stay closed while more is left
  double opens_at = 0.0;
  // the map without the closed gaps; none where there are none
  std::shared_ptr<const PathMap> open = {};
};

/// One robot's route. Steps change the target: a corner of the graph, the end, or nothing yet.
struct Travel {
  const CornerGraph* graph = nullptr;  // none: the robot moves straight to its end
  std::shared_ptr<const PathMap> map = {};
  std::uint32_t target = PathMap::kNothing;
  bool around_movers = false;  // whether the graph is of walls and of movers at rest
  RouteEnd ends = RouteEnd::goal;
  Vec2 place = {};  // m, where it ends, if not at the goal
  Waiting waiting = {};

  /// Returns whether a route to its end is known.
  [[nodiscard]] bool is_known() const { return graph != nullptr && target != PathMap::kNothing; }
  /// m, its end, for a robot with that goal.
  [[nodiscard]] Vec2 end(Vec2 goal) const { return ends == RouteEnd::goal ? goal : place; }
  /// m, the final target of such a robot: the goal itself without navigation.
  [[nodiscard]] Vec2 heads_for(Vec2 goal) const { return graph != nullptr ? end(goal) : goal; }
};

/// The place that a robot moves to, as far off as its goal is along the route, and its speed at
/// most.
struct Heading {
  Vec2 goal = {};                // m
  double preferred_speed = 0.0;  // m/s
  // m, next point of its route, the goal itself or a corner before it; or its place in a lane, or
  // beside a passage
  Vec2 next = {};
  bool yields = false;  // to others at a passage
  Guide guide = Guide::route;
};

inline Heading straight_to(Vec2 end, const RobotTraits& robot) {
  return {.goal = end, .preferred_speed = robot.preferred_speed, .next = end};
}

/// The place of the target, and m, the distance from there to the end; none where there is no
/// target.
std::optional<std::pair<Vec2, double>> rest_of(const Travel& travel);

/// Sets the target to the one on the shortest route, of all in view.
void aim_at_best(Travel& travel, Vec2 position, double radius, LegScratch& scratch);

/// Returns whether a robot on that graph may search for its own route: there are many corners.
bool is_searched(const CornerGraph& graph);

/// A route to the same end that leads around those gaps, for a robot that begins to wait anew. Its
/// target is unknown where there is no such route.
Travel around(const Travel& travel, Vec2 position, double radius, std::vector<Segment> closed,
              LegScratch& scratch);

/// The route with all gaps open, for a route that leads around gaps.
Travel reopened(const Travel& travel, Vec2 position, double radius, LegScratch& scratch);

/// Sets the target, and makes its map contain it.
void aim_at(Travel& travel, std::uint32_t target, LegScratch& scratch);

/// m, from there to its end through the target, which is known.
double length_of(const Travel& travel, Vec2 position);

/// The rest of the route of a robot with that goal: through the target, unless that is unknown.
Simulation::Route rest_of_route(const Travel& travel, Vec2 position, Vec2 goal);

/// Updates the target. end: of the route, or the goal where there are no walls. `looks_around` must
/// be true from time to time, see next_leg(). A robot that finds its own path within `own_path` m
/// of the end moves straight to it there, unless the route around is much longer.
Heading follow(Travel& travel, Vec2 position, Vec2 end, const RobotTraits& robot, double own_path,
               bool looks_around, LegScratch& scratch);

/// Changes the heading of a robot of that radius, if a mover at rest stands on its end and it moves
/// there. The robot then comes to rest beside the mover, on its own side.
Heading beside_resting(std::span<const Wall> resting, const Heading& heading, Vec2 position,
                       Vec2 end, double radius);

/// Returns whether the robot looks around in this step: not all robots do at once.
bool looks_around(RobotId robot, std::int64_t steps);

}  // namespace avo::inline guidance
