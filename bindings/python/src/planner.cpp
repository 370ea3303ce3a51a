// SPDX-License-Identifier: Apache-2.0
// The decision of one robot.
#include <fmt/format.h>
#include <pybind11/operators.h>
#include <tuple>

#include "bind.h"
#include "core/removed.h"
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

/// Refuses options that there are not, those of earlier versions by what replaces them.
void refuse_others(const py::kwargs& others) {
  for (const auto& [key, value] : others) {
    const std::string name = key.cast<std::string>();
    if (const avo::Removed* gone = avo::removed_key(name))
      throw avo::Error(name + ": found the removed option, must be " + allowed_instead(*gone));
    throw py::type_error("Planner: found the unknown option " + name);
  }
}

/// Returns a planner; omitted options get the method's default values.
Planner make(avo::Method method, avo::Motion motion, std::optional<double> control_time,
             std::optional<double> time_horizon, double time_step,
             std::optional<avo::Certificate> certificate, std::optional<int> max_neighbors,
             std::pair<double, double> sensing_error,
             std::tuple<double, double, double> sensing_noise, avo::Clock clock,
             double longest_step, double arrival_distance, double localization_error,
             std::optional<double> response_time, std::optional<double> comfort_acceleration,
             std::optional<double> comfort_jerk, double margin, double wall_range,
             bool never_swerves, const py::kwargs& others) {
  refuse_others(others);
  avo::PlannerOptions options = avo::default_options(method);
  options.motion = motion;
  options.control_time = control_time.value_or(options.control_time);
  options.time_horizon = time_horizon.value_or(options.time_horizon);
  options.time_step = time_step;
  options.certificate = certificate.value_or(options.certificate);
  options.max_neighbors = max_neighbors;
  options.sensing_error = {sensing_error.first, sensing_error.second};
  const auto [position, velocity, quantile] = sensing_noise;
  options.sensing_noise = {position, velocity, quantile};
  options.clock = clock;
  options.longest_step = longest_step;
  options.arrival_distance = arrival_distance;
  options.localization_error = localization_error;
  options.response_time = response_time.value_or(options.response_time);
  options.comfort_acceleration = comfort_acceleration;
  options.comfort_jerk = comfort_jerk;
  options.margin = margin;
  options.wall_range = wall_range;
  options.never_swerves = never_swerves;
  return Planner(options);
}

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
      .def_readonly("velocity", &Evasion::velocity,
                    "(x, y), m/s, that the way approaches, or holds; 0: it brakes from the start; "
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

void bind_options(py::class_<Planner>& planner) {
  planner.def(
      py::init(&make), py::kw_only(), arg("method") = "avo", arg("motion") = "held",
      arg("control_time") = py::none(), arg("time_horizon") = py::none(), arg("time_step") = 0.1,
      arg("certificate") = py::none(), arg("max_neighbors") = py::none(),
      arg("sensing_error") = std::pair(0.0, 0.0), arg("sensing_noise") = std::tuple(0.0, 0.0, 1.0),
      arg("clock") = "common", arg("longest_step") = 0.0, arg("arrival_distance") = 0.5,
      arg("localization_error") = 0.0, arg("response_time") = py::none(),
      arg("comfort_acceleration") = py::none(), arg("comfort_jerk") = py::none(),
      arg("margin") = 0.0, arg("wall_range") = 0.0, arg("never_swerves") = false,
      "method: as in scene files, \"avo\", \"avo_paper\", \"velocity_obstacle\", \"orca\", "
      "\"orca_clamped\", \"reciprocal_velocity_obstacle\" or \"buffered_voronoi\"; motion: "
      "\"held\" or "
      "\"exponential\"; control_time, time_horizon: s, > 0, and certificate: \"none\" "
      "or \"braking_trajectories\", None: customary for the method; "
      "time_step: s, > 0; max_neighbors: >= 1, None: all; sensing_error: "
      "(m, m/s); sensing_noise: (m, m/s, standard deviations); clock: \"common\" or \"free\"; "
      "longest_step: s; arrival_distance: m, > 0; localization_error: m, >= 0, of the robot's own "
      "place among the walls; response_time: >= 0, of max_speed/max_acceleration, None: customary "
      "for the method; comfort_acceleration: m/s^2, > 0, and comfort_jerk: m/s^3, > 0, None: no "
      "limit of its own; margin: m, >= 0, that is wished for beyond the radius; wall_range: m, "
      ">= 0, from the robot's disc, within which all walls are given; never_swerves: movers touch "
      "the robot at rest only, always. Raises Error on options out of range.");
  const auto option = [&planner](const char* name, auto member, const char* doc) {
    planner.def_property_readonly(
        name, [member](const Planner& self) { return self.options().*member; }, doc);
  };
  using Options = avo::PlannerOptions;
  option("method", &Options::method, "how new velocities are chosen, as in scene files");
  option("motion", &Options::motion, "\"held\" or \"exponential\"");
  option("control_time", &Options::control_time,
         "[delta] s; time_step where v' is reached within a step");
  option("time_horizon", &Options::time_horizon, "[tau] s");
  option("time_step", &Options::time_step, "[Delta t] s");
  option("certificate", &Options::certificate, "\"none\" or \"braking_trajectories\"");
  option("max_neighbors", &Options::max_neighbors, "nearest ones that get a half-plane; None: all");
  option("clock", &Options::clock, "\"common\" or \"free\"");
  option("longest_step", &Options::longest_step, "s, of all robots, where the clock is free");
  option("arrival_distance", &Options::arrival_distance, "m, of the goal");
  option("localization_error", &Options::localization_error,
         "m: how far the robot may be from where it takes itself to be among the walls");
  option("response_time", &Options::response_time,
         "of max_speed/max_acceleration: with which v' is approached; 0: at once");
  option("comfort_acceleration", &Options::comfort_acceleration,
         "m/s^2, what is used of max_acceleration without need; None: all");
  option("comfort_jerk", &Options::comfort_jerk,
         "m/s^3, by which the acceleration changes without need; None: as response_time has it");
  option("margin", &Options::margin, "m, clearance that is wished for beyond the radius");
  option("wall_range", &Options::wall_range,
         "m, from the robot's disc, within which all walls are given");
  option("never_swerves", &Options::never_swerves,
         "whether movers touch the robot at rest only, also where braking comes too late");
  planner.def(
      "response_time_of",
      [](const Planner& self, double max_speed, double max_acceleration) {
        return avo::response_time_of(self.options(), max_speed, max_acceleration);
      },
      arg("max_speed"), arg("max_acceleration"),
      "s: the time constant with which a robot of these limits approaches v'; 0: at once.");
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
           "Whether the robot can go on without contact, as far as that is proved.");
}

}  // namespace avo_python
