// SPDX-License-Identifier: Apache-2.0
// What a robot of a fleet sees, and decides from.
#include <memory>

#include "avo/planner.h"
#include "simulation.h"

namespace avo_python {
namespace {

using avo::Simulation;
using py::arg;
using Perception = Simulation::Perception;

// Returns the neighbors; each keeps its trajectory alive.
py::list neighbors_of(const Perception& seen) {
  py::list list;
  auto next = seen.trajectories.begin();
  for (const avo::Neighbor& neighbor : seen.neighbors) {
    const py::object copy = py::cast(neighbor);
    if (neighbor.trajectory != nullptr)
      copy.attr("trajectory") = py::cast(std::const_pointer_cast<avo::Trajectory>(*next++));
    list.append(copy);
  }
  return list;
}

}  // namespace

void bind_perception(py::module_& module, SimulationClass& simulation) {
  py::class_<Perception>(module, "Perception", "What a robot sees, and decides from.")
      .def_readonly("robot", &Perception::robot, "Robot, as it senses itself")
      .def_property_readonly("neighbors", &neighbors_of, "list of Neighbor, a copy")
      .def_readonly("source", &Perception::source,
                    "their ids, or -1 - k of the moving obstacle with id k")
      .def_readonly("detour", &Perception::detour, "Detour, what it remembers")
      .def_readonly("among_movers", &Perception::among_movers,
                    "whether it plans as among obstacles that do not react")
      .def_readonly("walls", &Perception::walls, "list of Wall, a copy")
      .def_readonly("wall_source", &Perception::wall_source,
                    "Of each wall, the id of its static obstacle, or -1 - k for the disc of parked "
                    "robot k.")
      .def_readonly(
          "stop", &Perception::stop,
          "Plan of a robot that brakes until it stands, near a goal that others share: its "
          "decision, whatever it would plan; else None")
      .def_readonly("wait", &Perception::wait, "Wait at a passage, or None")
      .def_property_readonly(
          "guide", [](const Perception& seen) { return avo::to_string(seen.guide); },
          "what its preferred velocity leads to, as in explanations");
  simulation
      .def(
          "perceive",
          [](SharedSimulation& self, std::int64_t id) {
            return self.alone([&](const Simulation& s) { return s.perceive(robot_id(id)); });
          },
          arg("id"), "What the robot would see now.")
      .def(
          "planner",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.planner(robot_id(id)); });
          },
          arg("id"), "The Planner of the robot.");
}

}  // namespace avo_python
