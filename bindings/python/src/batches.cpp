// SPDX-License-Identifier: Apache-2.0
// Decisions of many robots at once, from arrays and into arrays.
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <memory>

#include "arrays.h"
#include "workspace.h"

namespace avo_python {
namespace {

using py::arg;
using Whole = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Robots {
  std::vector<avo::Robot> all;
};

/// Those of robot k are all[first[k]] to all[first[k + 1] - 1].
struct Neighbors {
  std::vector<avo::Neighbor> all;
  std::vector<std::size_t> first{0};
};

struct Detours {
  std::vector<avo::Detour> all;
};

struct Plans {
  std::vector<avo::Plan> all;
};

Robots make_robots(const Numbers& position, const Numbers& velocity,
                   const Numbers& preferred_velocity, const Numbers& radius,
                   const Numbers& max_acceleration, const Numbers& max_speed,
                   const Numbers& distance_to_goal, const Numbers& priority) {
  const auto p = rows("position", position), v = rows("velocity", velocity),
             preferred = rows("preferred_velocity", preferred_velocity);
  const auto n = static_cast<py::ssize_t>(p.size());
  const auto require = [&](const char* name, std::span<const avo::Vec2> given) {
    if (given.size() != p.size())
      throw avo::Error(fmt::format("{}: found {} rows, must be {} as of position", name,
                                   given.size(), p.size()));
  };
  require("velocity", v);
  require("preferred_velocity", preferred);
  const PerRobot r("radius", radius, n), a("max_acceleration", max_acceleration, n),
      speed("max_speed", max_speed, n), distance("distance_to_goal", distance_to_goal, n),
      weight("priority", priority, n);
  Robots robots;
  robots.all.reserve(p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    robots.all.push_back({.position = p[k],
                          .velocity = v[k],
                          .preferred_velocity = preferred[k],
                          .radius = r[k],
                          .max_acceleration = a[k],
                          .max_speed = speed[k],
                          .distance_to_goal = distance[k],
                          .priority = weight[k]});
  return robots;
}

/// Offsets of CSR form. Throws Error unless they ascend from 0 to m.
std::vector<std::size_t> checked_offsets(const py::object& object, std::size_t m) {
  const py::array any = py::array::ensure(object);
  const char kind = any ? any.dtype().kind() : '?';
  if (kind != 'i' && kind != 'u')
    throw avo::Error("offsets: found " + std::string(py::repr(object)) + ", must be whole numbers");
  const Whole offsets(any);
  const std::span<const std::int64_t> given(offsets.data(),
                                            static_cast<std::size_t>(offsets.size()));
  const bool good = offsets.ndim() == 1 && !given.empty() && given.front() == 0 &&
                    given.back() == static_cast<std::int64_t>(m) &&
                    std::is_sorted(given.begin(), given.end());
  if (!good)
    throw avo::Error(fmt::format(
        "offsets: found {}, must ascend from 0 to the {} rows of position, one more than robots",
        std::string(py::str(py::object(offsets))), m));
  return {given.begin(), given.end()};
}

Neighbors make_neighbors(const Numbers& position, const Numbers& velocity,
                         const py::object& offsets, const Numbers& radius,
                         const Numbers& max_acceleration, const Numbers& priority,
                         const Numbers& acceleration, const Numbers& moves_on,
                         const Numbers& max_deviation, const Numbers& max_speed) {
  const auto p = rows("position", position), v = rows("velocity", velocity);
  const auto m = static_cast<py::ssize_t>(p.size());
  if (v.size() != p.size())
    throw avo::Error(
        fmt::format("velocity: found {} rows, must be {} as of position", v.size(), p.size()));
  if (acceleration.ndim() == 0 && *acceleration.data() != 0.0)
    throw avo::Error("acceleration: found one number, must be (m, 2), or 0");
  std::vector<avo::Vec2> none(acceleration.ndim() == 0 ? p.size() : 0);
  const auto a = acceleration.ndim() == 0 ? none : rows("acceleration", acceleration);
  if (a.size() != p.size())
    throw avo::Error(
        fmt::format("acceleration: found {} rows, must be {} as of position", a.size(), p.size()));
  const PerRobot r("radius", radius, m), most("max_acceleration", max_acceleration, m),
      weight("priority", priority, m), moves("moves_on", moves_on, m),
      deviation("max_deviation", max_deviation, m), speed("max_speed", max_speed, m);
  Neighbors neighbors;
  neighbors.first = checked_offsets(offsets, p.size());
  neighbors.all.reserve(p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    neighbors.all.push_back(
        {.position = p[k],
         .velocity = v[k],
         .radius = r[k],
         .max_acceleration = most[k],
         .behavior = moves[k] != 0.0 ? avo::Behavior::moves_on : avo::Behavior::decides,
         .priority = weight[k],
         .max_deviation = deviation[k],
         .acceleration = a[k],
         .max_speed = speed[k]});
  return neighbors;
}

/// As each robot senses the others, by (distance, row).
Neighbors among(const Robots& robots, double sensing_radius) {
  if (!(sensing_radius > 0.0))
    throw avo::Error(fmt::format("sensing_radius: found {}, must be > 0 m", sensing_radius));
  const auto& all = robots.all;
  Neighbors neighbors;
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < all.size(); ++i) {
    near.clear();
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double squared = norm_squared(all[j].position - all[i].position);
      if (j != i && squared <= sensing_radius * sensing_radius) near.emplace_back(squared, j);
    }
    std::sort(near.begin(), near.end());
    for (const auto& [squared, j] : near)
      neighbors.all.push_back({.position = all[j].position,
                               .velocity = all[j].velocity,
                               .radius = all[j].radius,
                               .max_acceleration = all[j].max_acceleration,
                               .priority = all[j].priority});
    neighbors.first.push_back(neighbors.all.size());
  }
  return neighbors;
}

Plans plan_all(const avo::Planner& planner, const Robots& robots, const Neighbors& neighbors,
               const std::vector<avo::Wall>& walls, Detours* detours) {
  const std::size_t n = robots.all.size();
  if (neighbors.first.size() != n + 1)
    throw avo::Error(fmt::format("neighbors: found those of {} robots, must be those of {}",
                                 neighbors.first.size() - 1, n));
  if (detours != nullptr && detours->all.size() != n)
    throw avo::Error(fmt::format("detour: found those of {} robots, must be those of {}",
                                 detours->all.size(), n));
  Plans plans;
  plans.all.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::span seen =
        std::span(neighbors.all)
            .subspan(neighbors.first[k], neighbors.first[k + 1] - neighbors.first[k]);
    plans.all.push_back(planner.plan(robots.all[k], seen, workspace(),
                                     detours != nullptr ? &detours->all[k] : nullptr, walls));
  }
  return plans;
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

void bind_inputs(py::module_& module) {
  py::class_<Robots>(module, "Robots", "Many holonomic robots that decide, for Planner.plan().")
      .def(py::init(&make_robots), py::kw_only(), arg("position"), arg("velocity"),
           arg("preferred_velocity"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("max_speed") = 2.0, arg("distance_to_goal") = kInfinity, arg("priority") = 1.0,
           "position: (n, 2), m; velocity, preferred_velocity: (n, 2), m/s. One number, or (n,): "
           "radius, m; max_acceleration, m/s^2; max_speed, m/s; distance_to_goal, m; priority.")
      .def("__len__", [](const Robots& robots) { return robots.all.size(); })
      .def("__getitem__", [](const Robots& robots, std::size_t k) {
        if (k >= robots.all.size()) throw py::index_error();
        return robots.all[k];
      });
  py::class_<Neighbors>(module, "Neighbors", "What many robots sense, for Planner.plan().")
      .def(py::init(&make_neighbors), py::kw_only(), arg("position"), arg("velocity"),
           arg("offsets"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("priority") = 1.0, arg("acceleration") = 0.0, arg("moves_on") = false,
           arg("max_deviation") = 0.0, arg("max_speed") = kInfinity,
           "position: (m, 2), m, and velocity: (m, 2), m/s, of all that all robots sense, robot "
           "after robot; offsets: (n + 1,), those of robot k are rows offsets[k] to offsets[k + 1] "
           "- "
           "1. One number, or (m,): radius, m; max_acceleration, m/s^2; priority; moves_on: reacts "
           "to nobody, and then max_deviation, m/s^2, max_speed, m/s, and acceleration: (m, 2), "
           "m/s^2.")
      .def_static("among", &among, arg("robots"), arg("sensing_radius"),
                  py::call_guard<py::gil_scoped_release>(),
                  "As Robots sense each other within sensing_radius, m, between centers.")
      .def_property_readonly(
          "offsets",
          [](const Neighbors& neighbors) {
            py::array_t<std::int64_t> array(static_cast<py::ssize_t>(neighbors.first.size()));
            std::copy(neighbors.first.begin(), neighbors.first.end(), array.mutable_data());
            return array;
          },
          "(n + 1,) int64, a copy.")
      .def(
          "of",
          [](const Neighbors& neighbors, std::size_t k) {
            if (k + 1 >= neighbors.first.size()) throw py::index_error();
            const auto begin = neighbors.all.begin();
            return std::vector<avo::Neighbor>(
                begin + static_cast<std::ptrdiff_t>(neighbors.first[k]),
                begin + static_cast<std::ptrdiff_t>(neighbors.first[k + 1]));
          },
          arg("robot"), "list of Neighbor, of robot k.");
  py::class_<Detours>(module, "Detours", "What n robots remember, for Planner.plan().")
      .def(py::init([](std::size_t n) { return Detours{std::vector<avo::Detour>(n)}; }), arg("n"))
      .def("__len__", [](const Detours& detours) { return detours.all.size(); })
      .def("__getitem__",
           [](const Detours& detours, std::size_t k) {
             if (k >= detours.all.size()) throw py::index_error();
             return detours.all[k];
           })
      .def("__setitem__", [](Detours& detours, std::size_t k, const avo::Detour& detour) {
        if (k >= detours.all.size()) throw py::index_error();
        detours.all[k] = detour;
      });
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
           "(n,) uint8: indices into SAFETY_STATE.");
}

}  // namespace

void bind_batches(py::module_& module) {
  bind_inputs(module);
  bind_plans(module);
  // another meaning of Planner.plan, which planner.cpp has bound for one robot
  const py::object planner = module.attr("Planner");
  const py::cpp_function batch(
      &plan_all, py::name("plan"), py::is_method(planner), py::sibling(planner.attr("plan")),
      arg("robots"), arg("neighbors"), arg("walls") = py::tuple(), arg("detour") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "The same for Robots, each among its own of Neighbors; walls: all of theirs; detour: "
      "Detours, updated, None: nothing. Every decision has the bits of that of one robot alone.");
  planner.attr("plan") = batch;
}

}  // namespace avo_python
