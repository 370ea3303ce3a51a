// SPDX-License-Identifier: Apache-2.0
// All shortest ways to one goal, and what a robot on its way makes of them (docs/navigation.md).
#pragma once
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "navigation/corner_graph.h"

namespace avo {

/// For every corner of a graph the way to the goal.
struct PathMap {
  static constexpr std::uint32_t kGoal = 0xffffffff;     // instead of a corner
  static constexpr std::uint32_t kNothing = 0xfffffffe;  // likewise
  Vec2 goal = {};
  double room = 0.0;                // m, that the last leg keeps from walls
  bool is_free = false;             // whether the robot can be at the goal
  std::vector<double> length;       // m, from each corner on; infinity: no way
  std::vector<std::uint32_t> next;  // the corner after it, kGoal or kNothing
  std::vector<double> top;          // m, what v²/a may be there for all the turns behind it
};

PathMap path_map(const CornerGraph& graph, Vec2 goal);

/// What a robot aims at next, and how.
struct Leg {
  Vec2 aim = {};
  std::uint32_t target = PathMap::kNothing;  // kNothing: no way is known from here
  double length = 0.0;                       // m, of the whole way that is left
  double turn = 0.0;                         // |sin φ| of the turn at the aim, 1 beyond 90 degrees
  double top = std::numeric_limits<double>::infinity();  // m, what v²/a may be here
  [[nodiscard]] bool is_last() const { return target == PathMap::kGoal; }
};

/// Memory to look around with; reuse it and nothing is allocated once it has grown.
struct LegScratch {
  std::vector<std::pair<double, std::uint32_t>> targets;
};

/// From p on: to the target remembered or the one after it while they are in view; with
/// `looks_around`, or where that fails, to whatever in view is on the shortest way. The radius, at
/// most the graph's, is the robot's.
Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch);

/// m/s, from which the turns ahead can be made; none for the goal, where the last leg ends.
double speed_limit(const Leg& leg, double max_acceleration);

}  // namespace avo
