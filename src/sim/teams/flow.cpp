// SPDX-License-Identifier: Apache-2.0
// A crowd that leaves. An exit has goals side by side, which robots share, as their routes do.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
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
  const double gaps = std::floor(usable / spacing);  // between goals
  const Vec2 along = (b - a) / length;
  const double first = 0.5 * (length - gaps * spacing);  // m, from a
  for (double k = 0.0; k <= gaps; k += 1.0) goals.push_back(a + (first + k * spacing) * along);
}

// The number of a member that has come to an exit: it is at its goal, and gone one step later, so
// that observers of every step see it arrive.
constexpr std::uint32_t kLeaves = std::numeric_limits<std::uint32_t>::max();

// The goals on all exits for robots of one radius.
struct ExitGoals {
  double radius = -1.0;  // m
  std::vector<Vec2> goals;
};

void make_for(const Flow& flow, double radius, ExitGoals& made) {
  if (radius == made.radius) return;
  made.radius = radius;
  made.goals.clear();
  for (std::size_t k = 0; k + 1 < flow.exits.size(); k += 2)
    append_goals(flow.exits[k], flow.exits[k + 1], flow.spacing, radius, made.goals);
}

// The goal of a member. A new member takes the nearest goal, and keeps it.
Vec2 goal_of(std::span<const Vec2> goals, Vec2 place, TeamMember& member) {
  if (!member.is_led || member.number >= goals.size()) {
    const auto nearest = std::min_element(goals.begin(), goals.end(), [&](Vec2 a, Vec2 b) {
      return norm_squared(a - place) < norm_squared(b - place);
    });
    member.number = static_cast<std::uint32_t>(nearest - goals.begin());
  }
  return goals[member.number];
}

// The place on the exit from a to b that is nearest to the point.
Vec2 nearest_on(Vec2 a, Vec2 b, Vec2 point) {
  const Vec2 along = b - a;
  const double squared = norm_squared(along);
  const double part = squared > 0.0 ? dot(point - a, along) / squared : 0.0;
  return a + std::clamp(part, 0.0, 1.0) * along;
}

// Whether a robot has come to an exit, wherever on the exit its goal is.
bool is_out(const Flow& flow, const Simulation& simulation, RobotId robot, Vec2 place) {
  const double arrival = simulation.setup(robot).arrival_distance.value_or(
      simulation.planner().options().arrival_distance);
  for (std::size_t exit = 0; exit + 1 < flow.exits.size(); exit += 2) {
    const Vec2 nearest = nearest_on(flow.exits[exit], flow.exits[exit + 1], place);
    if (norm(nearest - place) <= arrival && simulation.is_in_sight(place, nearest)) return true;
  }
  return false;
}

}  // namespace

void lead(const Flow& flow, Simulation& simulation, Team& team) {
  std::vector<RobotId> gone;
  std::vector<TeamMember> staying;
  std::vector<Vec2> goals;  // of those that stay
  ExitGoals made;
  for (TeamMember member : team.members) {
    if (member.is_led && member.number == kLeaves) {
      gone.push_back(member.robot);
      continue;
    }
    make_for(flow, disc_radius(simulation.setup(member.robot)), made);
    const Vec2 place = place_of(simulation, member), goal = goal_of(made.goals, place, member);
    const bool leaves = member.is_led && is_out(flow, simulation, member.robot, place);
    if (leaves) member.number = kLeaves;
    staying.push_back(member);
    goals.push_back(leaves ? place : goal);
  }
  if (!gone.empty()) simulation.remove_robots(gone);
  team.members = std::move(staying);
  set_goals(simulation, team, 0, goals);
}

}  // namespace avo::inline sim
