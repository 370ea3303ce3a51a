// SPDX-License-Identifier: Apache-2.0
// Teams, and formations.
#include "avo/teams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "simulations.h"

namespace avo_c {

namespace {

static_assert(AVO_FORMATION_RING == static_cast<int>(avo::Formation::ring));

/// A team of the host, or a team that a simulation leads.
struct TeamOfAny {
  avo::Team own = {};
  std::optional<avo_simulation_id> leads = {};  // the simulation that leads it
  std::size_t number = 0;                       // among its teams
};

AVO_C_CONSTINIT Handles<avo_team_id, TeamOfAny> teams("team");

avo::Team& team_at(avo_team_id id) {
  TeamOfAny& team = teams.at(id);
  if (!team.leads) return team.own;
  const std::span<avo::Team> all = simulations.at(*team.leads).simulation.teams();
  if (team.number >= all.size()) fail(AVO_ERROR_INVALID_ID, "team: found one that is gone");
  return all[team.number];
}

// The team, which that simulation leads if any leads it.
avo::Team& team_at(avo_team_id id, avo_simulation_id simulation) {
  const std::optional<avo_simulation_id>& leads = teams.at(id).leads;
  if (leads && (leads->index != simulation.index || leads->generation != simulation.generation))
    fail(AVO_ERROR_INVALID_ID, "team: found a team of another simulation, must be of this one");
  return team_at(id);
}

std::vector<avo::RobotId> ids_of(const avo_robot_id* robots, std::size_t count) {
  require_array(robots, count, "robots");
  std::vector<avo::RobotId> ids;
  for (std::size_t k = 0; k < count; ++k) {
    if (robots[k].value == 0)
      fail(AVO_ERROR_INVALID_ID,
           "robots." + std::to_string(k) + ": found a null id, must be one of a robot");
    ids.push_back(from_c(robots[k]));
  }
  return ids;
}

avo::TeamTask task_of(const avo_team_def& def, const Where& where) {
  std::vector<avo::Vec2> points = points_of(def.points, def.point_count, "points");
  const auto spacing = [&](double usual) { return def.spacing == 0.0 ? usual : def.spacing; };
  switch (def.task) {
    case AVO_TASK_QUEUE: {
      const bool is_timed = !std::isnan(def.service);
      return avo::Queue{std::move(points), spacing(avo::Queue{}.spacing),
                        is_timed ? std::optional(def.service) : std::nullopt};
    }
    case AVO_TASK_FOLLOW:
      return avo::Follow{spacing(avo::Follow{}.spacing), std::move(points)};
    case AVO_TASK_PATROL:
      return avo::Patrol{std::move(points), def.pass_distance == 0.0 ? avo::Patrol{}.pass_distance
                                                                     : def.pass_distance};
    case AVO_TASK_FLOW:
      return avo::Flow{std::move(points), spacing(avo::Flow{}.spacing)};
    default:
      fail(AVO_ERROR_INVALID_VALUE,
           where / "task" + ": found " + std::to_string(def.task) + ", must be 0 to 3");
  }
}

const avo_vec2* lent(const std::vector<avo::Vec2>& points) {
  return reinterpret_cast<const avo_vec2*>(points.data());
}

void set_task(const avo::Queue& queue, avo_team_def& def) {
  def.task = AVO_TASK_QUEUE, def.spacing = queue.spacing;
  def.points = lent(queue.line), def.point_count = queue.line.size();
  if (queue.service) def.service = *queue.service;
}
void set_task(const avo::Follow& follow, avo_team_def& def) {
  def.task = AVO_TASK_FOLLOW, def.spacing = follow.spacing;
  def.points = lent(follow.slots), def.point_count = follow.slots.size();
}
void set_task(const avo::Patrol& patrol, avo_team_def& def) {
  def.task = AVO_TASK_PATROL, def.pass_distance = patrol.pass_distance;
  def.points = lent(patrol.points), def.point_count = patrol.points.size();
}
void set_task(const avo::Flow& flow, avo_team_def& def) {
  def.task = AVO_TASK_FLOW, def.spacing = flow.spacing;
  def.points = lent(flow.exits), def.point_count = flow.exits.size();
}

// change(own) of the simulation with that id: a team may remove robots, and changes goals.
template <typename Change>
void change_by_team(avo_simulation_id id, const Change& change) {
  Simulation& own = simulations.at(id);
  own.has_ids.store(false, std::memory_order_relaxed);
  change(own.simulation);
}

}  // namespace

avo::Team team_of(const avo_team_def& def, const Where& where) {
  return avo::make_team(ids_of(def.robots, def.robot_count), task_of(def, where));
}

avo_team_def def_of(const avo::Team& team, std::vector<avo_robot_id>& robots) {
  avo_team_def def = avo_default_team_def();
  std::visit([&](const auto& task) { set_task(task, def); }, team.task);
  for (const avo::TeamMember& member : team.members) robots.push_back(to_c(member.robot));
  def.robots = robots.data(), def.robot_count = robots.size();
  return def;
}

}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_team_def avo_default_team_def(void) {
  avo_team_def def{};
  def.size = sizeof def;
  def.service = std::numeric_limits<double>::quiet_NaN();
  return def;
}

