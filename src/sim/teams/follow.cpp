// SPDX-License-Identifier: Apache-2.0
// Robots that follow the first one of their team: on its trail, or at places about it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/teams/tasks.h"

namespace avo::inline sim {
namespace {

constexpr double kTrailStep = 0.25;  // of the spacing, between two places of a trail
constexpr double kClosing = 1.0;     // 1/s: how fast a distance to one's place shrinks
constexpr double kAtRest = 0.01;     // of the preferred speed

/// A place that moves, for a robot to keep.
struct Moving {
  Vec2 place, velocity;  // m, m/s
};

/// The robot that the others follow, at present.
struct Leader {
  Vec2 place, velocity;  // m, m/s
  bool is_at_rest = false;
};

std::span<TeamMember> others(Team& team) {
  return std::span(team.members).subspan(1);
}

// A trail for a team that sets out, or has another leader. A row begins as it stands; slots begin
// behind a leader that sets out on its route.
void begin_trail(const Follow& follow, const Simulation& simulation, Team& team) {
  const RobotId first = team.members.front().robot;
  const Vec2 leader = simulation.robot(first).position;
  const auto from_leader = [&](const TeamMember& member) {
    return norm_squared(place_of(simulation, member) - leader);
  };
  std::stable_sort(
      team.members.begin() + 1, team.members.end(),
      [&](const TeamMember& a, const TeamMember& b) { return from_leader(a) < from_leader(b); });
  team.leader = team.members.front().robot;
  team.trail.clear();
  const Vec2 route = simulation.route(first).next - leader;
  if (!follow.slots.empty()) {
    const double length = norm(route);
    team.trail = {leader - follow.spacing * (length > 0.0 ? route / length : Vec2{1.0, 0.0})};
  } else {
    for (std::size_t k = team.members.size() - 1; k > 0; --k)
      team.trail.push_back(place_of(simulation, team.members[k]));
  }
  if (team.trail.empty() || norm(leader - team.trail.back()) > 0.0) team.trail.push_back(leader);
}

// Notes where the leader is. Where it comes back to its trail, the trail ends there: a leader that
// is pushed about at its goal makes no trail. What lies farther back than any robot follows is
// dropped.
void go_on(Vec2 leader, double spacing, double needed, std::vector<Vec2>& trail) {
  const double step = kTrailStep * spacing;
  const auto met = std::find_if(trail.begin(), trail.end(),
                                [&](Vec2 place) { return norm(leader - place) < step; });
  if (met != trail.end())
    trail.erase(met + 1, trail.end());
  else
    trail.push_back(leader);
  double length = norm(leader - trail.back());
  std::size_t first = trail.size() - 1;
  while (first > 0 && length <= needed) {
    length += norm(trail[first] - trail[first - 1]);
    --first;
  }
  trail.erase(trail.begin(), trail.begin() + static_cast<std::ptrdiff_t>(first));
}

// The place on the trail that is so far behind the leader, m, and moves as fast as the leader.
// Beyond its end the trail goes straight on.
Moving on_trail(const Leader& leader, double behind, std::span<const Vec2> trail) {
  const double speed = norm(leader.velocity);
  Vec2 from = leader.place, direction;
  for (std::size_t k = trail.size(); k > 0; --k) {
    const Vec2 piece = from - trail[k - 1];
    const double length = norm(piece);
    if (length > 0.0) direction = piece / length;
    if (length >= behind) break;
    behind -= length;
    from = trail[k - 1];
  }
  return {from - behind * direction, speed * direction};
}

// The place of a slot. The slots look along the trail, so that they turn as the leader goes on.
Moving at_slot(const Leader& leader, Vec2 slot, double spacing, std::span<const Vec2> trail) {
  const Vec2 behind = leader.place - on_trail(leader, spacing, trail).place;
  const double length = norm(behind);
  const Vec2 ahead = length > 0.0 ? behind / length : Vec2{1.0, 0.0};
  return {leader.place + slot.x * ahead + slot.y * perpendicular(ahead), leader.velocity};
}

// Matches robots and slots so that the lines to the slots do not cross. Robots beyond the slots
// follow the trail.
void take_slots(const Follow& follow, const Leader& leader, const Simulation& simulation,
                Team& team) {
  std::vector<Vec2> places, slots;
  for (const TeamMember& member :
       others(team).first(std::min(follow.slots.size(), team.members.size() - 1)))
    places.push_back(place_of(simulation, member));
  for (const Vec2 slot : follow.slots)
    slots.push_back(at_slot(leader, slot, follow.spacing, team.trail).place);
  const std::vector<std::size_t> chosen = assign_slots(places, slots);
  for (std::size_t k = 0; k < team.members.size() - 1; ++k)
    team.members[k + 1].number =
        static_cast<std::uint32_t>(k < chosen.size() ? chosen[k] : slots.size());
}

// The place of the team's robot k: its slot, or its place on the trail where a wall hides the slot.
Moving wanted_by(std::size_t k, double radius, const Follow& follow, const Leader& leader,
                 const Simulation& simulation, const Team& team) {
  const std::uint32_t slot = team.members[k].number;
  if (slot < follow.slots.size()) {
    const Moving wanted = at_slot(leader, follow.slots[slot], follow.spacing, team.trail);
    if (simulation.is_in_sight(leader.place, wanted.place, radius)) return wanted;
  }
  return on_trail(leader, follow.spacing * static_cast<double>(k), team.trail);
}

// Leads a robot to its place: by a velocity where no wall lies between, else by its route. Once the
// leader rests, the place is the robot's goal, so that the robot comes to rest as well.
void keep(const Moving& wanted, bool is_at_rest, RobotId id, Simulation& simulation) {
  const RobotState robot = simulation.robot(id);
  const RobotSetup setup = simulation.setup(id);
  if (is_at_rest || !simulation.is_in_sight(robot.position, wanted.place, setup.radius)) {
    simulation.set_preferred_velocity(id, std::nullopt);
    simulation.set_goal(id, wanted.place);
    return;
  }
  const Vec2 off = wanted.place - robot.position;
  const double distance = norm(off);
  // m/s: half of max_acceleration suffices to stop there
  const double braking = std::sqrt(setup.max_acceleration * distance);
  Vec2 velocity = wanted.velocity;
  if (distance > 0.0) velocity = velocity + std::min(kClosing * distance, braking) / distance * off;
  const double speed = norm(velocity);
  if (speed > setup.max_speed) velocity = setup.max_speed / speed * velocity;
  simulation.set_preferred_velocity(id, velocity);
}

Leader look_at(const Simulation& simulation, RobotId first) {
  const RobotState robot = simulation.robot(first);
  const double least = kAtRest * simulation.setup(first).preferred_speed;  // m/s
  return {robot.position, robot.velocity,
          simulation.is_at_goal(first) && norm(robot.velocity) <= least};
}

}  // namespace

void lead(const Follow& follow, Simulation& simulation, Team& team) {
  const TeamMember& first = team.members.front();
  const bool is_new = !first.is_led || team.leader != first.robot;
  if (is_new) {
    if (first.is_led) {  // it has followed another leader
      simulation.set_preferred_velocity(first.robot, std::nullopt);
      simulation.set_goal(first.robot, first.goal);
    }
    begin_trail(follow, simulation, team);
  }
  const Leader leader = look_at(simulation, first.robot);
  go_on(leader.place, follow.spacing, follow.spacing * static_cast<double>(team.members.size()),
        team.trail);
  const bool has_new = std::any_of(team.members.begin(), team.members.end(),
                                   [](const TeamMember& member) { return !member.is_led; });
  if (is_new || has_new) take_slots(follow, leader, simulation, team);
  for (std::size_t k = 1; k < team.members.size(); ++k) {
    const RobotId robot = team.members[k].robot;
    const double radius = simulation.setup(robot).radius;
    keep(wanted_by(k, radius, follow, leader, simulation, team), leader.is_at_rest, robot,
         simulation);
  }
}

}  // namespace avo::inline sim
