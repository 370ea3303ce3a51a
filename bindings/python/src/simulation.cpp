// SPDX-License-Identifier: Apache-2.0
// A fleet.
#include "simulation.h"

#include <chrono>
#include <cstring>
#include <fmt/format.h>
#include <memory>

#include "avo/planner.h"
#include "external.h"
#include "renamed.h"

namespace avo_python {
namespace {

using avo::Simulation;
using py::arg;

std::span<const std::byte> bytes_of(const py::bytes& saved) {
  char* data = nullptr;
  Py_ssize_t size = 0;
  if (PyBytes_AsStringAndSize(saved.ptr(), &data, &size) != 0) throw py::error_already_set();
  return {reinterpret_cast<const std::byte*>(data), static_cast<std::size_t>(size)};
}

std::unique_ptr<SharedSimulation> make(const py::object& scene, int threads) {
  const avo::Scenario scenario = scenario_of(scene, py::none());
  const py::gil_scoped_release release;
  auto made = std::make_unique<SharedSimulation>(Simulation(scenario, threads), scenario.name);
  made->external = scenario.external;
  return made;
}

std::unique_ptr<SharedSimulation> from_saved(const py::bytes& saved, int threads,
                                             const std::string& name) {
  const auto bytes = bytes_of(saved);
  const py::gil_scoped_release release;
  return std::make_unique<SharedSimulation>(Simulation(bytes, threads), name);
}

/// Many steps can take long: from time to time, Python may handle its signals.
void step(SharedSimulation& self, std::int64_t n) {
  using Clock = std::chrono::steady_clock;
  if (n < 0) throw avo::Error(fmt::format("n: found {}, must be >= 0", n));
  if (n == 1) return self.alone([](Simulation& simulation) { simulation.step(); });
  while (n > 0) {
    n = self.alone([n](Simulation& simulation) {
      const Clock::time_point end = Clock::now() + std::chrono::milliseconds(50);
      std::int64_t left = n;
      do simulation.step();
      while (--left > 0 && Clock::now() < end);
      return left;
    });
    if (n > 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

py::bytes save(SharedSimulation& self) {
  const auto saved = self.alone([](const Simulation& simulation) { return simulation.save(); });
  return {reinterpret_cast<const char*>(saved.data()), saved.size()};
}

int threads_of(SharedSimulation& simulation) {
  return simulation.briefly([](const Simulation& s) { return s.threads(); });
}

void set_external(SharedSimulation& self, const avo::ExternalMethod& method) {
  self.alone([&](Simulation& simulation) { simulation.set_external(method); });
  self.external = method;
}

auto copy_of(SharedSimulation& simulation) {
  auto copy = from_saved(save(simulation), threads_of(simulation), simulation.name());
  set_external(*copy, simulation.external);
  return copy;
}

void bind_run(SimulationClass& simulation) {
  simulation
      .def(py::init(&make), arg("scene"), arg("threads") = 0,
           "scene: a Scenario, or what Scenario() takes; threads: 0 to 1024, 0: all processors.")
      .def_static("from_saved", &from_saved, arg("saved"), arg("threads") = 0, arg("name") = "",
                  "Goes on from what another one saved.")
      .def("step", &step, arg("n") = 1,
           "n steps of all robots; other Python threads run meanwhile.")
      .def(
          "set_external",
          [](SharedSimulation& self, const py::object& function, const std::string& output) {
            set_external(self, external_of(function, output_of(output)));
          },
          arg("function"), py::kw_only(), arg("output") = "velocity",
          "The function behind the scene's external_method, as in Scenario.with_method(): one from "
          "saved bytes, or from a pickle, needs it.")
      .def("save", &save, "The whole state as bytes, the same on every machine.")
      .def(
          "restore",
          [](SharedSimulation& self, const py::bytes& saved) {
            const auto bytes = bytes_of(saved);
            self.alone([bytes](Simulation& s) { s.restore(bytes); });
          },
          arg("saved"), "Back, or forth, to what one of the same scene has saved.")
      .def("__copy__", &copy_of)
      .def("__deepcopy__", [](SharedSimulation& self, const py::dict&) { return copy_of(self); })
      .def(py::pickle(
          [](SharedSimulation& self) {
            return py::make_tuple(save(self), threads_of(self), self.name());
          },
          [](const py::tuple& state) {
            return from_saved(state[0].cast<py::bytes>(), state[1].cast<int>(),
                              state[2].cast<std::string>());
          }));
}

void bind_state(SimulationClass& simulation) {
  simulation.def("__len__", told([](const Simulation& s) { return s.size(); }))
      .def_property_readonly("name", &SharedSimulation::name, "of the scene")
      .def_property_readonly("time", told([](const Simulation& s) { return s.time(); }), "s")
      .def_property_readonly("steps", told([](const Simulation& s) { return s.steps(); }),
                             "done since the start")
      .def_property_readonly("sensing_radius",
                             told([](const Simulation& s) { return s.sensing_radius(); }),
                             "m: how far robots sense; where the scene names none, it grows with "
                             "robots that are added")
      .def_property_readonly("roster", told([](const Simulation& s) { return s.roster(); }),
                             "changes whenever robots come, go or are restored; as long as it "
                             "stays, ids and setups stay")
      .def_property_readonly("threads", told([](const Simulation& s) { return s.threads(); }),
                             "that a step may use")
      .def(
          "can_step_by",
          [](SharedSimulation& self, double time) {
            return self.briefly([time](const Simulation& s) { return s.can_step_by(time); });
          },
          arg("time"), "Whether the next step ends by that time, s.")
      .def(
          "state_hash",
          [](SharedSimulation& self) {
            return self.alone([](const Simulation& s) { return s.state_hash(); });
          },
          "Equal for equal states, bit by bit.")
      .def("_repr_svg_",
           [](const py::object& self) { return py::module_::import("avo.svg").attr("draw")(self); })
      .def("__repr__", [](SharedSimulation& self) {
        const auto [n, time] =
            self.briefly([](const Simulation& s) { return std::pair(s.size(), s.time()); });
        return fmt::format("<avo.Simulation {}: {} robots at {:.9g} s>", self.name(), n, time);
      });
}

void bind_robot_state(py::module_& module) {
  using avo::RobotState;
  py::class_<RobotState>(module, "RobotState", "The present state of one robot of a fleet.")
      .def_property_readonly(
          "id", [](const RobotState& state) { return state.id.value; }, "never used again")
      .def_readonly("position", &RobotState::position, "(x, y), m")
      .def_readonly("velocity", &RobotState::velocity, "(x, y), m/s")
      .def_readonly("heading", &RobotState::heading,
                    "rad, counter-clockwise from +x; 0 of holonomic ones")
      .def_readonly("goal", &RobotState::goal, "(x, y), m")
      .def_readonly("detour", &RobotState::detour, "Detour, what it remembers")
      .def_readonly("plan", &RobotState::plan, "Plan, of its last decision")
      .def_readonly("applied_acceleration", &RobotState::applied_acceleration,
                    "m/s^2, the largest |a| within the last step");
}

void bind_inventory(SimulationClass& simulation) {
  simulation
      .def(
          "obstacles",
          [](SharedSimulation& self) {
            return self.alone([](const Simulation& s) {
              const avo::StaticObstacleView view = s.obstacles();
              std::vector<std::pair<std::uint64_t, avo::StaticObstacle>> all;
              for (std::size_t k = 0; k < view.id.size(); ++k)
                all.emplace_back(view.id[k].value, view.setup[k]);
              return all;
            });
          },
          "list of (id, StaticObstacle).")
      .def("moving_obstacles", told([](const Simulation& s) {
             const auto setup = s.moving_obstacles().setup;
             return std::vector<avo::MovingObstacle>(setup.begin(), setup.end());
           }),
           "list of MovingObstacle, as they came or were changed.")
      .def("moving_obstacle_ids", told([](const Simulation& s) {
             std::vector<std::uint64_t> ids;
             for (const avo::MovingObstacleId id : s.moving_obstacles().id) ids.push_back(id.value);
             return ids;
           }),
           "Ids of moving_obstacles(), ascending; those of the scene are 0, 1, ...")
      .def(
          "preferred_velocity",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly(
                [&](const Simulation& s) { return s.preferred_velocity(robot_id(id)); });
          },
          arg("id"), "(x, y), m/s, that the host gave to the robot; else None.")
      .def(
          "host_velocity",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.host_velocity(robot_id(id)); });
          },
          arg("id"), "(x, y), m/s, by which the host moves the robot; else None.")
      .def(
          "is_moved",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.is_moved(robot_id(id)); });
          },
          arg("id"),
          "Whether the host moves the robot by set_velocity(), or the robot brakes since the host "
          "gave it back; it decides nothing meanwhile.")
      .def(
          "decided",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.decided(robot_id(id)); });
          },
          arg("id"), "Whether the robot decided in the last step.")
      .def(
          "next_decision",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.next_decision(robot_id(id)); });
          },
          arg("id"), "When the robot decides next, s; inf for a parked robot.")
      .def(
          "index_of",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.index_of(robot_id(id)); });
          },
          arg("id"), "Row of the robot in the arrays; None where it is gone.")
      .def(
          "setup",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.setup(robot_id(id)); });
          },
          arg("id"), "RobotSetup of the robot, a copy.")
      .def(
          "robot",
          [](SharedSimulation& self, std::int64_t id) {
            return self.briefly([&](const Simulation& s) { return s.robot(robot_id(id)); });
          },
          arg("id"), "RobotState of the robot, a copy; takes no longer where there are many.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  SimulationClass simulation(
      module, "Simulation",
      "A fleet of robots that all plan alone. Threads may share it: one uses "
      "it at a time, the others wait.");
  bind_run(simulation);
  bind_state(simulation);
  bind_edits(simulation);
  bind_queries(simulation);
  bind_routes(module, simulation);
  bind_team_edits(simulation);
  bind_robot_state(module);
  bind_inventory(simulation);
  bind_perception(module, simulation);
  bind_columns(simulation);
  refuse_renamed(simulation, {{"obstacle_position", "moving_obstacle_position"},
                              {"obstacle_velocity", "moving_obstacle_velocity"}});
}

}  // namespace avo_python
