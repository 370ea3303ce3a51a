// SPDX-License-Identifier: Apache-2.0
// Teams, and formations.
#include "avo/teams.h"

#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "arrays.h"
#include "simulation.h"

namespace avo_python {
namespace {

using py::arg;
using Points = std::vector<avo::Vec2>;

/// A team that threads share: the host's own team, or a team that a simulation leads.
struct SharedTeam {
  std::mutex mutex;
  avo::Team own;
  py::object leads = py::none();  // the simulation that leads it
  std::size_t number = 0;         // among its teams

  avo::Team& in(avo::Simulation& simulation) {
    return leads.is_none() ? own : simulation.teams()[number];
  }
};

std::unique_ptr<SharedTeam> make_team(const std::vector<std::int64_t>& robots,
                                      const avo::TeamTask& task) {
  auto made = std::make_unique<SharedTeam>();
  made->own = avo::make_team(robot_ids(robots), task);
  return made;
}

template <typename F>
auto with(SharedTeam& self, SharedSimulation& simulation, F f) {
  if (!self.leads.is_none() && self.leads.cast<SharedSimulation*>() != &simulation)
    throw avo::Error("team: found a team of another simulation, must be of this one");
  return simulation.alone([&](avo::Simulation& s) {
    const std::lock_guard lock(self.mutex);
    return f(s, self.in(s));
  });
}

// The same without a simulation, for what belongs to the team alone.
template <typename F>
auto with(SharedTeam& self, F f) {
  if (!self.leads.is_none())
    return self.leads.cast<SharedSimulation&>().alone(
        [&](avo::Simulation& s) { return f(self.in(s)); });
  const std::lock_guard lock(self.mutex);
  return f(self.own);
}

void add_member(avo::Team& team, avo::RobotId robot) {
  for (const avo::TeamMember& member : team.members)
    if (member.robot == robot)
      throw avo::Error(
          fmt::format("robot {}: found it in the team, must be another one", robot.value));
  team.members.push_back({robot});
}

void remove_member(avo::Team& team, avo::RobotId robot) {
  const auto is_it = [&](const avo::TeamMember& member) { return member.robot == robot; };
  if (std::erase_if(team.members, is_it) == 0)
    throw avo::Error(fmt::format("robot {}: found it elsewhere, must be in the team", robot.value));
}

std::vector<std::uint64_t> ids_of(const avo::Team& team) {
  std::vector<std::uint64_t> ids;
  for (const avo::TeamMember& member : team.members) ids.push_back(member.robot.value);
  return ids;
}

template <typename Task>
Task checked_task(Task task) {
  avo::validate(task);
  return task;
}

py::array_t<double> array_of(const Points& points) {
  auto array = target(std::nullopt, {static_cast<py::ssize_t>(points.size()), 2});
  fill(array, points);
  return array;
}

void bind_tasks(py::module_& module) {
  py::class_<avo::Queue>(module, "Queue", "Robots stand in a row and move up.")
      .def(py::init([](Points line, double spacing, std::optional<double> service) {
             return checked_task(avo::Queue{std::move(line), spacing, service});
           }),
           arg("line"), py::kw_only(), arg("spacing") = avo::Queue{}.spacing,
           arg("service") = py::none(),
           "line: points, m, from the head of the row backward. spacing: m. service: s that the "
           "first one waits at the head before it goes to its own goal; None: until Team.serve().")
      .def_readonly("line", &avo::Queue::line, "m, from the head backward.")
      .def_readonly("spacing", &avo::Queue::spacing, "m, from place to place.")
      .def_readonly("service", &avo::Queue::service, "s at the head; None: until serve().");
  py::class_<avo::Follow>(module, "Follow", "The first robot goes to its goal, others follow it.")
      .def(py::init([](double spacing, Points slots) {
             return checked_task(avo::Follow{spacing, std::move(slots)});
           }),
           py::kw_only(), arg("spacing") = avo::Follow{}.spacing, arg("slots") = Points{},
           "spacing: m between robots on the trail of the first one. slots: places about it, m, x "
           "ahead and y to its left; none: all follow the trail.")
      .def_readonly("spacing", &avo::Follow::spacing, "m, from robot to robot.")
      .def_readonly("slots", &avo::Follow::slots, "m, about the first robot.");
  py::class_<avo::Patrol>(module, "Patrol", "Each robot goes from point to point for ever.")
      .def(py::init([](Points points, double pass_distance) {
             return checked_task(avo::Patrol{std::move(points), pass_distance});
           }),
           arg("points"), py::kw_only(), arg("pass_distance") = avo::Patrol{}.pass_distance,
           "points: m. pass_distance: m, from a point to go on to the next.")
      .def_readonly("points", &avo::Patrol::points, "m, to pass in turn.")
      .def_readonly("pass_distance", &avo::Patrol::pass_distance, "m, from a point to go on.");
  py::class_<avo::Flow>(module, "Flow", "Robots leave by the nearest exit, and are removed there.")
      .def(py::init([](Points exits, double spacing) {
             return checked_task(avo::Flow{std::move(exits), spacing});
           }),
           arg("exits"), py::kw_only(), arg("spacing") = avo::Flow{}.spacing,
           "exits: the two ends of each exit, m. spacing: m between the goals on an exit.")
      .def_readonly("exits", &avo::Flow::exits, "m, the two ends of each exit.")
      .def_readonly("spacing", &avo::Flow::spacing, "m, between goals on an exit.");
}

void bind_team(py::module_& module) {
  py::class_<SharedTeam>(module, "Team", "Robots with one task; a robot is in one team at most.")
      .def(py::init(&make_team), arg("robots"), arg("task"),
           "robots: ids, of Follow the leader first. task: Queue, Follow, Patrol or Flow.")
      .def(
          "lead",
          [](SharedTeam& self, SharedSimulation& simulation) {
            with(self, simulation, [](avo::Simulation& s, avo::Team& team) { lead(s, team); });
          },
          arg("simulation"),
          "Sets goals and preferred velocities for the next step: call it before each step().")
      .def(
          "serve",
          [](SharedTeam& self, SharedSimulation& simulation) {
            const auto robot = with(self, simulation, [](avo::Simulation& s, avo::Team& team) {
              return serve(s, team);
            });
            return robot ? std::optional(robot->value) : std::nullopt;
          },
          arg("simulation"),
          "The first robot of a queue goes to its own goal. Returns its id; None: there is none.")
      .def(
          "disband",
          [](SharedTeam& self, SharedSimulation& simulation) {
            with(self, simulation, [](avo::Simulation& s, avo::Team& team) { disband(s, team); });
          },
          arg("simulation"), "The robots go to their own goals again; the team is empty.")
      .def(
          "add",
          [](SharedTeam& self, std::int64_t robot) {
            with(self, [&](avo::Team& team) { add_member(team, robot_id(robot)); });
          },
          arg("robot"), "The robot joins as the last one.")
      .def(
          "remove",
          [](SharedTeam& self, std::int64_t robot) {
            with(self, [&](avo::Team& team) { remove_member(team, robot_id(robot)); });
          },
          arg("robot"), "The robot leaves. Its goal stays as the team has set it.")
      .def(
          "set_task",
          [](SharedTeam& self, SharedSimulation& simulation, const avo::TeamTask& task) {
            with(self, simulation,
                 [&](avo::Simulation& s, avo::Team& team) { set_task(s, team, task); });
          },
          arg("simulation"), arg("task"),
          "Another task. The robots keep the goals that they had before they joined.")
      .def_property_readonly(
          "task",
          [](SharedTeam& self) { return with(self, [](avo::Team& team) { return team.task; }); },
          "Queue, Follow, Patrol or Flow, a copy.")
      .def_property_readonly(
          "robots",
          [](SharedTeam& self) { return with(self, [](avo::Team& team) { return ids_of(team); }); },
          "Ids, of a queue from its head.");
}

}  // namespace

void bind_teams(py::module_& module) {
  bind_tasks(module);
  bind_team(module);
  module.def(
      "formation_slots",
      [](avo::Formation formation, std::size_t count, double spacing, avo::Vec2 center,
         double heading) {
        return array_of(place_slots(formation_slots(formation, count, spacing), center, heading));
      },
      arg("formation"), arg("count"), arg("spacing"), arg("center") = avo::Vec2{},
      arg("heading") = 0.0,
      "Slots (count, 2), m, about center, that face heading, rad. formation: line, column, wedge, "
      "block or ring. spacing: m between neighboring slots, at least.");
  module.def(
      "place_slots",
      [](const py::object& slots, avo::Vec2 center, double heading) {
        const Numbers given = numbers("slots", slots);
        return array_of(place_slots(rows("slots", given), center, heading));
      },
      arg("slots"), arg("center"), arg("heading"),
      "Slots (n, 2), m, turned by heading, rad, and moved so that their origin is at center.");
  module.def(
      "assign_slots",
      [](const py::object& positions, const py::object& slots) {
        const Numbers from = numbers("positions", positions), to = numbers("slots", slots);
        return avo::assign_slots(rows("positions", from), rows("slots", to));
      },
      arg("positions"), arg("slots"),
      "For each position that of its slot in the list: the sum of the distances is least, and no "
      "two "
      "of the lines cross.");
}

void bind_team_edits(SimulationClass& simulation) {
  simulation.def(
      "teams",
      [](const py::object& self) {
        const std::size_t count = self.cast<SharedSimulation&>().alone(
            [](avo::Simulation& s) { return s.teams().size(); });
        std::vector<std::unique_ptr<SharedTeam>> teams;
        for (std::size_t k = 0; k < count; ++k) {
          auto team = std::make_unique<SharedTeam>();
          team->leads = self, team->number = k;
          teams.push_back(std::move(team));
        }
        return teams;
      },
      "The teams of its scene, a list of Team. Each step leads them: serve a queue, change the "
      "robots or the task.");
  simulation.def(
      "form_up",
      [](SharedSimulation& self, const std::vector<std::int64_t>& robots, const py::object& slots) {
        const Numbers given = numbers("slots", slots);
        const std::span<const avo::Vec2> places = rows("slots", given);
        self.alone([&](avo::Simulation& s) { avo::form_up(s, robot_ids(robots), places); });
      },
      arg("robots"), arg("slots"), "Sends each robot to a slot (n, 2), as assign_slots() says.");
}

}  // namespace avo_python
