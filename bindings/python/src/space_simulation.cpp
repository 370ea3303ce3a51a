// SPDX-License-Identifier: Apache-2.0
// Scenes and fleets of space, and the module of space.
#include <chrono>
#include <fmt/format.h>
#include <memory>
#include <utility>

#include "arrays.h"
#include "avo/space/reachability.h"
#include "avo_io/space.h"
#include "fields.h"
#include "space.h"

namespace avo_python::space {
namespace {

using avo::space::Scenario;
using avo::space::Simulation;
using py::arg;

Scenario parse(const std::string& text, const std::string& file, const py::object& overrides) {
  return avo_io::parse_space_scenario(text, file, overrides_of(overrides));
}

py::list out_of_reach_of(const Scenario& scenario) {
  py::list list;
  for (const avo::space::OutOfReach& one : avo::space::out_of_reach(scenario)) {
    py::dict entry;
    entry["robot"] = one.robot.value;
    entry["nearest"] = one.nearest;
    entry["distance_left"] = one.distance_left;
    entry["is_in_box"] = one.is_in_box;
    list.append(entry);
  }
  return list;
}

void bind_scenario(py::module_& space) {
  py::class_<Scenario> scene(
      space, "Scenario", "A scene of space: robots, boxes, and how they are simulated. Read only.");
  bind_fields(scene, avo_io::space_scene_fields(), "sensing_radius");
  scene
      .def(py::init(&scenario_of_space), arg("source"), arg("overrides") = py::none(),
           "source: path of a scene file with space: 3, or a dict with its keys. overrides: "
           "{\"robots.0.radius\": 0.4}, or [\"robots.0.radius=0.4\"]. Raises Error with the "
           "reader's message.")
      .def_static("from_yaml", &parse, arg("text"), arg("file") = "text",
                  arg("overrides") = py::none(),
                  "From the text of a scene file. file: stands in front of messages.")
      .def_property_readonly("sensing_radius", &avo::space::sensing_radius_of,
                             "m, between centers; what the robots need where the scene names none")
      .def_property_readonly("fleet_delay", &avo::space::fleet_delay,
                             "s: how long after their references all quadrotors fly")
      .def("out_of_reach", &out_of_reach_of,
           "A dict of each robot that boxes keep from its goal: its \"robot\" number, the "
           "\"nearest\" place that it gets to, m, the \"distance_left\" from there to the goal, m, "
           "and whether the goal \"is_in_box\", nearer to a box than the radius.")
      .def_readonly("robots", &Scenario::robots, "list of RobotSetup, a copy")
      .def_readonly("moving_obstacles", &Scenario::moving_obstacles,
                    "list of MovingObstacle, a copy")
      .def_readonly("boxes", &Scenario::boxes, "list of Box, of all obstacles, a copy")
      .def("__repr__", [](const Scenario& scenario) {
        return fmt::format("<avo.space.Scenario {}: {} robots>", scenario.name,
                           scenario.robots.size());
      });
}

std::unique_ptr<SharedSpaceSimulation> make_simulation(const py::object& scene, int threads) {
  const Scenario scenario = scenario_of_space(scene, py::none());
  const py::gil_scoped_release release;
  return std::make_unique<SharedSpaceSimulation>(Simulation(scenario, threads));
}

py::object dict_of(const std::optional<Simulation::Touched>& touched) {
  if (!touched) return py::none();
  py::dict entry;
  if (touched->robot) entry["robot"] = touched->robot->value;
  if (touched->obstacle) entry["obstacle"] = touched->obstacle->value;
  if (touched->moving_obstacle) entry["moving_obstacle"] = touched->moving_obstacle->value;
  return entry;
}

/// Many steps can take long: from time to time, Python may handle its signals.
void step(SharedSpaceSimulation& self, std::int64_t n) {
  using Clock = std::chrono::steady_clock;
  if (n < 0) throw avo::Error(fmt::format("n: found {}, must be >= 0", n));
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

// Returns a method that gives the rows of all robots; vector(simulation, k) is a Vec3.
template <typename Vector>
auto rows_by(Vector vector) {
  return [vector](SharedSpaceSimulation& self) {
    return self.briefly([vector](const Simulation& simulation) {
      return rows_of_space(simulation.size(), [&](std::size_t k) { return vector(simulation, k); });
    });
  };
}

// Returns a getter of one value.
template <typename Value>
auto told(Value value) {
  return [value](SharedSpaceSimulation& self) {
    return self.briefly([value](const Simulation& simulation) { return value(simulation); });
  };
}

void bind_state(SpaceSimulationClass& simulation) {
  simulation
      .def("position",
           rows_by([](const Simulation& s, std::size_t k) { return s.robots()[k].position; }),
           "(n, 3), m.")
      .def("velocity",
           rows_by([](const Simulation& s, std::size_t k) { return s.robots()[k].velocity; }),
           "(n, 3), m/s.")
      .def("acceleration",
           rows_by([](const Simulation& s, std::size_t k) { return s.plans()[k].acceleration; }),
           "(n, 3), m/s^2, at the start of the last step.")
      .def("goal", rows_by([](const Simulation& s, std::size_t k) { return s.goal({k}); }),
           "(n, 3), m.")
      .def(
          "status",
          [](SharedSpaceSimulation& self) {
            return self.briefly([](const Simulation& s) {
              py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(s.size()));
              for (std::size_t k = 0; k < s.size(); ++k)
                array.mutable_at(static_cast<py::ssize_t>(k)) =
                    static_cast<std::uint8_t>(s.plans()[k].status);
              return array;
            });
          },
          "(n,): of the last decisions, indices into PLAN_STATUS.")
      .def(
          "at_goal",
          [](SharedSpaceSimulation& self) {
            return self.briefly([](const Simulation& s) {
              py::array_t<bool> array(static_cast<py::ssize_t>(s.size()));
              for (std::size_t k = 0; k < s.size(); ++k)
                array.mutable_at(static_cast<py::ssize_t>(k)) = s.is_at_goal({k});
              return array;
            });
          },
          "(n,) bool: whether it is within arrival_distance of its goal.")
      .def("all_at_goal", told([](const Simulation& s) { return s.all_at_goal(); }),
           "Whether all robots are at their goals.")
      .def(
          "is_at_goal",
          [](SharedSpaceSimulation& self, std::int64_t robot) {
            return self.briefly(
                [&](const Simulation& s) { return s.is_at_goal(checked(s, robot)); });
          },
          arg("robot"), "Whether the robot is at its goal.")
      .def("unreachable", told([](const Simulation& s) {
             std::vector<std::uint64_t> ids;
             for (const avo::RobotId id : s.unreachable()) ids.push_back(id.value);
             return ids;
           }),
           "Ids of robots that boxes keep from their goals: they go as near as they can, and are "
           "distance_left() from there.")
      .def(
          "distance_left",
          [](SharedSpaceSimulation& self, std::int64_t robot) {
            return self.briefly(
                [&](const Simulation& s) { return s.route(checked(s, robot)).distance_left; });
          },
          arg("robot"),
          "m, from the nearest place that the robot can reach to its goal; 0 where no box keeps it "
          "from its goal.")
      .def(
          "route",
          [](SharedSpaceSimulation& self, std::int64_t robot) {
            return self.briefly([&](const Simulation& s) { return s.route(checked(s, robot)); });
          },
          arg("robot"), "Route, the rest of the route that the robot knows.")
      .def(
          "can_step_by",
          [](SharedSpaceSimulation& self, double time) {
            return self.briefly([&](const Simulation& s) { return s.can_step_by(time); });
          },
          arg("time"),
          "Whether the next step ends by that time, s. A whole run steps while this is true for "
          "the "
          "scene's duration.")
      .def(
          "touched",
          [](SharedSpaceSimulation& self, std::int64_t robot) {
            return dict_of(
                self.briefly([&](const Simulation& s) { return s.touched(checked(s, robot)); }));
          },
          arg("robot"),
          "What the robot touches, or will touch although it brakes: {\"robot\": id}, "
          "{\"obstacle\": id} of a box, or {\"moving_obstacle\": id}; None where nothing.")
      .def("state_hash", told([](const Simulation& s) { return s.state_hash(); }),
           "Equal for equal states, bit by bit.");
}

void bind_route(py::module_& space) {
  using Route = Simulation::Route;
  py::class_<Route>(space, "Route", "The rest of a robot's route.")
      .def_readonly("length", &Route::length, "m; inf for robots that unreachable() names")
      .def_readonly("next", &Route::next, "(x, y, z), m, its next point, a bend or its end")
      .def_readonly("distance_left", &Route::distance_left,
                    "m, from its end to the goal; 0 where no box keeps the robot from its goal");
}

void bind_simulation(py::module_& space) {
  SpaceSimulationClass simulation(space, "Simulation", "A fleet in space.");
  simulation
      .def(py::init(&make_simulation), arg("scene"), arg("threads") = 0,
           "scene: a Scenario, or what Scenario() takes; threads: 0 to 1024, 0: all processors.")
      .def("__len__", told([](const Simulation& s) { return s.size(); }))
      .def("step", &step, arg("n") = 1,
           "n steps of all robots; other Python threads run meanwhile.")
      .def_property_readonly("name", told([](const Simulation& s) { return s.scenario().name; }),
                             "of the scene")
      .def_property_readonly("time", told([](const Simulation& s) { return s.time(); }), "s")
      .def_property_readonly("steps", told([](const Simulation& s) { return s.steps(); }),
                             "done since the start")
      .def("__repr__", [](SharedSpaceSimulation& self) {
        return self.briefly([](const Simulation& s) {
          return fmt::format("<avo.space.Simulation {}: {} robots at {:.9g} s>", s.scenario().name,
                             s.size(), s.time());
        });
      });
  bind_state(simulation);
  bind_edits(simulation);
}

}  // namespace

avo::RobotId checked(const Simulation& simulation, std::int64_t robot) {
  if (robot < 0 || robot >= static_cast<std::int64_t>(simulation.size()))
    throw avo::Error(fmt::format("robot: found {}, must be 0 to {}", robot, simulation.size() - 1));
  return {static_cast<std::uint64_t>(robot)};
}

void bind_scenes(py::module_& space) {
  bind_moving_obstacles(space);
  bind_scenario(space);
  bind_route(space);
  bind_simulation(space);
}

}  // namespace avo_python::space

namespace avo_python {

avo::space::Scenario scenario_of_space(const py::object& source, const py::object& overrides) {
  if (py::isinstance<avo::space::Scenario>(source)) {
    if (overrides.is_none()) return source.cast<avo::space::Scenario>();
    throw avo::Error("overrides: found beside a Scenario, must be given where it is made");
  }
  if (py::isinstance<py::dict>(source))
    return avo_io::parse_space_scenario(json_of(source), "dict", overrides_of(overrides));
  const std::string path = path_of(source);
  auto scenario = avo_io::load_space_scenario(path, overrides_of(overrides));
  if (!scenario)
    throw avo::Error(path + ": found no scene with space: 3, must be one; see avo.Scenario");
  return std::move(*scenario);
}

void bind_space(py::module_& module) {
  py::module_ own = module.def_submodule("_space", "Robots in three dimensions.");
  own.attr("__name__") = "avo.space";  // from where users import the classes
  space::bind_robots(own);
  space::bind_planner(own);
  space::bind_scenes(own);
  space::bind_events(own);
  space::bind_runs(own);
  space::bind_worlds(own);
  space::bind_batches(own);
}

}  // namespace avo_python