avo_result avo_formation_slots(avo_formation formation, size_t count, double spacing,
                               avo_vec2 center, double heading, avo_vec2* slots) {
  return guarded([&] {
    if (formation < AVO_FORMATION_LINE || formation > AVO_FORMATION_RING)
      fail(AVO_ERROR_INVALID_VALUE,
           "formation: found " + std::to_string(formation) + ", must be 0 to 4");
    if (!std::isfinite(heading))
      fail(AVO_ERROR_INVALID_VALUE, "heading: found no finite number, must be one");
    require_array(slots, count, "slots");
    const std::vector<avo::Vec2> made =
        avo::formation_slots(static_cast<avo::Formation>(formation), count, spacing);
    for (const avo::Vec2 slot : avo::place_slots(made, from_c(center), heading))
      *slots++ = to_c(slot);
  });
}

avo_result avo_place_slots(const avo_vec2* slots, size_t count, avo_vec2 center, double heading,
                           avo_vec2* placed) {
  return guarded([&] {
    require_array(placed, count, "placed");
    for (const avo::Vec2 slot :
         avo::place_slots(points_of(slots, count, "slots"), from_c(center), heading))
      *placed++ = to_c(slot);
  });
}

avo_result avo_assign_slots(const avo_vec2* positions, size_t count, const avo_vec2* slots,
                            size_t slot_count, size_t* chosen) {
  return guarded([&] {
    require_array(chosen, count, "chosen");
    for (const std::size_t slot : avo::assign_slots(points_of(positions, count, "positions"),
                                                    points_of(slots, slot_count, "slots")))
      *chosen++ = slot;
  });
}

avo_result avo_simulation_form_up(avo_simulation_id simulation, const avo_robot_id* robots,
                                  size_t count, const avo_vec2* slots, size_t slot_count) {
  return guarded([&] {
    for (std::size_t k = 0; k < count; ++k)
      static_cast<void>(present(simulations.at(simulation).simulation, robots[k]));
    change_by_team(simulation, [&](avo::Simulation& own) {
      avo::form_up(own, ids_of(robots, count), points_of(slots, slot_count, "slots"));
    });
  });
}

avo_result avo_create_team(const avo_team_def* def, avo_team_id* team) {
  return guarded([&] {
    avo_team_id& id = at(team, "team");
    auto made = std::make_unique<TeamOfAny>();
    made->own = team_of(read(def, {"def"}, avo_default_team_def()), {"def"});
    avo::validate(made->own.task);
    id = teams.add(std::move(made));
  });
}

avo_result avo_destroy_team(avo_team_id team) {
  return guarded([&] { teams.take(team); });
}

bool avo_team_is_valid(avo_team_id team) {
  return teams.find(team) != nullptr;
}

