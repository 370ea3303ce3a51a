// SPDX-License-Identifier: Apache-2.0
// A crowd that leaves. An exit has goals side by side, which robots share, as their routes do.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/teams/tasks.h"

namespace avo::inline sim {
namespace {

// The nearest goal on the exit from a to b for a robot that needs `radius` beside it.
Vec2 goal_on(Vec2 a, Vec2 b, double spacing, double radius, Vec2 place) {
  const double length = norm(b - a), usable = length - 2.0 * radius;  // m
  if (!(usable > 0.0)) return 0.5 * (a + b);
  const double lanes = std::floor(usable / spacing);  // gaps between goals
  const Vec2 along = (b - a) / length;
  const double first = 0.5 * (length - lanes * spacing);  // m, from a
  const double wanted = std::round((dot(place - a, along) - first) / spacing);
  return a + (first + spacing * std::clamp(wanted, 0.0, lanes)) * along;
}

Vec2 nearest_goal(const Flow& flow, double radius, Vec2 place) {
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < flow.exits.size(); k += 2) {
    const Vec2 goal = goal_on(flow.exits[k], flow.exits[k + 1], flow.spacing, radius, place);
    const double distance = norm(goal - place);
    if (distance < least) least = distance, nearest = goal;
  }
  return nearest;
}

}  // namespace

void lead(const Flow& flow, Simulation& simulation, Team& team) {
  std::vector<RobotId> gone;
  std::erase_if(team.members, [&](const TeamMember& member) {
    const bool is_out = member.is_led && simulation.is_at_goal(index_of(simulation, member));
    if (is_out) gone.push_back(member.robot);
    return is_out;
  });
  if (!gone.empty()) simulation.remove_robots(gone);
  std::vector<Vec2> goals;
  std::vector<RobotId> fresh;
  for (const TeamMember& member : team.members) {
    if (member.is_led) continue;
    const std::size_t k = index_of(simulation, member);
    fresh.push_back(member.robot);
    goals.push_back(
        nearest_goal(flow, disc_radius(simulation.setup(k)), simulation.robot(k).position));
  }
  if (!fresh.empty()) simulation.set_goals(fresh, goals);
}

}  // namespace avo::inline sim
