// SPDX-License-Identifier: Apache-2.0
// Where the robots of a fleet go: goals, routes, and for whom they wait.
#include <cstdint>
#include <optional>
#include <vector>

#include "simulation.h"

namespace avo_python {

using avo::Simulation;
using py::arg;

namespace {

void bind_answers(py::module_& module) {
  using Route = Simulation::Route;
  using Wait = Simulation::Wait;
  py::class_<Route>(module, "Route", "The rest of a robot's route.")
      .def_readonly("length", &Route::length, "m; inf for robots that unreachable() names")
      .def_readonly("next", &Route::next,
                    "(x, y), m, its next point, a corner of a wall or its end")
      .def_readonly("distance_left", &Route::distance_left,
                    "m, from its end to the goal; 0 where no wall keeps the robot from its goal");
  py::class_<Wait>(module, "Wait", "For whom a robot waits at a passage of one lane.")
      .def_readonly("passage", &Wait::passage, "(x, y), m, the middle of its axis")
      .def_property_readonly(
          "robot", [](const Wait& wait) { return wait.robot.value; },
          "id of the robot that comes towards it, or stands in its path")
      .def_readonly("inside", &Wait::inside, "whether that robot is in the passage")
      .def_readonly("a", &Wait::a, "(x, y), m, one side of the passage where it is narrowest")
      .def_readonly("b", &Wait::b, "(x, y), m, the other side");
}

}  // namespace

void bind_routes(py::module_& module, SimulationClass& simulation) {
  bind_answers(module);
  simulation
      .def("all_at_goal", told([](const Simulation& s) { return s.all_at_goal(); }),
           "Whether all robots are at their goals, see at_goal().")
      .def(
          "is_at_goal",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.is_at_goal(robot_id(id)); });
          },
          arg("id"), "Whether the robot is at its goal, see at_goal().")
      .def(
          "at_goal",
          [](SharedSimulation& self) {
            const auto at = self.briefly([](const Simulation& s) {
              std::vector<std::uint8_t> all(s.size());
              const auto ids = s.fleet(avo::Columns::id).id;
              for (std::size_t k = 0; k < all.size(); ++k) all[k] = s.is_at_goal(ids[k]) ? 1 : 0;
              return all;
            });
            py::array_t<bool> array(static_cast<py::ssize_t>(at.size()));
            std::copy(at.begin(), at.end(), array.mutable_data());
            return array;
          },
          "(n,) bool: whether it is within arrival_distance, in sight, or rests as near as others "
          "at rest "
          "leave room, where their goals are too close together for all of them.")
      .def(
          "unreachable",
          [](SharedSimulation& self) {
            std::vector<std::uint64_t> ids;
            for (const avo::RobotId id :
                 self.briefly([](const Simulation& s) { return s.unreachable(); }))
              ids.push_back(id.value);
            return ids;
          },
          "Ids of robots that walls keep from their goals: they go as near as they can, and are "
          "distance_left() from there.")
      .def(
          "distance_left",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly(
                [&](const Simulation& s) { return s.route(robot_id(id)).distance_left; });
          },
          arg("id"),
          "m, from the nearest place that the robot can reach to its goal; 0 where no wall keeps "
          "the "
          "robot from its goal.")
      .def(
          "route",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.route(robot_id(id)); });
          },
          arg("id"), "Route, the rest of the route that the robot knows.")
      .def(
          "wait",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.wait(robot_id(id)); });
          },
          arg("id"), "Wait of the robot; None where it waits at no passage.");
}

}  // namespace avo_python