avo_result avo_simulation_team_count(avo_simulation_id simulation, size_t* count) {
  return guarded(
      [&] { at(count, "count") = simulations.at(simulation).simulation.teams().size(); });
}

avo_result avo_simulation_team(avo_simulation_id simulation, size_t number, avo_team_id* team) {
  return guarded([&] {
    avo_team_id& id = at(team, "team");
    const std::size_t count = simulations.at(simulation).simulation.teams().size();
    if (number >= count)
      fail(AVO_ERROR_INVALID_VALUE, "number: found " + std::to_string(number) +
                                        ", must be less than " + std::to_string(count) +
                                        ", the teams that it leads");
    auto made = std::make_unique<TeamOfAny>();
    made->leads = simulation, made->number = number;
    id = teams.add(std::move(made));
  });
}

avo_result avo_team_get_task(avo_team_id team, avo_team_def* task) {
  return guarded([&] {
    avo_team_def& def = at(task, "task");
    def = avo_default_team_def();
    std::visit([&](const auto& own) { set_task(own, def); }, team_at(team).task);
  });
}

avo_result avo_team_set_task(avo_team_id team, avo_simulation_id simulation,
                             const avo_team_def* task) {
  return guarded([&] {
    avo::Team& own = team_at(team, simulation);
    const avo_team_def def = read(task, {"task"}, avo_default_team_def());
    change_by_team(simulation,
                   [&](avo::Simulation& led) { avo::set_task(led, own, task_of(def, {"task"})); });
  });
}

avo_result avo_team_lead(avo_team_id team, avo_simulation_id simulation) {
  return guarded([&] {
    avo::Team& own = team_at(team, simulation);
    change_by_team(simulation, [&](avo::Simulation& led) { avo::lead(led, own); });
  });
}

avo_result avo_team_serve(avo_team_id team, avo_simulation_id simulation, avo_robot_id* robot) {
  return guarded([&] {
    avo::Team& own = team_at(team, simulation);
    avo_robot_id& served = at(robot, "robot");
    change_by_team(simulation, [&](avo::Simulation& led) {
      const std::optional<avo::RobotId> first = avo::serve(led, own);
      served = first ? to_c(*first) : avo_robot_id{0};
    });
  });
}

avo_result avo_team_disband(avo_team_id team, avo_simulation_id simulation) {
  return guarded([&] {
    avo::Team& own = team_at(team, simulation);
    change_by_team(simulation, [&](avo::Simulation& led) { avo::disband(led, own); });
  });
}

avo_result avo_team_add(avo_team_id team, avo_robot_id robot) {
  return guarded([&] {
    std::vector<avo::TeamMember>& members = team_at(team).members;
    const avo::RobotId id = ids_of(&robot, 1).front();
    const auto is_it = [&](const avo::TeamMember& member) { return member.robot == id; };
    if (std::any_of(members.begin(), members.end(), is_it))
      fail(AVO_ERROR_INVALID_VALUE, "robot: found " + std::to_string(robot.value) +
                                        ", which is in the team, must be another one");
    members.push_back({id});
  });
}

avo_result avo_team_remove(avo_team_id team, avo_robot_id robot) {
  return guarded([&] {
    const avo::RobotId id = ids_of(&robot, 1).front();
    if (std::erase_if(team_at(team).members,
                      [&](const avo::TeamMember& member) { return member.robot == id; }) == 0)
      fail(AVO_ERROR_INVALID_ID,
           "robot: found " + std::to_string(robot.value) + ", must be one of the team");
  });
}

avo_result avo_team_robots(avo_team_id team, avo_robot_id* buffer, size_t capacity, size_t* count) {
  return guarded([&] {
    const avo::Team& own = team_at(team);
    at(count, "count") = own.members.size();
    if (buffer == nullptr) return;
    require_room(capacity, own.members.size());
    for (const avo::TeamMember& member : own.members) *buffer++ = to_c(member.robot);
  });
}
