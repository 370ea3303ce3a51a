// SPDX-License-Identifier: Apache-2.0
// Teams: their checks, and what all tasks have in common.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/ranges.h"
#include "fields/team_fields.h"
#include "planner/options.h"
#include "sim/teams/tasks.h"

namespace avo::inline sim {

Vec2 place_of(const Simulation& simulation, const TeamMember& member) {
  return simulation.robot(member.robot).position;
}

Vec2 place_along(std::span<const Vec2> line, double length) {
  std::size_t k = 1;
  double piece = norm(line[1] - line[0]);
  while (k + 1 < line.size() && length > piece) {
    length -= piece;
    ++k;
    piece = norm(line[k] - line[k - 1]);
  }
  return line[k - 1] + length / piece * (line[k] - line[k - 1]);
}

void line_up(const Simulation& simulation, Vec2 point, Team& team) {
  const auto fresh = std::stable_partition(team.members.begin(), team.members.end(),
                                           [](const TeamMember& member) { return member.is_led; });
  std::stable_sort(fresh, team.members.end(), [&](const TeamMember& a, const TeamMember& b) {
    return norm_squared(place_of(simulation, a) - point) <
           norm_squared(place_of(simulation, b) - point);
  });
}

void set_goals(Simulation& simulation, const Team& team, std::size_t first,
               std::span<const Vec2> goals) {
  std::vector<RobotId> robots;
  robots.reserve(goals.size());
  for (std::size_t k = 0; k < goals.size(); ++k) robots.push_back(team.members[first + k].robot);
  simulation.set_goals(robots, goals);
}

namespace {

void require_points(const char* name, std::span<const Vec2> points, std::size_t least) {
  if (points.size() < least)
    refuse(name, std::to_string(points.size()) + " points", "at least " + std::to_string(least));
  for (std::size_t k = 0; k < points.size(); ++k)
    require(std::string(name) + "." + std::to_string(k), points[k], "m");
}

template <class Task>
void require_numbers(const Task& task) {
  require_ranges(task, [](std::string_view key) { return key; });
}

void check(const Queue& queue) {
  require_points("line", queue.line, 2);
  for (std::size_t k = 1; k < queue.line.size(); ++k)
    if (!(norm(queue.line[k] - queue.line[k - 1]) > kSmallest))
      refuse("line." + std::to_string(k), "the point before it", "another point");
  require_numbers(queue);
}

void check(const Follow& follow) {
  require_numbers(follow);
  require_points("slots", follow.slots, 0);
}

void check(const Patrol& patrol) {
  require_points("points", patrol.points, 1);
  require_numbers(patrol);
}

void check(const Flow& flow) {
  require_points("exits", flow.exits, 2);
  if (flow.exits.size() % 2 != 0)
    refuse("exits", std::to_string(flow.exits.size()) + " points", "two for each exit");
  require_numbers(flow);
  constexpr double kMostGoals = 1000.0;  // on an exit
  for (std::size_t k = 0; k < flow.exits.size(); k += 2) {
    const double least = norm(flow.exits[k + 1] - flow.exits[k]) / kMostGoals;
    if (flow.spacing < least)
      refuse("spacing", text(flow.spacing),
             ">= " + text(least) + " m, a thousandth of exit " + std::to_string(k / 2));
  }
}

void require_each_once(const Team& team) {
  std::vector<std::uint64_t> ids;
  ids.reserve(team.members.size());
  for (const TeamMember& member : team.members) ids.push_back(member.robot.value);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end())
    refuse("team", "robot " + std::to_string(*twice) + " twice", "each robot once");
}

}  // namespace
}  // namespace avo::inline sim

namespace avo {

const char* to_string(Formation formation) {
  return kNames<Formation>[static_cast<std::size_t>(formation)];
}

Team make_team(std::span<const RobotId> robots, TeamTask task) {
  Team team;
  for (const RobotId robot : robots) team.members.push_back({robot});
  team.task = std::move(task);
  require_each_once(team);
  return team;
}

void validate(const TeamTask& task) {
  std::visit([](const auto& one) { check(one); }, task);
}

void lead(Simulation& simulation, Team& team) {
  validate(team.task);
  require_each_once(team);
  std::erase_if(team.members,
                [&](const TeamMember& member) { return !simulation.index_of(member.robot); });
  if (team.members.empty()) return;
  for (TeamMember& member : team.members)
    if (!member.is_led) member.goal = simulation.robot(member.robot).goal;
  std::visit([&](const auto& task) { lead(task, simulation, team); }, team.task);
  for (TeamMember& member : team.members) member.is_led = true;
}

std::optional<RobotId> serve(Simulation& simulation, Team& team) {
  if (!std::holds_alternative<Queue>(team.task)) return std::nullopt;
  std::erase_if(team.members,
                [&](const TeamMember& member) { return !simulation.index_of(member.robot); });
  const std::optional<TeamMember> before =
      team.members.empty() ? std::nullopt : std::optional(team.members.front());
  lead(simulation, team);
  // its service has ended just now
  if (before && before->is_led &&
      (team.members.empty() || team.members.front().robot != before->robot))
    return before->robot;
  if (team.members.empty()) return std::nullopt;
  const RobotId robot = send_first(simulation, team);
  lead(simulation, team);
  return robot;
}

void set_task(Simulation& simulation, Team& team, TeamTask task) {
  validate(task);
  const std::vector<TeamMember> members = team.members;
  disband(simulation, team);
  for (const TeamMember& member : members) team.members.push_back({member.robot});
  team.task = std::move(task);
}

void disband(Simulation& simulation, Team& team) {
  for (const TeamMember& member : team.members) {
    if (!member.is_led || !simulation.index_of(member.robot)) continue;
    simulation.set_goal(member.robot, member.goal);
    simulation.set_preferred_velocity(member.robot, std::nullopt);
  }
  team = {.members = {}, .task = std::move(team.task)};
}

}  // namespace avo
