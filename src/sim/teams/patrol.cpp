// SPDX-License-Identifier: Apache-2.0
// A patrol: its robots pass points in turn, and do not stop at them.
#include <algorithm>
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

}  // namespace

void lead(const Patrol& patrol, Simulation& simulation, Team& team) {
  std::vector<Vec2> goals;
  goals.reserve(team.members.size());
  for (TeamMember& member : team.members) {
    const Vec2 place = place_of(simulation, member);
    if (!member.is_led) member.number = nearest(patrol.points, place);
    member.number %= static_cast<std::uint32_t>(patrol.points.size());
    if (norm(patrol.points[member.number] - place) <= patrol.pass_distance)
      member.number = (member.number + 1) % static_cast<std::uint32_t>(patrol.points.size());
    goals.push_back(patrol.points[member.number]);
  }
  set_goals(simulation, team, 0, goals);
}

}  // namespace avo::inline sim
