// SPDX-License-Identifier: Apache-2.0
// A patrol: its robots pass points in turn, and do not stop at them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/teams/tasks.h"

namespace avo::inline sim {
namespace {

std::uint32_t nearest(std::span<const Vec2> points, Vec2 place) {
  const auto by_distance = [&](Vec2 a, Vec2 b) {
    return norm_squared(a - place) < norm_squared(b - place);
  };
  return static_cast<std::uint32_t>(std::min_element(points.begin(), points.end(), by_distance) -
                                    points.begin());
}

constexpr double kBeside = 4.0;     // pass_distance: a robot at rest is beside its point
constexpr double kStanding = 0.01;  // m/s

// Whether a robot goes on. It does if it is near its point, or cannot come to the point at all. It
// also does if it rests beside the point because another robot is there.
bool has_passed(const Patrol& patrol, const Simulation& simulation, const TeamMember& member) {
  const Vec2 point = patrol.points[member.number];
  const RobotState robot = simulation.robot(member.robot);
  const double off = norm(point - robot.position);
  if (off <= patrol.pass_distance) return true;
  if (!member.is_led) return false;
  if (simulation.is_at_goal(robot.id) || !std::isfinite(simulation.route(robot.id).length))
    return true;
  return norm(robot.velocity) <= kStanding && off <= kBeside * patrol.pass_distance &&
         !simulation.is_free(point, disc_radius(simulation.setup(robot.id)));
}

}  // namespace

void lead(const Patrol& patrol, Simulation& simulation, Team& team) {
  std::vector<Vec2> goals;
  goals.reserve(team.members.size());
  for (TeamMember& member : team.members) {
    if (!member.is_led) member.number = nearest(patrol.points, place_of(simulation, member));
    member.number %= static_cast<std::uint32_t>(patrol.points.size());
    if (has_passed(patrol, simulation, member))
      member.number = (member.number + 1) % static_cast<std::uint32_t>(patrol.points.size());
    goals.push_back(patrol.points[member.number]);
  }
  set_goals(simulation, team, 0, goals);
}

}  // namespace avo::inline sim
