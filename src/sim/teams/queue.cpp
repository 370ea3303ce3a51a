// SPDX-License-Identifier: Apache-2.0
// A queue: its places are the goals of its robots, so that robots in it rest and move up.
#include <vector>

#include "sim/teams/tasks.h"

namespace avo::inline sim {
namespace {

constexpr double kRounding = 1e-9;  // s, of a sum of steps

// Whether the first robot has waited long enough at the head.
bool is_served(const Queue& queue, const Simulation& simulation, Team& team) {
  const TeamMember& first = team.members.front();
  const bool is_there = first.is_led && simulation.is_at_goal(first.robot);
  if (!is_there) return false;
  if (team.since < 0.0) team.since = simulation.time();
  return queue.service && simulation.time() - team.since >= *queue.service - kRounding;
}

}  // namespace

RobotId send_first(Simulation& simulation, Team& team) {
  const TeamMember first = team.members.front();
  simulation.set_goal(first.robot, first.goal);
  team.members.erase(team.members.begin());
  team.since = -1.0;
  return first.robot;
}

void lead(const Queue& queue, Simulation& simulation, Team& team) {
  line_up(simulation, queue.line.front(), team);
  if (is_served(queue, simulation, team)) send_first(simulation, team);
  std::vector<Vec2> goals;
  goals.reserve(team.members.size());
  for (std::size_t k = 0; k < team.members.size(); ++k)
    goals.push_back(place_along(queue.line, queue.spacing * static_cast<double>(k)));
  set_goals(simulation, team, 0, goals);
}

}  // namespace avo::inline sim
