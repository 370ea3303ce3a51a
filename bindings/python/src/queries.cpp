// SPDX-License-Identifier: Apache-2.0
// Where robots and room are at present.
#include <cstdint>
#include <vector>

#include "simulation.h"

namespace avo_python {

using avo::Simulation;
using py::arg;

namespace {

std::vector<std::uint64_t> values_of(const std::vector<avo::RobotId>& robots) {
  std::vector<std::uint64_t> values;
  for (const avo::RobotId robot : robots) values.push_back(robot.value);
  return values;
}

}  // namespace

void bind_queries(SimulationClass& simulation) {
  simulation
      .def(
          "robots_within",
          [](SharedSimulation& self, avo::Vec2 center, double radius) {
            return self.briefly(
                [&](const Simulation& s) { return values_of(s.robots_within(center, radius)); });
          },
          arg("center"), arg("radius"),
          "Ids of the robots with discs within radius, m, of (x, y), nearest disc first.")
      .def(
          "nearest_robots",
          [](SharedSimulation& self, avo::Vec2 position, std::size_t count) {
            return self.briefly(
                [&](const Simulation& s) { return values_of(s.nearest_robots(position, count)); });
          },
          arg("position"), arg("count"), "Ids of the robots with the discs nearest to (x, y).")
      .def(
          "is_free",
          [](SharedSimulation& self, avo::Vec2 position, double radius, avo::LayerSet layers) {
            return self.briefly(
                [&](const Simulation& s) { return s.is_free(position, radius, layers); });
          },
          arg("position"), arg("radius"), arg("layers") = avo::kAllLayers,
          "Whether a disc there would touch nothing, and is where obstacles leave room. layers, "
          "here and below: only robots in one of them count, and static obstacles that they heed.")
      .def(
          "is_in_sight",
          [](SharedSimulation& self, avo::Vec2 from, avo::Vec2 to, double radius,
             avo::LayerSet layers) {
            return self.briefly(
                [&](const Simulation& s) { return s.is_in_sight(from, to, radius, layers); });
          },
          arg("start"), arg("end"), arg("radius") = 0.0, arg("layers") = avo::kAllLayers,
          "Whether no static obstacle stops a disc of that radius, m, on the straight line.")
      .def(
          "cast_ray",
          [](SharedSimulation& self, avo::Vec2 from, avo::Vec2 to, double radius,
             avo::LayerSet layers) -> py::object {
            const auto hit = self.briefly(
                [&](const Simulation& s) { return s.cast_ray(from, to, radius, layers); });
            if (!hit) return py::none();
            py::dict found;
            found["distance"] = hit->distance, found["center"] = hit->center;
            if (hit->robot) found["robot"] = hit->robot->value;
            if (hit->moving_obstacle) found["moving_obstacle"] = hit->moving_obstacle->value;
            if (hit->obstacle) found["obstacle"] = hit->obstacle->value;
            return found;
          },
          arg("start"), arg("end"), arg("radius") = 0.0, arg("layers") = avo::kAllLayers,
          "What a disc of that radius, m, touches first on the straight line: a dict of distance, "
          "m, "
          "center, and the id as robot, moving_obstacle or obstacle; None: nothing.");
}

}  // namespace avo_python
