// SPDX-License-Identifier: Apache-2.0
// Robots: what a robot knows of itself, what it senses of its neighbors, and what it remembers. All
// of these are plain, mutable data.
#include <memory>
#include <tuple>
#include <vector>

#include "pickles.h"

namespace avo_python {
namespace {

using py::arg;

void bind_robot(py::module_& module) {
  using avo::Robot;
  py::class_<Robot>(module, "Robot", "The robot that decides.")
      .def(pickled<Robot>())
      .def(
          py::init([](avo::Vec2 position, avo::Vec2 velocity, avo::Vec2 preferred_velocity,
                      double radius, double max_acceleration, double max_speed,
                      double distance_to_goal, avo::MotionModel model, double heading,
                      double priority, std::optional<double> max_braking,
                      std::optional<avo::LoiterCircle> loiter, double lookahead) {
            return Robot{position,         velocity,  preferred_velocity, radius,
                         max_acceleration, max_speed, distance_to_goal,   checked_offset(model),
                         heading,          priority,  max_braking,        loiter,
                         lookahead};
          }),
          py::kw_only(), arg("position"), arg("velocity") = py::make_tuple(0.0, 0.0),
          arg("preferred_velocity") = py::make_tuple(0.0, 0.0), arg("radius") = 0.5,
          arg("max_acceleration") = 1.0, arg("max_speed") = 2.0,
          arg("distance_to_goal") = kInfinity, arg("model") = avo::Holonomic{},
          arg("heading") = 0.0, arg("priority") = 1.0, arg("max_braking") = py::none(),
          arg("loiter") = py::none(), arg("lookahead") = kInfinity,
          "position: (x, y), m, of its disc; velocity, preferred_velocity: m/s; radius: m, > 0; "
          "max_acceleration: m/s^2, > 0; max_speed: m/s, > 0; distance_to_goal: m; model: how it "
          "moves; heading: rad, counter-clockwise from +x; priority: > 0; max_braking: m/s^2, > 0, "
          "None: max_acceleration; loiter: of an airplane; lookahead: m, to where its route turns.")
      .def_readwrite("position", &Robot::position, "[p_A] (x, y), m, the center of its disc")
      .def_readwrite("velocity", &Robot::velocity, "[v_A] (x, y), m/s, of this center")
      .def_readwrite("preferred_velocity", &Robot::preferred_velocity, "[v_A^pref] (x, y), m/s")
      .def_readwrite("radius", &Robot::radius, "[r_A] m, > 0")
      .def_readwrite("max_acceleration", &Robot::max_acceleration, "[a_A^max] m/s^2, > 0")
      .def_readwrite("max_speed", &Robot::max_speed, "[v_A^max] m/s, > 0")
      .def_readwrite("distance_to_goal", &Robot::distance_to_goal,
                     "m left to where it comes to rest; inf: there is no such goal")
      .def_property(
          "model", [](const Robot& robot) { return robot.model; },
          [](Robot& robot, avo::MotionModel model) { robot.model = checked_offset(model); },
          "how it moves: Car, DifferentialDrive, Airplane, or None: holonomic")
      .def_readwrite("heading", &Robot::heading,
                     "[theta] rad, counter-clockwise from +x; read where it is not holonomic")
      .def_readwrite("priority", &Robot::priority,
                     "> 0: of a pair, A takes the part p_B / (p_A + p_B) of what both have to do")
      .def_readwrite("max_braking", &Robot::max_braking,
                     "[b_A] m/s^2, > 0, with which it surely brakes; None: max_acceleration")
      .def_readwrite(
          "loiter", &Robot::loiter,
          "LoiterCircle that the others know of an airplane; None: that of position and velocity")
      .def_readwrite("lookahead", &Robot::lookahead,
                     "m to the point at which preferred_velocity aims, where its route turns; inf: "
                     "there is none nearer than its goal");
}

using TimedTuple = std::tuple<double, double, double>;  // s, m, m

std::vector<TimedTuple> places_of(const avo::Trajectory& trajectory) {
  std::vector<TimedTuple> places;
  for (const auto& [time, position] : trajectory.places())
    places.emplace_back(time, position.x, position.y);
  return places;
}

std::shared_ptr<avo::Trajectory> make_trajectory(const std::vector<TimedTuple>& given, double error,
                                                 std::optional<double> repeats_from) {
  std::vector<avo::TimedPlace> places;
  for (const auto& [time, x, y] : given) places.push_back({time, {x, y}});
  return std::make_shared<avo::Trajectory>(places, error, repeats_from);
}

void bind_trajectory(py::module_& module) {
  using avo::Trajectory;
  py::class_<Trajectory, std::shared_ptr<Trajectory>>(
      module, "Trajectory",
      "Where a mover will be: straight from place to place, at constant speed on each leg. Before "
      "the first place it rests there; behind the last one it keeps its last velocity, or goes "
      "round.")
      .def(py::init(&make_trajectory), arg("places"), py::kw_only(), arg("error") = 0.0,
           arg("repeats_from") = py::none(),
           "places: list of (time, x, y), s and m, by ascending times; error: m, >= 0, by which "
           "it may be off; repeats_from: s, the time of one of the places: behind the last one it "
           "is, at an unknown time, at any place where it was from that time on.")
      .def(py::pickle(
          [](const Trajectory& t) {
            return py::make_tuple(places_of(t), t.error(), t.repeats_from());
          },
          [](const py::tuple& state) {
            if (state.size() != 3)
              throw avo::Error(
                  "pickle: found another number of fields, must be of this version of avo");
            return make_trajectory(state[0].cast<std::vector<TimedTuple>>(),
                                   state[1].cast<double>(), state[2].cast<std::optional<double>>());
          }))
      .def_property_readonly("places", &places_of, "list of (time, x, y), s and m")
      .def_property_readonly("error", &Trajectory::error, "m, by which it may be off")
      .def_property_readonly("repeats_from", &Trajectory::repeats_from,
                             "s, or None: it does not go round")
      .def("at", &Trajectory::at, arg("time"), "(x, y), m: where it is at that time, s.");
}

// The trajectory lives as long as the neighbor. The attributes of the neighbor are copied.
py::tuple reduced(const py::object& neighbor) {
  py::dict fields;
  for (const char* name : {"position",        "velocity",
                           "radius",          "max_acceleration",
                           "behavior",        "age",
                           "priority",        "max_braking",
                           "loiter",          "max_deviation",
                           "position_error",  "acceleration",
                           "max_speed",       "likely_deviation",
                           "parting",         "trajectory",
                           "trajectory_time", "footprint",
                           "ahead",           "spread"})
    fields[name] = neighbor.attr(name);
  const py::object make = py::module_::import("functools").attr("partial");
  return py::make_tuple(make(py::type::of<avo::Neighbor>(), **fields), py::tuple());
}

void bind_neighbor(py::module_& module) {
  using avo::Neighbor;
  py::class_<Neighbor>(module, "Neighbor",
                       "Another robot as a robot senses it, or a moving obstacle.")
      .def("__reduce__", &reduced)
      .def(py::init([](avo::Vec2 position, avo::Vec2 velocity, double radius,
                       double max_acceleration, avo::Behavior behavior, int age, double priority,
                       std::optional<double> max_braking, std::optional<avo::LoiterCircle> loiter,
                       double max_deviation, double position_error, avo::Vec2 acceleration,
                       double max_speed, double likely_deviation, avo::Vec2 parting,
                       const avo::Trajectory* trajectory, double trajectory_time,
                       std::optional<avo::Footprint> footprint, avo::Vec2 ahead, double spread) {
             return Neighbor{position,        velocity,
                             radius,          max_acceleration,
                             behavior,        age,
                             priority,        max_braking,
                             loiter,          max_deviation,
                             position_error,  acceleration,
                             max_speed,       likely_deviation,
                             parting,         trajectory,
                             trajectory_time, footprint.value_or(avo::Footprint{}),
                             ahead,           spread};
           }),
           py::keep_alive<1, 17>(), py::kw_only(), arg("position"),
           arg("velocity") = py::make_tuple(0.0, 0.0), arg("radius") = 0.5,
           arg("max_acceleration") = 1.0, arg("behavior") = "decides", arg("age") = 0,
           arg("priority") = 1.0, arg("max_braking") = py::none(), arg("loiter") = py::none(),
           arg("max_deviation") = 0.0, arg("position_error") = 0.0,
           arg("acceleration") = py::make_tuple(0.0, 0.0), arg("max_speed") = kInfinity,
           arg("likely_deviation") = 0.0, arg("parting") = py::make_tuple(0.0, 0.0),
           arg("trajectory") = py::none(), arg("trajectory_time") = 0.0,
           arg("footprint") = py::none(), arg("ahead") = py::make_tuple(0.0, 0.0),
           arg("spread") = 0.0,
           "position: (x, y), m; velocity: m/s; radius: m, > 0; max_acceleration: m/s^2, > 0; "
           "behavior: \"decides\", \"moves_on\", \"cooperates\" or \"parked\"; age: steps since it "
           "was sensed; "
           "priority: > 0; "
           "max_braking: m/s^2; max_deviation: m/s^2, >= 0; position_error: m, >= 0; acceleration: "
           "m/s^2, and max_speed: m/s, of a neighbor that moves on; likely_deviation: m/s^2, >= 0, "
           "that "
           "ways "
           "out reckon with; parting: see parting_direction(); "
           "trajectory: Trajectory of a neighbor that moves on, None: unknown; trajectory_time: s, "
           "now; "
           "footprint: from its position; ahead, spread: see Planner.braking_pose().")
      .def_readwrite("position", &Neighbor::position, "[p_B] (x, y), m")
      .def_readwrite("velocity", &Neighbor::velocity, "[v_B] (x, y), m/s")
      .def_readwrite("radius", &Neighbor::radius, "[r_B] m, > 0")
      .def_readwrite("max_acceleration", &Neighbor::max_acceleration,
                     "[a_B^max] m/s^2, > 0; read only where it decides")
      .def_readwrite("behavior", &Neighbor::behavior,
                     "\"decides\", \"moves_on\", \"cooperates\" or \"parked\"")
      .def_readwrite("age", &Neighbor::age, "steps, >= 0: how long ago it was last sensed")
      .def_readwrite("priority", &Neighbor::priority, "> 0, see Robot.priority")
      .def_readwrite("max_braking", &Neighbor::max_braking,
                     "[b_B] m/s^2, > 0; None: max_acceleration")
      .def_readwrite("loiter", &Neighbor::loiter, "LoiterCircle of an airplane; None: it can brake")
      .def_readwrite("max_deviation", &Neighbor::max_deviation,
                     "m/s^2, >= 0: of its acceleration, where it does not decide")
      .def_readwrite("position_error", &Neighbor::position_error,
                     "m, >= 0: of its position, besides the declared sensing error")
      .def_readwrite("acceleration", &Neighbor::acceleration, "(x, y), m/s^2, where it moves on")
      .def_readwrite("likely_deviation", &Neighbor::likely_deviation,
                     "m/s^2, >= 0: of its acceleration, where it does not decide; evasive "
                     "maneuvers reckon with it")
      .def_readwrite("max_speed", &Neighbor::max_speed,
                     "m/s, > 0, where it does not decide: that it never exceeds; None: unknown")
      .def_readwrite(
          "parting", &Neighbor::parting,
          "unit (x, y), or 0: for a neighbor that coincides in place and velocity, the direction "
          "in which to leave it")
      .def_property(
          "trajectory", [](const Neighbor& neighbor) { return neighbor.trajectory; },
          py::cpp_function(
              [](Neighbor& neighbor, const avo::Trajectory* trajectory) {
                neighbor.trajectory = trajectory;
              },
              py::keep_alive<1, 2>()),
          "Trajectory of a neighbor that moves on: where it will be; None: unknown")
      .def_readwrite("trajectory_time", &Neighbor::trajectory_time,
                     "s: now, as the trajectory tells the time")
      .def_property(
          "footprint",
          [](const Neighbor& neighbor) {
            return neighbor.footprint ? std::optional(neighbor.footprint) : std::nullopt;
          },
          [](Neighbor& neighbor, std::optional<avo::Footprint> footprint) {
            neighbor.footprint = footprint.value_or(avo::Footprint{});
          },
          "Footprint from its position; None: one disc")
      .def_readwrite("ahead", &Neighbor::ahead, "unit (x, y), along its heading")
      .def_readwrite("spread", &Neighbor::spread,
                     "rad: how far off `ahead` its heading may be while it brakes");
  module.def("parting_direction", &avo::parting_direction, arg("id"), arg("other"),
             "(x, y): the direction in which a robot of the first id leaves one of the other id, "
             "where they coincide; the opposite one if the ids are exchanged, 0 of equal ids.");
}

void bind_detour(py::module_& module) {
  using avo::Detour;
  py::class_<Detour>(module, "Detour",
                     "What a robot remembers; plan() updates it. Method avo only.")
      .def(py::init<>())
      .def(pickled<Detour>())
      .def_readwrite("angle", &Detour::angle, "rad, how far it has turned off its route, right.")
      .def_readwrite("beside", &Detour::beside, "v_max/a_max, 0 to 200.")
      .def_readwrite("congestion", &Detour::congestion, "robots ahead, 0 to 2.8.")
      .def_readwrite("has_arrived", &Detour::has_arrived,
                     "whether it was within arrival_distance of its goal, beside others")
      .def_readwrite(
          "goal_taken", &Detour::goal_taken,
          "whether others are at rest on its goal: it comes to rest near them, and neither "
          "gives way nor makes a detour")
      .def_readwrite("acceleration_x", &Detour::acceleration_x, "m/s^2, of its last step.")
      .def_readwrite("acceleration_y", &Detour::acceleration_y, "m/s^2, of its last step.");
}

}  // namespace

void bind_robots(py::module_& module) {
  bind_robot(module);
  bind_trajectory(module);
  bind_neighbor(module);
  bind_detour(module);
}

}  // namespace avo_python
