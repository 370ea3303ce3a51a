// SPDX-License-Identifier: Apache-2.0
// The next decision of a navigator with its reasons.
#include <algorithm>
#include <cstddef>
#include <numeric>

#include "guidance/words.h"
#include "navigator/state.h"
#include "planner/decision.h"
#include "planner/validity.h"

namespace avo::inline navigator {
namespace {

// The neighbors, nearest first, with their indices; movers have -1 - index.
void look(const Robot& robot, std::span<const Neighbor> neighbors, Simulation::Perception& seen) {
  std::vector<std::size_t> order(neighbors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return norm_squared(neighbors[a].position - robot.position) <
           norm_squared(neighbors[b].position - robot.position);
  });
  for (const std::size_t k : order) {
    Neighbor& neighbor = seen.neighbors.emplace_back(neighbors[k]);
    if (neighbor.trajectory != nullptr)
      neighbor.trajectory =
          seen.trajectories.emplace_back(std::make_shared<Trajectory>(*neighbor.trajectory)).get();
    const auto index = static_cast<std::int64_t>(k);
    seen.source.push_back(shares(neighbor) ? index : -1 - index);
  }
}

}  // namespace

Explanation explanation_of(NavigatorState& state, const Robot& robot,
                           std::span<const Neighbor> neighbors) {
  Memory memory = state.memory;  // a step of a copy
  Explanation explanation;
  explanation.robot = state.options.id;
  explanation.time = memory.time.value_or(0.0);
  Simulation::Perception& seen = explanation.seen;
  look(robot, neighbors, seen);
  seen.robot = robot;
  seen.detour = memory.detour;
  seen.among_movers = is_among_movers(state.planner.options(), seen.neighbors);
  if (all_valid(robot, neighbors)) {
    const double time_step = state.planner.options().time_step;
    const SetOut out = set_out(state, memory, robot, neighbors, time_step);
    seen.robot = out.robot, seen.guide = out.guide, seen.wait = out.wait;
    seen.detour = memory.detour;
    seen.walls.assign(out.walls.begin(), out.walls.end());
    if (out.stops) seen.stop = stop_of(state.planner, state.response, robot);
  }
  explanation.goal = state.mission.has_goal() ? state.mission.goal() : place_of(robot);
  explanation.is_at_goal = is_reached(state, memory, robot);
  explanation.distance_left = route_left(state, memory, robot).distance_left;
  explain_decision(state.planner, explanation);
  return explanation;
}

}  // namespace avo::inline navigator
