// SPDX-License-Identifier: Apache-2.0
// A crowd that leaves. An exit has goals side by side, which robots share, as their routes do.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/teams/tasks.h"

namespace avo::inline sim {
namespace {

// Appends the goals on the exit from a to b for a robot that needs `radius` beside it.
void append_goals(Vec2 a, Vec2 b, double spacing, double radius, std::vector<Vec2>& goals) {
  const double length = norm(b - a), usable = length - 2.0 * radius;  // m
  if (!(usable > 0.0)) {
    goals.push_back(0.5 * (a + b));
    return;
  }
  constexpr double kMost = 1000.0;  // gaps between goals
  const double gaps = std::min(std::floor(usable / spacing), kMost);
  const Vec2 along = (b - a) / length;
  const double first = 0.5 * (length - gaps * spacing);  // m, from a
  for (double k = 0.0; k <= gaps; k += 1.0) goals.push_back(a + (first + k * spacing) * along);
}

std::vector<Vec2> goals_for(const Flow& flow, double radius) {
  std::vector<Vec2> goals;
  for (std::size_t k = 0; k + 1 < flow.exits.size(); k += 2)
    append_goals(flow.exits[k], flow.exits[k + 1], flow.spacing, radius, goals);
  return goals;
}

// The goal of a member; one that is new takes the nearest, and keeps it.
Vec2 goal_of(const Flow& flow, const Simulation& simulation, TeamMember& member) {
  const std::size_t k = index_of(simulation, member);
  const std::vector<Vec2> goals = goals_for(flow, disc_radius(simulation.setup(k)));
  const Vec2 place = simulation.robot(k).position;
  if (!member.is_led || member.number >= goals.size()) {
    const auto nearest = std::min_element(goals.begin(), goals.end(), [&](Vec2 a, Vec2 b) {
      return norm_squared(a - place) < norm_squared(b - place);
    });
    member.number = static_cast<std::uint32_t>(nearest - goals.begin());
  }
  return goals[member.number];
}

// Whether a robot has come to its goal on the exit. Robots that others or a mover keep from it, or
// that the host has sent elsewhere, are not out.
bool is_out(const Flow& flow, const Simulation& simulation, TeamMember& member) {
  if (!member.is_led) return false;
  const std::size_t k = index_of(simulation, member);
  const double arrival = simulation.setup(k).arrival_distance.value_or(
      simulation.planner().options().arrival_distance);
  const Vec2 off = simulation.robot(k).position - goal_of(flow, simulation, member);
  return simulation.is_at_goal(k) && norm(off) <= arrival;
}

}  // namespace

void lead(const Flow& flow, Simulation& simulation, Team& team) {
  std::vector<RobotId> gone;
  std::erase_if(team.members, [&](TeamMember& member) {
    const bool leaves = is_out(flow, simulation, member);
    if (leaves) gone.push_back(member.robot);
    return leaves;
  });
  if (!gone.empty()) simulation.remove_robots(gone);
  std::vector<Vec2> goals;
  goals.reserve(team.members.size());
  for (TeamMember& member : team.members) goals.push_back(goal_of(flow, simulation, member));
  set_goals(simulation, team, 0, goals);
}

}  // namespace avo::inline sim
