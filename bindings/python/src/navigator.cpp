// SPDX-License-Identifier: Apache-2.0
// One robot on board.
#include <fmt/format.h>
#include <pybind11/operators.h>
#include <utility>

#include "bind.h"
#include "pickles.h"
#include "renamed.h"

namespace avo_python {

using avo::Navigator;
using avo::NavigatorDecision;
using py::arg;

namespace {

Navigator make_navigator(const avo::Planner* planner,
                         const std::vector<avo::StaticObstacle>& obstacles,
                         std::optional<double> preferred_speed, std::uint64_t id,
                         avo::LayerSet layers, bool navigation, avo::RightOfWay right_of_way,
                         std::vector<double> fleet_radii, std::optional<double> xy_goal_tolerance,
                         double yaw_goal_tolerance, double required_movement_radius,
                         double movement_time_allowance, std::optional<double> route_tolerance,
                         std::optional<avo::ExecutionModel> execution) {
  avo::NavigatorOptions options;
  if (planner != nullptr) options.planner = planner->options();
  options.preferred_speed = preferred_speed;
  options.id = {id};
  options.layers = layers;
  options.navigation = navigation;
  options.right_of_way = right_of_way;
  options.fleet_radii = std::move(fleet_radii);
  options.xy_goal_tolerance = xy_goal_tolerance;
  options.yaw_goal_tolerance = yaw_goal_tolerance;
  options.required_movement_radius = required_movement_radius;
  options.movement_time_allowance = movement_time_allowance;
  options.route_tolerance = route_tolerance;
  options.execution = execution;
  return Navigator(options, obstacles);
}

void bind_decision(py::module_& module) {
  using avo::NavigatorWait;
  py::class_<NavigatorWait>(module, "NavigatorWait",
                            "For whom a robot on board waits at a passage of one lane.")
      .def_readonly("passage", &NavigatorWait::passage, "(x, y), m, the middle of its axis")
      .def_readonly("neighbor", &NavigatorWait::neighbor,
                    "position in the list of the neighbors given")
      .def_readonly("inside", &NavigatorWait::inside, "whether that neighbor is in the passage")
      .def_readonly("a", &NavigatorWait::a, "(x, y), m, one side where it is narrowest")
      .def_readonly("b", &NavigatorWait::b, "(x, y), m, the other side");
  py::class_<NavigatorDecision> decision(module, "NavigatorDecision",
                                         "One decision of a Navigator.");
  decision.def_readonly("plan", &NavigatorDecision::plan, "Plan, for the base")
      .def_property_readonly(
          "status", [](const NavigatorDecision& self) { return avo::to_string(self.status); },
          "\"idle\", \"under_way\", \"waiting\", \"reached\", \"stuck\" or \"unreachable\"")
      .def_property_readonly(
          "guide", [](const NavigatorDecision& self) { return avo::to_string(self.guide); },
          "what the preferred velocity leads to, as in explanations")
      .def_readonly("preferred_velocity", &NavigatorDecision::preferred_velocity, "(x, y), m/s")
      .def_readonly("route_left", &NavigatorDecision::route_left, "m, of the route")
      .def_readonly("distance_left", &NavigatorDecision::distance_left,
                    "m, from the end of the route to the goal")
      .def_readonly("stopping_distance", &NavigatorDecision::stopping_distance,
                    "m, that it needs to brake from its present velocity")
      .def_readonly("without_progress", &NavigatorDecision::without_progress, "s")
      .def_readonly("wait", &NavigatorDecision::wait, "NavigatorWait at a passage, or None")
      .def_readonly("command", &NavigatorDecision::command,
                    "BaseCommand to send in place of the plan, where execution is set; or None")
      .def("__repr__", [](const NavigatorDecision& self) {
        return fmt::format("<avo.NavigatorDecision {}: {:.6g} m left>", avo::to_string(self.status),
                           self.route_left);
      });
  refuse_renamed(decision, {{"waits_for", "wait, whose neighbor is the same"}});
}

void bind_execution_model(py::module_& module) {
  using avo::ExecutionModel;
  py::class_<ExecutionModel>(module, "ExecutionModel",
                             "How a base executes velocity commands: T dv/dt = w(t - d) + e - v. "
                             "Each coordinate is executed by itself.")
      .def(py::init([](double time_constant, double time_constant_error, double dead_time,
                       double dead_time_error, double deadband, double quantum,
                       double velocity_error, double heading_age, double measured_position_error,
                       double measured_velocity_error) {
             return ExecutionModel{time_constant,
                                   time_constant_error,
                                   dead_time,
                                   dead_time_error,
                                   deadband,
                                   quantum,
                                   velocity_error,
                                   heading_age,
                                   measured_position_error,
                                   measured_velocity_error};
           }),
           py::kw_only(), arg("time_constant") = 0.0, arg("time_constant_error") = 0.0,
           arg("dead_time") = 0.0, arg("dead_time_error") = 0.0, arg("deadband") = 0.0,
           arg("quantum") = 0.0, arg("velocity_error") = 0.0, arg("heading_age") = 0.0,
           arg("measured_position_error") = 0.0, arg("measured_velocity_error") = 0.0)
      .def(pickled<ExecutionModel>())
      .def(py::self == py::self)
      .def_readonly("time_constant", &ExecutionModel::time_constant, "[T] s, of the lag")
      .def_readonly("time_constant_error", &ExecutionModel::time_constant_error, "s, 0 to T")
      .def_readonly("dead_time", &ExecutionModel::dead_time, "[d] s, from command to effect")
      .def_readonly("dead_time_error", &ExecutionModel::dead_time_error, "s, 0 to d")
      .def_readonly("deadband", &ExecutionModel::deadband,
                    "m/s: the base executes a slower coordinate as 0")
      .def_readonly("quantum", &ExecutionModel::quantum,
                    "m/s: coordinates are whole multiples; 0: any")
      .def_readonly("velocity_error", &ExecutionModel::velocity_error, "[e] m/s: slip, scale")
      .def_readonly("heading_age", &ExecutionModel::heading_age,
                    "s, of the heading of drive_command() while the wheels execute it")
      .def_readonly("measured_position_error", &ExecutionModel::measured_position_error,
                    "m, of the body")
      .def_readonly("measured_velocity_error", &ExecutionModel::measured_velocity_error,
                    "m/s, of the body");
}

void bind_execution(py::module_& module) {
  using avo::BaseCommand, avo::ExecutionError, avo::ExecutionModel, avo::ReferenceTracker;
  bind_execution_model(module);
  py::class_<ExecutionError>(module, "ExecutionError",
                             "How far a base is from its reference at most.")
      .def_readonly("position", &ExecutionError::position, "m: the robot's disc is larger by this")
      .def_readonly("velocity", &ExecutionError::velocity,
                    "m/s: others that sense the base add both to their sensing_error")
      .def_readonly("command", &ExecutionError::command,
                    "m/s: the base, or each wheel, must accept commands of this speed");
  py::class_<BaseCommand>(module, "BaseCommand", "What a base is told for the next time_step.")
      .def_readonly("velocity", &BaseCommand::velocity,
                    "(x, y), m/s: a differential drive gets drive_command() of it")
      .def_readonly("next_reference", &BaseCommand::next_reference,
                    "(x, y), m, where the reference is at the next decision")
      .def_readonly("next_velocity", &BaseCommand::next_velocity, "(x, y), m/s, its velocity then")
      .def_readonly("deviation", &BaseCommand::deviation, "m, of the body from the reference")
      .def_readonly("has_left", &BaseCommand::has_left,
                    "whether that was more than the bound: the reference begins anew at the body");
  py::class_<ReferenceTracker>(module, "ReferenceTracker",
                               "Keeps the reference of one robot beside Planner.plan, and makes "
                               "its base follow the reference.")
      .def(py::init([](const ExecutionModel& model, const avo::Planner& planner) {
             return ReferenceTracker(model, planner);
           }),
           arg("model"), arg("planner"))
      .def("reference", &ReferenceTracker::reference, arg("body"),
           "The Robot to plan for in place of the body.")
      .def("follow", &ReferenceTracker::follow, arg("body"), arg("plan"),
           "The BaseCommand for the Plan of reference(body): once every time_step.")
      .def("forget", &ReferenceTracker::forget, "The reference begins anew at the body.")
      .def("error", &ReferenceTracker::error, arg("body"),
           "ExecutionError, for the largest limits that the robot has had so far.");
  module.def("execution_error", &avo::execution_error, arg("model"), arg("robot"), arg("time_step"),
             "The ExecutionError of a Robot of these limits.");
  module.def(
      "drive_command",
      [](const avo::ExecutionModel& model, const avo::Robot& body, avo::Vec2 velocity) {
        const avo::DriveCommand command = avo::drive_command(model, body, velocity);
        return std::pair(command.speed, command.turning_rate);
      },
      arg("model"), arg("body"), arg("velocity"),
      "(m/s, rad/s) of a differential drive: at each cycle of the wheels' controller.");
}

void bind_missions(py::class_<Navigator>& navigator) {
  navigator
      .def("set_goal", &Navigator::set_goal, arg("goal"), arg("heading") = py::none(),
           arg("is_shared") = false,
           "Sets the goal, (x, y) in m, and the heading, rad, in which a robot with wheels is to "
           "stand there. is_shared: others have the same goal. The present goal changes nothing.")
      .def("set_route", &Navigator::set_route, arg("points"), arg("heading") = py::none(),
           "Follows a route of another planner, (x, y) in m, of two points or more.")
      .def(
          "set_stages",
          [](Navigator& self, const std::vector<std::pair<avo::Vec2, double>>& stages,
             std::optional<double> heading) {
            std::vector<avo::Stage> all;
            for (const auto& [position, wait] : stages) all.push_back({position, wait});
            self.set_stages(std::move(all), heading);
          },
          arg("stages"), arg("heading") = py::none(),
          "Goes by the map from stage to stage. Each is ((x, y), wait): m, and s that the robot "
          "rests there; 0: it passes, inf: until go_on().")
      .def("go_on", &Navigator::go_on, "Ends the wait at a stage.")
      .def("clear_goal", &Navigator::clear_goal, "The robot has no goal any more.")
      .def("set_obstacles", &Navigator::set_obstacles, arg("obstacles"), arg("layers") = py::none(),
           "Another map: a door has closed or opened, or the robot is in other layers now.");
}

NavigatorDecision step_navigator(Navigator& self, const avo::Robot& robot,
                                 const std::vector<avo::Neighbor>& neighbors, double time) {
  return self.step(robot, neighbors, time);
}

double sensing_range_of(const avo::Planner& planner, const avo::Robot& robot,
                        const std::vector<avo::Robot>& others, bool has_map) {
  return avo::sensing_range(planner.options(), robot, others, has_map);
}

}  // namespace

void bind_navigator(py::module_& module) {
  bind_execution(module);
  bind_decision(module);
  py::class_<Navigator> navigator(
      module, "Navigator",
      "Guides one robot on board, as a simulation guides all. Use one per robot and thread.");
  navigator.def(
      py::init(&make_navigator), py::kw_only(), arg("planner") = py::none(),
      arg("obstacles") = py::tuple(), arg("preferred_speed") = py::none(), arg("id") = 0,
      arg("layers") = avo::LayerSet{1}, arg("navigation") = true, arg("right_of_way") = "seen",
      arg("fleet_radii") = py::tuple(), arg("xy_goal_tolerance") = py::none(),
      arg("yaw_goal_tolerance") = 0.25, arg("required_movement_radius") = 0.5,
      arg("movement_time_allowance") = 10.0, arg("route_tolerance") = py::none(),
      arg("execution") = py::none(),
      "planner: a Planner; its options count; None: the usual ones. obstacles: StaticObstacles, "
      "the map. preferred_speed: m/s, None: max_speed; id: its number among the robots; layers: of "
      "the map it heeds the obstacles of these layers; "
      "navigation: routes lead around the map; right_of_way: \"seen\" or \"none\"; fleet_radii: m, "
      "of all robots; xy_goal_tolerance: m, None: arrival_distance; yaw_goal_tolerance: rad; "
      "required_movement_radius: m, within movement_time_allowance: s; route_tolerance: m, None: "
      "0.3 of the radius; execution: an ExecutionModel of the base, None: it executes exactly.");
  bind_missions(navigator);
  navigator
      .def("step", &step_navigator, arg("robot"), arg("neighbors") = py::tuple(), py::kw_only(),
           arg("time"),
           "One cycle, every time_step: a NavigatorDecision. Of the Robot, preferred_velocity and "
           "distance_to_goal are not read. time: s, of any clock that does not go back.")
      .def(
          "explain",
          [](const Navigator& self, const avo::Robot& robot,
             const std::vector<avo::Neighbor>& neighbors) {
            return self.explain(robot, neighbors).sentence;
          },
          arg("robot"), arg("neighbors") = py::tuple(),
          "Why it would decide as it would now, in words. Neighbors are named by their positions "
          "in the list.")
      .def("route", &Navigator::route, "Corners of the route that is left, to its end, m.")
      .def_property_readonly(
          "detour", [](const Navigator& self) { return self.detour(); },
          "Detour, what the robot remembers, a copy")
      .def_property_readonly(
          "planner", [](const Navigator& self) { return self.planner(); }, "Planner, a copy");
  module.def("sensing_range", &sensing_range_of, arg("planner"), arg("robot"), arg("others"),
             arg("has_map") = false,
             "m, between centers: how far a Robot with that Planner has to sense other Robots.");
  module.def(
      "wall_range",
      [](const avo::Planner& planner, const avo::Robot& robot) {
        return avo::wall_range(planner.options(), robot);
      },
      arg("planner"), arg("robot"),
      "m, from the Robot's position: walls farther off change no decision.");
}

}  // namespace avo_python
