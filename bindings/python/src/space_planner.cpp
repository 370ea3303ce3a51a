// SPDX-License-Identifier: Apache-2.0
// The decision of one robot in space.
#include <fmt/format.h>

#include "avo/space/planner.h"
#include "bind.h"

namespace avo_python::space {
namespace {

using avo::space::Planner;
using py::arg;

avo::space::PlanWorkspace& space_workspace() {
  thread_local avo::space::PlanWorkspace one;
  return one;
}

// Robots are taken by value: another thread may change the caller's robot while Python's lock is
// released.
avo::space::Plan plan(const Planner& planner, const avo::space::Robot robot,
                      const std::vector<avo::space::Neighbor>& neighbors,
                      const std::vector<avo::space::Box>& boxes, avo::space::Detour* detour,
                      const std::vector<avo::space::Mover>& movers) {
  return planner.plan(robot, neighbors, space_workspace(), detour, boxes, movers);
}

bool is_admitted(const Planner& planner, const avo::space::Robot robot,
                 const std::vector<avo::space::Neighbor>& neighbors, avo::Vec3 next_velocity,
                 const std::vector<avo::space::Box>& boxes) {
  const py::gil_scoped_release release;
  return planner.is_admitted(robot, neighbors, space_workspace(), next_velocity, boxes);
}

void bind_results(py::module_& space) {
  using avo::space::Detour;
  using avo::space::Plan;
  py::class_<Plan>(space, "Plan", "A decision.")
      .def_readonly("new_velocity", &Plan::new_velocity, "v', (x, y, z), m/s, Eqs. (14), (23)")
      .def_readonly("next_velocity", &Plan::next_velocity, "(x, y, z), m/s, at the end of the step")
      .def_readonly("acceleration", &Plan::acceleration, "m/s^2, at the start of the step")
      .def_readonly("status", &Plan::status, "how it was made, one of PLAN_STATUS")
      .def_readonly("state", &Plan::state, "in which it was made, one of SAFETY_STATE")
      .def_readonly("neighbor", &Plan::neighbor,
                    "if overlapping, the deepest neighbor's position in the list, or -1")
      .def_readonly("box", &Plan::box, "if overlapping, the box's position in the list, or -1")
      .def_readonly("mover", &Plan::mover,
                    "if overlapping, the mover's position in the list, or -1")
      .def_readonly("evading", &Plan::evading,
                    "whether an evasive maneuver has replaced the robot's own choice")
      .def_readonly("depth", &Plan::depth, "m: if overlapping, by how much")
      .def_readonly("violation", &Plan::violation, "m/s, 0 if optimal")
      .def("__repr__", [](const Plan& plan) {
        return fmt::format("<avo.space.Plan {}: acceleration ({:.6g}, {:.6g}, {:.6g}) m/s^2>",
                           avo::to_string(plan.status), plan.acceleration.x, plan.acceleration.y,
                           plan.acceleration.z);
      });
  py::class_<Detour>(space, "Detour", "What a robot remembers; plan() updates it.")
      .def(py::init<>())
      .def_readwrite("angle", &Detour::angle, "rad, how far it has turned off its route, right.")
      .def_readwrite("beside", &Detour::beside, "v_max/a_max, 0 to 200.")
      .def_readwrite("congestion", &Detour::congestion, "robots ahead, 0 to 2.8.")
      .def_readwrite("has_arrived", &Detour::has_arrived,
                     "whether it was within arrival_distance of its goal, beside others")
      .def_readwrite("goal_taken", &Detour::goal_taken, "whether others are at rest on its goal")
      .def_readwrite("acceleration", &Detour::acceleration, "(x, y, z), m/s^2, of its last step");
}

}  // namespace

void bind_planner(py::module_& space) {
  bind_results(space);
  py::class_<Planner>(space, "Planner",
                      "Decides for one robot of space. Cannot be changed; threads may share it.")
      .def(py::init([](const py::kwargs& given) { return Planner(options_of(given)); }),
           "The options of avo.Planner that space has. Raises Error on the others, and on options "
           "out of range.")
      .def("plan", &plan, arg("robot"), arg("neighbors") = py::tuple(), arg("boxes") = py::tuple(),
           arg("detour") = py::none(), arg("movers") = py::tuple(),
           "One decision of a Robot. neighbors: Neighbors, in any order; boxes: those within "
           "box_range(), and beside movers within wall_range; detour: what it remembers, updated, "
           "None: nothing; movers: Movers, the moving obstacles. Bad numbers are the status "
           "\"invalid_input\".")
      .def(
          "is_admitted", &is_admitted, arg("robot"), arg("neighbors"), arg("next_velocity"),
          arg("boxes") = py::tuple(),
          "Whether the certificate lets the robot have that velocity, m/s, at the end of the step.")
      .def(
          "box_range",
          [](const Planner& self, const avo::space::Robot& robot) {
            return avo::space::box_range(robot, self.options());
          },
          arg("robot"), "m, from its ball: boxes at a larger distance change nothing.")
      .def(
          "sensing_range",
          [](const Planner& self, const avo::space::Robot& robot, const avo::space::Robot& other) {
            return avo::space::sensing_range(robot, other, self.options());
          },
          arg("robot"), arg("other"),
          "m, between centers: within it the robot has to sense another one of these limits.")
      .def(
          "sensing_range",
          [](const Planner& self, const avo::space::Robot& robot, const avo::space::Mover& other) {
            return avo::space::sensing_range(robot, other, self.options());
          },
          arg("robot"), arg("other"),
          "The same for a Mover, before which the robot has to come to rest.");
  space.def("evasion_range", &avo::space::evasion_range, arg("robot"),
            "m: how far from its place a robot's evasive maneuvers may lead, the wall_range of a "
            "planner beside moving obstacles.");
}

}  // namespace avo_python::space
