// SPDX-License-Identifier: Apache-2.0
// The columns of a simulation as arrays, with one row for each robot by ascending id.
#include <fmt/format.h>

#include "arrays.h"
#include "simulation.h"

namespace avo_python {
namespace {

using avo::Columns;
using avo::FleetView;
using py::arg;

std::size_t size_of(SharedSimulation& self) {
  return self.briefly([](const avo::Simulation& s) { return s.size(); });
}

/// Returns an array that copy() has filled. The fleet may change until copy() begins, but not after
/// that.
template <typename Make, typename Copy>
auto column(SharedSimulation& self, Columns wanted, const Make& make, const Copy& copy) {
  for (;;) {
    const std::size_t n = size_of(self);
    auto array = make(static_cast<py::ssize_t>(n));
    const bool copied = self.briefly([&](const avo::Simulation& simulation) {
      if (simulation.size() != n) return false;
      copy(simulation.fleet(wanted), array);
      return true;
    });
    if (copied) return array;
  }
}

template <typename Of>  // Vec2 of(fleet, k)
auto points(Columns wanted, Of of) {
  return [=](SharedSimulation& self, const Out& out) {
    return column(
        self, wanted,
        [&](py::ssize_t n) {
          return target(out, {n, 2});
        },
        [&](const FleetView& fleet, py::array_t<double>& array) {
          auto rows = array.mutable_unchecked<2>();
          for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
            const avo::Vec2 v = of(fleet, static_cast<std::size_t>(k));
            rows(k, 0) = v.x;
            rows(k, 1) = v.y;
          }
        });
  };
}

template <typename Of>  // double of(fleet, k)
auto per_robot(Columns wanted, Of of) {
  return [=](SharedSimulation& self, const Out& out) {
    return column(
        self, wanted, [&](py::ssize_t n) { return target(out, {n}); },
        [&](const FleetView& fleet, py::array_t<double>& array) {
          auto row = array.mutable_unchecked<1>();
          for (py::ssize_t k = 0; k < row.shape(0); ++k)
            row(k) = of(fleet, static_cast<std::size_t>(k));
        });
  };
}

template <typename Number, typename Of>
auto whole(Columns wanted, Of of) {
  return [=](SharedSimulation& self) {
    return column(
        self, wanted, [](py::ssize_t n) { return py::array_t<Number>(n); },
        [&](const FleetView& fleet, py::array_t<Number>& array) {
          auto row = array.template mutable_unchecked<1>();
          for (py::ssize_t k = 0; k < row.shape(0); ++k)
            row(k) = static_cast<Number>(of(fleet, static_cast<std::size_t>(k)));
        });
  };
}

/// Returns arrays with an entry for each moving obstacle.
auto obstacle_points(std::span<const avo::Vec2> avo::MovingObstacleView::*which) {
  return [which](SharedSimulation& self, const Out& out) {
    const auto points = self.briefly([&](const avo::Simulation& simulation) {
      const auto view = simulation.moving_obstacles().*which;
      return std::vector<avo::Vec2>(view.begin(), view.end());
    });
    auto array = target(out, {static_cast<py::ssize_t>(points.size()), 2});
    fill(array, points);
    return array;
  };
}

}  // namespace

// COLUMN is the column, and OF the part of a robot's entry in it.
#define POINTS(NAME, COLUMN, OF, DOC)                                                   \
  def(NAME,                                                                             \
      points(Columns::COLUMN,                                                           \
             [](const FleetView& fleet, std::size_t k) { return fleet.COLUMN[k] OF; }), \
      arg("out") = py::none(), "(n, 2) float64, " DOC)
#define NUMBERS(NAME, COLUMN, OF, DOC)                                                     \
  def(NAME,                                                                                \
      per_robot(Columns::COLUMN,                                                           \
                [](const FleetView& fleet, std::size_t k) { return fleet.COLUMN[k] OF; }), \
      arg("out") = py::none(), "(n,) float64, " DOC)

void bind_columns(SimulationClass& simulation) {
  simulation.POINTS("position", position, , "m.")
      .POINTS("velocity", velocity, , "m/s.")
      .POINTS("goal", goal, , "m.")
      .POINTS("new_velocity", plan, .new_velocity, "m/s, of the last decisions.")
      .POINTS("next_velocity", plan, .next_velocity, "m/s, of the last decisions.")
      .POINTS("acceleration", plan, .acceleration, "m/s^2, of the last decisions.")
      .NUMBERS("heading", heading, , "rad, counter-clockwise from +x; 0 of holonomic ones.")
      .NUMBERS("radius", setup, .radius, "m.")
      .NUMBERS("max_speed", setup, .max_speed, "m/s.")
      .NUMBERS("max_acceleration", setup, .max_acceleration, "m/s^2.")
      .NUMBERS("preferred_speed", setup, .preferred_speed, "m/s.")
      .NUMBERS("violation", plan, .violation, "m/s, of the last decisions; 0 if optimal.")
      .NUMBERS("applied_acceleration", applied_acceleration, ,
               "m/s^2, the largest |a| within the last step.");
  simulation
      .def("ids",
           whole<std::int64_t>(Columns::id, [](const FleetView& fleet,
                                               std::size_t k) { return fleet.id[k].value; }),
           "(n,) int64, ascending; never used again.")
      .def("plan_status",
           whole<std::uint8_t>(Columns::plan, [](const FleetView& fleet,
                                                 std::size_t k) { return fleet.plan[k].status; }),
           "(n,) uint8, of the last decisions: indices into PLAN_STATUS.")
      .def("evading",
           whole<bool>(Columns::plan,
                       [](const FleetView& fleet, std::size_t k) { return fleet.plan[k].evading; }),
           "(n,) bool, of the last decisions: whether an evasive maneuver replaced them.")
      .def("plan_state",
           whole<std::uint8_t>(Columns::plan, [](const FleetView& fleet,
                                                 std::size_t k) { return fleet.plan[k].state; }),
           "(n,) uint8, of the last decisions: indices into SAFETY_STATE.")
      .def("moving_obstacle_position", obstacle_points(&avo::MovingObstacleView::position),
           arg("out") = py::none(), "(m, 2) float64, m, of the moving obstacles.")
      .def("moving_obstacle_velocity", obstacle_points(&avo::MovingObstacleView::velocity),
           arg("out") = py::none(), "(m, 2) float64, m/s, of the moving obstacles.")
      .def("moving_obstacle_next_point", told([](const avo::Simulation& s) {
             const auto next = s.moving_obstacles().next_point;
             return std::vector<std::uint32_t>(next.begin(), next.end());
           }),
           "Of each, the position in its path of the point that it moves to, a list.");
}
#undef POINTS
#undef NUMBERS

}  // namespace avo_python
