// SPDX-License-Identifier: Apache-2.0
// Robots: what one knows of itself, what it senses of others, what it remembers, and what a scene
// says of it. Plain data, which can be changed.
#include <limits>

#include "bind.h"

namespace avo_python {
namespace {

using py::arg;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void bind_robot(py::module_& module) {
  using avo::Robot;
  py::class_<Robot>(module, "Robot", "The robot that decides.")
      .def(
          py::init([](avo::Vec2 position, avo::Vec2 velocity, avo::Vec2 preferred_velocity,
                      double radius, double max_acceleration, double max_speed,
                      double distance_to_goal, avo::MotionModel model, double heading,
                      double priority, std::optional<double> max_braking,
                      std::optional<avo::LoiterCircle> loiter) {
            return Robot{position,         velocity,  preferred_velocity, radius,
                         max_acceleration, max_speed, distance_to_goal,   model,
                         heading,          priority,  max_braking,        loiter};
          }),
          py::kw_only(), arg("position"), arg("velocity") = py::make_tuple(0.0, 0.0),
          arg("preferred_velocity") = py::make_tuple(0.0, 0.0), arg("radius") = 0.5,
          arg("max_acceleration") = 1.0, arg("max_speed") = 2.0,
          arg("distance_to_goal") = kInfinity, arg("model") = avo::Holonomic{},
          arg("heading") = 0.0, arg("priority") = 1.0, arg("max_braking") = py::none(),
          arg("loiter") = py::none(),
          "position: (x, y), m, of its disc; velocity, preferred_velocity: m/s; radius: m, > 0; "
          "max_acceleration: m/s^2, > 0; max_speed: m/s, > 0; distance_to_goal: m; model: how it "
          "moves; heading: rad, counter-clockwise from +x; priority: > 0; max_braking: m/s^2, > 0, "
          "None: max_acceleration; loiter: of an airplane.")
      .def_readwrite("position", &Robot::position)
      .def_readwrite("velocity", &Robot::velocity)
      .def_readwrite("preferred_velocity", &Robot::preferred_velocity)
      .def_readwrite("radius", &Robot::radius)
      .def_readwrite("max_acceleration", &Robot::max_acceleration)
      .def_readwrite("max_speed", &Robot::max_speed)
      .def_readwrite("distance_to_goal", &Robot::distance_to_goal)
      .def_readwrite("model", &Robot::model)
      .def_readwrite("heading", &Robot::heading)
      .def_readwrite("priority", &Robot::priority)
      .def_readwrite("max_braking", &Robot::max_braking)
      .def_readwrite("loiter", &Robot::loiter);
}

void bind_neighbor(py::module_& module) {
  using avo::Neighbor;
  py::class_<Neighbor>(module, "Neighbor", "Another robot as it is sensed, or a moving obstacle.")
      .def(py::init([](avo::Vec2 position, avo::Vec2 velocity, double radius,
                       double max_acceleration, avo::Behavior behavior, int age, double priority,
                       std::optional<double> max_braking, std::optional<avo::LoiterCircle> loiter,
                       double max_deviation, double position_error, avo::Vec2 acceleration,
                       double max_speed) {
             return Neighbor{position, velocity,      radius,         max_acceleration,
                             behavior, age,           priority,       max_braking,
                             loiter,   max_deviation, position_error, acceleration,
                             max_speed};
           }),
           py::kw_only(), arg("position"), arg("velocity") = py::make_tuple(0.0, 0.0),
           arg("radius") = 0.5, arg("max_acceleration") = 1.0, arg("behavior") = "decides",
           arg("age") = 0, arg("priority") = 1.0, arg("max_braking") = py::none(),
           arg("loiter") = py::none(), arg("max_deviation") = 0.0, arg("position_error") = 0.0,
           arg("acceleration") = py::make_tuple(0.0, 0.0), arg("max_speed") = kInfinity,
           "position: (x, y), m; velocity: m/s; radius: m, > 0; max_acceleration: m/s^2, > 0; "
           "behavior: \"decides\" or \"moves_on\"; age: steps since it was sensed; priority: > 0; "
           "max_braking: m/s^2; max_deviation: m/s^2, >= 0; position_error: m, >= 0; acceleration: "
           "m/s^2, and max_speed: m/s, of one that moves on.")
      .def_readwrite("position", &Neighbor::position)
      .def_readwrite("velocity", &Neighbor::velocity)
      .def_readwrite("radius", &Neighbor::radius)
      .def_readwrite("max_acceleration", &Neighbor::max_acceleration)
      .def_readwrite("behavior", &Neighbor::behavior)
      .def_readwrite("age", &Neighbor::age)
      .def_readwrite("priority", &Neighbor::priority)
      .def_readwrite("max_braking", &Neighbor::max_braking)
      .def_readwrite("loiter", &Neighbor::loiter)
      .def_readwrite("max_deviation", &Neighbor::max_deviation)
      .def_readwrite("position_error", &Neighbor::position_error)
      .def_readwrite("acceleration", &Neighbor::acceleration)
      .def_readwrite("max_speed", &Neighbor::max_speed);
}

void bind_detour(py::module_& module) {
  using avo::Detour;
  py::class_<Detour>(module, "Detour",
                     "What a robot remembers; plan() updates it. Method avo only.")
      .def(py::init<>())
      .def_readwrite("angle", &Detour::angle, "rad, how far it has turned off its way, right.")
      .def_readwrite("beside", &Detour::beside, "v_max/a_max, 0 to 200.")
      .def_readwrite("congestion", &Detour::congestion, "robots ahead, 0 to 2.8.")
      .def_readwrite("has_arrived", &Detour::has_arrived);
}

void bind_setup(py::module_& module) {
  using Setup = avo::RobotSetup;
  py::class_<Setup>(module, "RobotSetup", "What a scene says of a robot.")
      .def(
          py::init([](avo::Vec2 position, avo::Vec2 goal, avo::Vec2 velocity, double radius,
                      double max_speed, double max_acceleration,
                      std::optional<double> preferred_speed, avo::MotionModel model, double heading,
                      double priority, bool parked, avo::LayerSet layers, avo::LayerSet avoids,
                      std::optional<double> time_step, std::optional<double> max_braking) {
            return Setup{position,
                         velocity,
                         goal,
                         radius,
                         max_speed,
                         max_acceleration,
                         preferred_speed.value_or(max_speed),
                         model,
                         heading,
                         priority,
                         parked,
                         layers,
                         avoids,
                         time_step,
                         max_braking};
          }),
          py::kw_only(), arg("position"), arg("goal"), arg("velocity") = py::make_tuple(0.0, 0.0),
          arg("radius") = 0.5, arg("max_speed") = 2.0, arg("max_acceleration") = 1.0,
          arg("preferred_speed") = py::none(), arg("model") = avo::Holonomic{},
          arg("heading") = 0.0, arg("priority") = 1.0, arg("parked") = false,
          arg("layers") = avo::LayerSet{1}, arg("avoids") = avo::LayerSet{0xffffffff},
          arg("time_step") = py::none(), arg("max_braking") = py::none(),
          "position, goal: (x, y), m; velocity: m/s; radius: m, > 0; max_speed: m/s, > 0; "
          "max_acceleration: m/s^2, > 0; preferred_speed: m/s, >= 0, None: max_speed; model: how "
          "it moves; heading: rad; priority: > 0; parked: never moves; layers, avoids: 0 to 31; "
          "time_step: s, of a free clock; max_braking: m/s^2, None: max_acceleration.")
      .def_readwrite("position", &Setup::position)
      .def_readwrite("goal", &Setup::goal)
      .def_readwrite("velocity", &Setup::velocity)
      .def_readwrite("radius", &Setup::radius)
      .def_readwrite("max_speed", &Setup::max_speed)
      .def_readwrite("max_acceleration", &Setup::max_acceleration)
      .def_readwrite("preferred_speed", &Setup::preferred_speed)
      .def_readwrite("model", &Setup::model)
      .def_readwrite("heading", &Setup::heading)
      .def_readwrite("priority", &Setup::priority)
      .def_readwrite("parked", &Setup::parked)
      .def_readwrite("layers", &Setup::layers)
      .def_readwrite("avoids", &Setup::avoids)
      .def_readwrite("time_step", &Setup::time_step)
      .def_readwrite("max_braking", &Setup::max_braking);
}

}  // namespace

void bind_robots(py::module_& module) {
  bind_robot(module);
  bind_neighbor(module);
  bind_detour(module);
  bind_setup(module);
}

}  // namespace avo_python
