// SPDX-License-Identifier: Apache-2.0
// Edits of a simulation between two steps.
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "arrays.h"
#include "simulation.h"

namespace avo_python {

using avo::Simulation;
using py::arg;

avo::RobotId robot_id(std::int64_t id) {
  if (id < 0) throw avo::Error(fmt::format("robot {}: found none of that id", id));
  return {static_cast<std::uint64_t>(id)};
}

std::vector<avo::RobotId> robot_ids(const std::vector<std::int64_t>& ids) {
  std::vector<avo::RobotId> result;
  for (const std::int64_t id : ids) result.push_back(robot_id(id));
  return result;
}

namespace {

avo::ObstacleId obstacle_id(std::int64_t id) {
  if (id < 0) throw avo::Error(fmt::format("obstacle {}: found none of that id", id));
  return {static_cast<std::uint64_t>(id)};
}

avo::MovingObstacleId mover_id(std::int64_t id) {
  if (id < 0) throw avo::Error(fmt::format("moving obstacle {}: found none of that id", id));
  return {static_cast<std::uint64_t>(id)};
}

void change_robot(SharedSimulation& self, std::int64_t id, const py::kwargs& given) {
  for (const char* key : {"position", "velocity", "heading", "goal"})
    if (given.contains(key))
      throw py::type_error(fmt::format(
          "change_robot: found {}, must be left out: move_robot() and set_goal() change it", key));
  std::optional<avo::RobotSetup> setup = self.briefly([&](const Simulation& s) {
    const avo::RobotId robot = robot_id(id);
    return s.index_of(robot) ? std::optional(s.setup(robot)) : std::nullopt;
  });
  if (setup) set_fields(*setup, given);
  self.alone(
      [&](Simulation& s) { s.change_robot(robot_id(id), setup.value_or(avo::RobotSetup{})); });
}

}  // namespace

void bind_edits(SimulationClass& simulation) {
  simulation
      .def(
          "add_robot",
          // by value: another thread may change it
          [](SharedSimulation& self, const avo::RobotSetup setup) {
            return self.alone([&](Simulation& s) { return s.add_robot(setup).value; });
          },
          arg("setup"),
          "Returns its id. Raises Error where it starts in others, or too near or too fast for "
          "them or for obstacles, unless the scene has allow_broken_assumptions.")
      .def(
          "remove_robot",
          [](SharedSimulation& self, std::int64_t id) {
            self.alone([&](Simulation& s) { s.remove_robot(robot_id(id)); });
          },
          arg("id"), "Its id is never used again.")
      .def(
          "set_goal",
          [](SharedSimulation& self, std::int64_t id, avo::Vec2 goal) {
            self.alone([&](Simulation& s) { s.set_goal(robot_id(id), goal); });
          },
          arg("id"), arg("goal"), "goal: (x, y), m. The goal that it has already changes nothing.")
      .def(
          "move_robot",
          [](SharedSimulation& self, std::int64_t id, avo::Vec2 position) {
            self.alone([&](Simulation& s) { s.move_robot(robot_id(id), position); });
          },
          arg("id"), arg("position"),
          "Puts it down at position, (x, y), m, at rest; it keeps its id. Raises Error as "
          "add_robot() does.")
      .def(
          "change_robot", &change_robot, arg("id"),
          "Arguments by name, those of RobotSetup: what it can do and how it behaves from now on. "
          "Others stay. Its state, goal, model and time_step cannot be changed. A robot at rest "
          "can be \"parked\", and a parked one set free, by their behavior. Raises Error where the "
          "promise would break.")
      .def(
          "set_preferred_velocity",
          [](SharedSimulation& self, std::int64_t id, std::optional<avo::Vec2> velocity) {
            self.alone([&](Simulation& s) { s.set_preferred_velocity(robot_id(id), velocity); });
          },
          arg("id"), arg("velocity"),
          "velocity: (x, y), m/s, in place of a route to its goal; None: to its goal again.")
      .def(
          "set_velocity",
          [](SharedSimulation& self, std::int64_t id, std::optional<avo::Vec2> velocity) {
            self.alone([&](Simulation& s) { s.set_velocity(robot_id(id), velocity); });
          },
          arg("id"), arg("velocity"),
          "velocity: (x, y), m/s, after each step, whatever is in its way: it decides nothing, and "
          "others keep clear of it alone. None: it brakes, and then decides again. Raises Error as "
          "change_robot() does, and above max_speed.")
      .def(
          "set_goals",
          [](SharedSimulation& self, const std::vector<std::int64_t>& ids,
             const py::object& goals) {
            const Numbers array = numbers("goals", goals);
            self.alone([&](Simulation& s) { s.set_goals(robot_ids(ids), rows("goals", array)); });
          },
          arg("ids"), arg("goals"),
          "goals: (n, 2), m, one for each id. Where one is refused nothing has changed.")
      .def(
          "set_preferred_velocities",
          [](SharedSimulation& self, const std::vector<std::int64_t>& ids,
             const py::object& velocities) {
            const Numbers array = numbers("velocities", velocities);
            self.alone([&](Simulation& s) {
              s.set_preferred_velocities(robot_ids(ids), rows("velocities", array));
            });
          },
          arg("ids"), arg("velocities"), "velocities: (n, 2), m/s, one for each id.")
      .def(
          "add_robots",
          [](SharedSimulation& self, const std::vector<avo::RobotSetup>& setups) {
            return self.alone([&](Simulation& s) {
              std::vector<std::uint64_t> ids;
              for (const avo::RobotId id : s.add_robots(setups)) ids.push_back(id.value);
              return ids;
            });
          },
          arg("setups"), "Returns their ids. Where one is refused nothing has changed.")
      .def(
          "remove_robots",
          [](SharedSimulation& self, const std::vector<std::int64_t>& ids) {
            self.alone([&](Simulation& s) { s.remove_robots(robot_ids(ids)); });
          },
          arg("ids"), "Their ids are never used again.")
      .def(
          "add_moving_obstacle",
          [](SharedSimulation& self, const avo::MovingObstacle& obstacle) {
            return self.alone([&](Simulation& s) { return s.add_moving_obstacle(obstacle).value; });
          },
          arg("obstacle"),
          "A person, a vehicle or a player comes. Returns its id. Raises Error where some robot "
          "cannot keep clear of it.")
      .def(
          "change_moving_obstacle",
          [](SharedSimulation& self, std::int64_t id, const avo::MovingObstacle& obstacle) {
            self.alone([&](Simulation& s) { s.change_moving_obstacle(mover_id(id), obstacle); });
          },
          arg("id"), arg("obstacle"),
          "Its place, velocity, radius, limits and path are those of obstacle from now on.")
      .def(
          "remove_moving_obstacle",
          [](SharedSimulation& self, std::int64_t id) {
            self.alone([&](Simulation& s) { s.remove_moving_obstacle(mover_id(id)); });
          },
          arg("id"), "Its id is never used again.")
      .def(
          "add_obstacle",
          [](SharedSimulation& self, const avo::StaticObstacle& obstacle) {
            return self.alone([&](Simulation& s) { return s.add_obstacle(obstacle).value; });
          },
          arg("obstacle"), "A door closes. Returns its id.")
      .def(
          "remove_obstacle",
          [](SharedSimulation& self, std::int64_t id) {
            self.alone([&](Simulation& s) { s.remove_obstacle(obstacle_id(id)); });
          },
          arg("id"), "A door opens.");
}

}  // namespace avo_python
