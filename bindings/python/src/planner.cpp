// SPDX-License-Identifier: Apache-2.0
// The decision of one robot.
#include <fmt/format.h>
#include <pybind11/operators.h>

#include "bind.h"
#include "renamed.h"
#include "workspace.h"

namespace avo_python {

using avo::Planner;
using py::arg;

avo::PlanWorkspace& workspace() {
  thread_local avo::PlanWorkspace one;
  return one;
}

namespace {

avo::Plan plan(const Planner& planner, const avo::Robot& robot,
               const std::vector<avo::Neighbor>& neighbors, const std::vector<avo::Wall>& walls,
               avo::Detour* detour) {
  return planner.plan(robot, neighbors, workspace(), detour, walls);
}

// Robots are taken by value: another thread may change the caller's robots while Python's lock is
// released.
avo::Plan plan_among_movers(const Planner& planner, const avo::Robot robot,
                            const std::vector<avo::Neighbor>& movers) {
  const py::gil_scoped_release release;
  return planner.plan_among_movers(robot, movers, workspace());
}

avo::SafetyReport state(const Planner& planner, const avo::Robot robot,
                        const std::vector<avo::Neighbor>& neighbors,
                        const std::vector<avo::Wall>& walls) {
  const py::gil_scoped_release release;
  return planner.state(robot, neighbors, workspace(), walls);
}

std::optional<avo::Evasion> evasion(const Planner& planner, const avo::Robot& robot,
                                    const std::vector<avo::Neighbor>& neighbors,
                                    const std::vector<avo::Wall>& walls,
                                    const avo::Detour* detour) {
  return planner.evasion(robot, neighbors, workspace(), detour, walls);
}

bool has_evasive_maneuver(const Planner& planner, const avo::Robot robot,
                          const std::vector<avo::Neighbor>& neighbors,
                          const std::vector<avo::Wall>& walls) {
  const py::gil_scoped_release release;
  return planner.has_evasive_maneuver(robot, neighbors, workspace(), walls);
}

void bind_results(py::module_& module) {
  using avo::Plan;
  py::class_<Plan>(module, "Plan", "A decision.")
      .def_readonly("new_velocity", &Plan::new_velocity, "v', m/s, Eqs. (14), (23)")
      .def_readonly("next_velocity", &Plan::next_velocity, "m/s, at the end of the step")
      .def_readonly("acceleration", &Plan::acceleration, "m/s^2, at the start of the step")
      .def_readonly("status", &Plan::status, "how it was made, one of PLAN_STATUS")
      .def_readonly("state", &Plan::state, "in which it was made, one of SAFETY_STATE")
      .def_readonly(
          "evading", &Plan::evading,
          "whether what would have been chosen was put aside: Planner.evasion() says more")
      .def_readonly("neighbor", &Plan::neighbor,
                    "if overlapping, the deepest neighbor's position in the list, or -1")
      .def_readonly("wall", &Plan::wall, "or the wall's position in the list; -1: none")
      .def_readonly("depth", &Plan::depth, "m: if overlapping, by how much")
      .def_readonly("violation", &Plan::violation, "m/s, 0 if optimal")
      .def("__repr__", [](const Plan& plan) {
        return fmt::format("<avo.Plan {}: acceleration ({:.6g}, {:.6g}) m/s^2>",
                           avo::to_string(plan.status), plan.acceleration.x, plan.acceleration.y);
      });
  using avo::Evasion;
  py::class_<Evasion>(module, "Evasion", "An evasive maneuver that is taken.")
      .def_readonly("neighbor", &Evasion::neighbor,
                    "position in the list of the neighbor that the robot evades")
      .def_readonly(
          "velocity", &Evasion::velocity,
          "(x, y), m/s, that the maneuver approaches, or holds; 0: it brakes from the start; "
          "of an airplane where it begins to circle")
      .def_readonly("duration", &Evasion::duration,
                    "s, from the decision, after which it brakes or circles");
  using avo::SafetyReport;
  py::class_<SafetyReport>(module, "SafetyReport", "What is proved of a state.")
      .def_readonly("state", &SafetyReport::state, "one of SAFETY_STATE")
      .def_readonly("neighbor", &SafetyReport::neighbor,
                    "position in the list of the neighbor that it touches first if doomed, most "
                    "deeply if unknown; or -1")
      .def_readonly("wall", &SafetyReport::wall, "or the wall's position in the list; -1: none")
      .def_readonly("time", &SafetyReport::time, "s: if doomed, when the two are in contact")
      .def_readonly("depth", &SafetyReport::depth,
                    "m, >= 0: by how much the two overlap, or come to while all fall back");
}

}  // namespace

void bind_planner(py::module_& module) {
  bind_results(module);
  py::class_<Planner> planner(module, "Planner",
                              "Decides for one robot. Cannot be changed; threads may share it.");
  bind_options(planner);
  refuse_renamed(planner, {{"plan_among_obstacles", "plan_among_movers"},
                           {"has_way_out", "has_evasive_maneuver"}});
  planner
      .def("plan", &plan, arg("robot"), arg("neighbors") = py::tuple(), arg("walls") = py::tuple(),
           arg("detour") = py::none(),
           "One decision of a Robot. neighbors: Neighbors, in any order; walls: Walls near the "
           "robot; detour: what it remembers, updated, None: nothing. Bad numbers are the status "
           "\"invalid_input\".")
      .def(
          "braking_pose",
          [](const Planner& self, const avo::Robot& robot) {
            const avo::BrakingPose pose = self.braking_pose(robot);
            return std::pair(pose.ahead, pose.spread);
          },
          arg("robot"),
          "(ahead, spread) of a Robot with a footprint: what others have to know, see Neighbor.")
      .def("plan_among_movers", &plan_among_movers, arg("robot"), arg("movers"),
           "One robot among movers that do not react (paper III-C).")
      .def("evasion", &evasion, arg("robot"), arg("neighbors") = py::tuple(),
           arg("walls") = py::tuple(), arg("detour") = py::none(),
           "What plan() says with `evading`: an Evasion, the neighbor that the robot evades and "
           "how; None where it does not. detour is not updated.")
      .def("has_evasive_maneuver", &has_evasive_maneuver, arg("robot"),
           arg("neighbors") = py::tuple(), arg("walls") = py::tuple(),
           "Whether some evasive maneuver is clear of all neighbors that do not decide, as far as "
           "they keep to what is known of them.")
      .def("state", &state, arg("robot"), arg("neighbors") = py::tuple(),
           arg("walls") = py::tuple(),
           "Whether the robot can go on without contact, as far as that is proved.")
      .def(
          "response_time_of",
          [](const Planner& self, double max_speed, double max_acceleration) {
            return avo::response_time_of(self.options(), max_speed, max_acceleration);
          },
          arg("max_speed"), arg("max_acceleration"),
          "s: the time constant with which a robot of these limits approaches v'; 0: at once.");
}

}  // namespace avo_python
