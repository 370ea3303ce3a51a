// SPDX-License-Identifier: Apache-2.0
// Moving obstacles of space, and edits of a simulation between two steps.
#include <fmt/format.h>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "space.h"

namespace avo_python::space {
namespace {

using avo::Vec3;
using avo::space::MovingObstacle;
using avo::space::Simulation;
using py::arg;

using TimedTuple = std::tuple<double, double, double, double>;  // s, m, m, m

MovingObstacle obstacle_of(Vec3 position, Vec3 velocity, Vec3 acceleration, double radius,
                           double max_deviation, std::optional<double> max_speed,
                           const std::vector<TimedTuple>& trajectory) {
  MovingObstacle obstacle{.position = position,
                          .velocity = velocity,
                          .acceleration = acceleration,
                          .radius = radius,
                          .max_deviation = max_deviation,
                          .max_speed = max_speed};
  for (const auto& [time, x, y, z] : trajectory) obstacle.trajectory.push_back({time, {x, y, z}});
  return obstacle;
}

std::vector<TimedTuple> trajectory_of(const MovingObstacle& obstacle) {
  std::vector<TimedTuple> places;
  for (const auto& [time, place] : obstacle.trajectory)
    places.emplace_back(time, place.x, place.y, place.z);
  return places;
}

void bind_obstacle(py::module_& space) {
  const py::tuple origin = py::make_tuple(0.0, 0.0, 0.0);
  py::class_<MovingObstacle>(space, "MovingObstacle", "A ball that reacts to no robot.")
      .def(
          py::init(&obstacle_of), py::kw_only(), arg("position") = origin, arg("velocity") = origin,
          arg("acceleration") = origin, arg("radius") = 0.5, arg("max_deviation") = 0.0,
          arg("max_speed") = py::none(), arg("trajectory") = std::vector<TimedTuple>(),
          "position: (x, y, z), m, at the start, or when it is added; velocity: m/s; acceleration: "
          "m/s^2; radius: m, > 0; max_deviation: m/s^2, >= 0; max_speed: m/s, > 0, None: unknown; "
          "trajectory: list of (time, x, y, z), s and m, which also says where it is at first.")
      .def_readonly("position", &MovingObstacle::position, "(x, y, z), m, at first")
      .def_readonly("velocity", &MovingObstacle::velocity, "(x, y, z), m/s, at first")
      .def_readonly("acceleration", &MovingObstacle::acceleration,
                    "(x, y, z), m/s^2; 0 with max_speed")
      .def_readonly("radius", &MovingObstacle::radius, "m, > 0")
      .def_readonly("max_deviation", &MovingObstacle::max_deviation,
                    "m/s^2, >= 0, that robots allow for")
      .def_readonly("max_speed", &MovingObstacle::max_speed,
                    "m/s, > 0, with max_deviation: that it never exceeds; None: unknown")
      .def_property_readonly("trajectory", &trajectory_of,
                             "list of (time, x, y, z), s and m; empty: it has none");
}

avo::MovingObstacleId mover_id(std::int64_t id) {
  if (id < 0) throw avo::Error(fmt::format("moving obstacle {}: found none of that id", id));
  return {static_cast<std::uint64_t>(id)};
}

// Returns a method that gives the rows of all moving obstacles; part: a member of Mover.
auto rows_of_movers(Vec3 avo::space::Mover::*part) {
  return [part](SharedSpaceSimulation& self) {
    return self.briefly([part](const Simulation& s) {
      return rows_of_space(s.movers().size(), [&](std::size_t k) { return s.movers()[k].*part; });
    });
  };
}

void bind_mover_edits(SpaceSimulationClass& simulation) {
  using avo::space::Mover;
  simulation
      .def(
          "add_moving_obstacle",
          [](SharedSpaceSimulation& self, const MovingObstacle& obstacle) {
            return self.alone([&](Simulation& s) { return s.add_moving_obstacle(obstacle).value; });
          },
          arg("obstacle"),
          "A helicopter, a ball or a player comes. Returns its id. Raises Error where it touches "
          "some robot, or some robot cannot brake before it.")
      .def(
          "change_moving_obstacle",
          [](SharedSpaceSimulation& self, std::int64_t id, const MovingObstacle& obstacle) {
            self.alone([&](Simulation& s) { s.change_moving_obstacle(mover_id(id), obstacle); });
          },
          arg("id"), arg("obstacle"),
          "Its place, velocity, radius, limits and trajectory are those of obstacle from now on.")
      .def(
          "remove_moving_obstacle",
          [](SharedSpaceSimulation& self, std::int64_t id) {
            self.alone([&](Simulation& s) { s.remove_moving_obstacle(mover_id(id)); });
          },
          arg("id"), "Its id is never used again.")
      .def(
          "moving_obstacles",
          [](SharedSpaceSimulation& self) {
            return self.briefly([](const Simulation& s) { return s.scenario().moving_obstacles; });
          },
          "list of MovingObstacle, as they came or were changed.")
      .def(
          "moving_obstacle_ids",
          [](SharedSpaceSimulation& self) {
            return self.briefly([](const Simulation& s) {
              std::vector<std::uint64_t> ids;
              for (const avo::MovingObstacleId id : s.moving_obstacle_ids())
                ids.push_back(id.value);
              return ids;
            });
          },
          "Ids of moving_obstacles(), ascending; those of the scene are 0, 1, ...")
      .def("moving_obstacle_position", rows_of_movers(&Mover::position), "(m, 3), m, now.")
      .def("moving_obstacle_velocity", rows_of_movers(&Mover::velocity), "(m, 3), m/s, now.");
}

}  // namespace

void bind_moving_obstacles(py::module_& space) {
  bind_obstacle(space);
}

void bind_edits(SpaceSimulationClass& simulation) {
  simulation
      .def(
          "set_goal",
          [](SharedSpaceSimulation& self, std::int64_t robot, Vec3 goal) {
            self.alone([&](Simulation& s) { s.set_goal(checked(s, robot), goal); });
          },
          arg("robot"), arg("goal"), "Gives the robot of that id another goal, (x, y, z), m.")
      .def(
          "set_boxes",
          [](SharedSpaceSimulation& self, const std::vector<avo::space::Box>& boxes) {
            self.alone([&](Simulation& s) { s.set_boxes(boxes); });
          },
          arg("boxes"),
          "Replaces all boxes. Raises Error, and changes nothing, where a robot is in a box or "
          "cannot brake before it.");
  bind_mover_edits(simulation);
}

}  // namespace avo_python::space
