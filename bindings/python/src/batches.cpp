// SPDX-License-Identifier: Apache-2.0
// Decisions of many robots at once, from arrays and into arrays.
#include "batches.h"

#include <fmt/format.h>

#include "arrays.h"
#include "workspace.h"

namespace avo_python {
namespace {

using py::arg;

struct Plans {
  std::vector<avo::Plan> all;
};

Plans plan_all(const avo::Planner& planner, const Robots& robots, const Neighbors& neighbors,
               const std::vector<avo::Wall>& walls, avo::Detour* detours) {
  Plans plans;
  plans.all.reserve(robots.all.size());
  for (std::size_t k = 0; k < robots.all.size(); ++k) {
    const std::span seen =
        std::span(neighbors.all)
            .subspan(neighbors.first[k], neighbors.first[k + 1] - neighbors.first[k]);
    plans.all.push_back(planner.plan(robots.all[k], seen, workspace(),
                                     detours != nullptr ? &detours[k] : nullptr, walls));
  }
  return plans;
}

Plans plan_batch(const avo::Planner& planner, const Robots& robots, const Neighbors& neighbors,
                 const std::vector<avo::Wall>& walls, Detours* detours) {
  const std::size_t n = robots.all.size();
  if (neighbors.first.size() != n + 1)
    throw avo::Error(fmt::format("neighbors: found those of {} robots, must be those of {}",
                                 neighbors.first.size() - 1, n));
  if (detours != nullptr && detours->size != n)
    throw avo::Error(
        fmt::format("detour: found those of {} robots, must be those of {}", detours->size, n));
  if (detours != nullptr)
    return detours->alone([&](std::vector<avo::Detour>& remembered) {
      return plan_all(planner, robots, neighbors, walls, remembered.data());
    });
  const py::gil_scoped_release release;
  return plan_all(planner, robots, neighbors, walls, nullptr);
}

template <typename Of>
auto points(Of of) {
  return [of](const Plans& plans, const Out& out) {
    auto array = target(out, {static_cast<py::ssize_t>(plans.all.size()), 2});
    std::vector<avo::Vec2> values;
    for (const avo::Plan& plan : plans.all) values.push_back(of(plan));
    fill(array, values);
    return array;
  };
}

template <typename Of>
auto indices(Of of) {
  return [of](const Plans& plans) {
    py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(plans.all.size()));
    for (std::size_t k = 0; k < plans.all.size(); ++k)
      array.mutable_data()[k] = static_cast<std::uint8_t>(of(plans.all[k]));
    return array;
  };
}

void bind_plans(py::module_& module) {
  py::class_<Plans>(module, "Plans", "Decisions of n robots, as arrays.")
      .def("__len__", [](const Plans& plans) { return plans.all.size(); })
      .def("__getitem__",
           [](const Plans& plans, std::size_t k) {
             if (k >= plans.all.size()) throw py::index_error();
             return plans.all[k];
           })
      .def("new_velocity", points([](const avo::Plan& plan) { return plan.new_velocity; }),
           arg("out") = py::none(), "(n, 2) float64, m/s.")
      .def("next_velocity", points([](const avo::Plan& plan) { return plan.next_velocity; }),
           arg("out") = py::none(), "(n, 2) float64, m/s.")
      .def("acceleration", points([](const avo::Plan& plan) { return plan.acceleration; }),
           arg("out") = py::none(), "(n, 2) float64, m/s^2.")
      .def(
          "violation",
          [](const Plans& plans, const Out& out) {
            auto array = target(out, {static_cast<py::ssize_t>(plans.all.size())});
            std::vector<double> values;
            for (const avo::Plan& plan : plans.all) values.push_back(plan.violation);
            fill(array, std::span<const double>(values));
            return array;
          },
          arg("out") = py::none(), "(n,) float64, m/s.")
      .def("status", indices([](const avo::Plan& plan) { return plan.status; }),
           "(n,) uint8: indices into PLAN_STATUS.")
      .def("state", indices([](const avo::Plan& plan) { return plan.state; }),
           "(n,) uint8: indices into SAFETY_STATE.")
      .def(
          "evading",
          [](const Plans& plans) {
            py::array_t<bool> array(static_cast<py::ssize_t>(plans.all.size()));
            for (std::size_t k = 0; k < plans.all.size(); ++k)
              array.mutable_data()[k] = plans.all[k].evading;
            return array;
          },
          "(n,) bool: whether an evasive maneuver replaced the choice.");
}

}  // namespace

void bind_batches(py::module_& module) {
  bind_batch_inputs(module);
  bind_plans(module);
  // another overload of Planner.plan, which planner.cpp has bound for one robot
  const py::object planner = module.attr("Planner");
  const py::cpp_function batch(
      &plan_batch, py::name("plan"), py::is_method(planner), py::sibling(planner.attr("plan")),
      arg("robots"), arg("neighbors"), arg("walls") = py::tuple(), arg("detour") = py::none(),
      "The same for Robots, each among its own of Neighbors; walls: all of theirs; detour: "
      "Detours, updated, None: nothing. Every decision has the bits of that of one robot alone.");
  planner.attr("plan") = batch;
}

}  // namespace avo_python
