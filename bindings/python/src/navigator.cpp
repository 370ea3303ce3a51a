// SPDX-License-Identifier: Apache-2.0
// One robot on board.
#include <fmt/format.h>
#include <utility>

#include "bind.h"

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
                         double movement_time_allowance, std::optional<double> route_tolerance) {
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
  return Navigator(options, obstacles);
}

void bind_decision(py::module_& module) {
  py::class_<NavigatorDecision>(module, "NavigatorDecision", "One decision of a Navigator.")
      .def_readonly("plan", &NavigatorDecision::plan, "Plan, for the base")
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
      .def_property_readonly(
          "waits_for",
          [](const NavigatorDecision& self) {
            return self.wait ? std::optional(self.wait->robot.value) : std::nullopt;
          },
          "index of the neighbor for which it waits at a passage, or None")
      .def("__repr__", [](const NavigatorDecision& self) {
        return fmt::format("<avo.NavigatorDecision {}: {:.6g} m left>", avo::to_string(self.status),
                           self.route_left);
      });
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
      "planner: a Planner, whose options count; None: the usual ones. obstacles: StaticObstacles, "
      "the map. preferred_speed: m/s, None: max_speed; id: its number among the robots; layers: of "
      "the map it heeds the obstacles of these layers; "
      "navigation: routes lead around the map; right_of_way: \"seen\" or \"none\"; fleet_radii: m, "
      "of all robots; xy_goal_tolerance: m, None: arrival_distance; yaw_goal_tolerance: rad; "
      "required_movement_radius: m, within movement_time_allowance: s; route_tolerance: m, None: "
      "0.3 of the radius.");
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
          "Why it would decide as it would now, in words. Neighbors are named by their indices.")
      .def("route", &Navigator::route, "Corners of the route that is left, to its end, m.");
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
