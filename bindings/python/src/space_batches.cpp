// SPDX-License-Identifier: Apache-2.0
// Decisions of many robots of space at once, from arrays and into arrays, as those of the plane.
#include <algorithm>
#include <fmt/format.h>

#include "arrays.h"
#include "avo/space/planner.h"
#include "batches.h"
#include "shared.h"
#include "space.h"

namespace avo_python::space {
namespace {

using avo::Vec3;
using avo::space::Detour;
using avo::space::Neighbor;
using avo::space::Plan;
using avo::space::Planner;
using avo::space::Robot;
using py::arg;

struct SpaceRobots {
  std::vector<Robot> all;
};

/// The neighbors of robot k are all[first[k]] to all[first[k + 1] - 1].
struct SpaceNeighbors {
  std::vector<Neighbor> all;
  std::vector<std::size_t> first{0};
};

/// The number of detours always equals the number of robots. Threads may share them.
struct SpaceDetours : Shared<std::vector<Detour>> {
  explicit SpaceDetours(std::size_t n) : Shared(std::vector<Detour>(n)), size(n) {}
  const std::size_t size;
};

/// What all robots of a batch have around them.
struct Surroundings {
  std::span<const avo::space::Box> boxes;
  std::span<const avo::space::Mover> movers;
};

struct SpacePlans {
  std::vector<Plan> all;
};

/// Reads (n, 3); n of any other rows than `count` are refused, unless there is none yet.
std::vector<Vec3> places(const char* name, const py::object& given,
                         std::optional<std::size_t> count = {}) {
  const Numbers array = numbers(name, given);
  const bool is_empty_list = array.ndim() == 1 && array.size() == 0;
  if (!is_empty_list && (array.ndim() != 2 || array.shape(1) != 3))
    throw avo::Error(fmt::format("{}: found shape {}, must be (n, 3)", name, shape_of(array)));
  const auto n = static_cast<std::size_t>(array.shape(0));
  if (count && n != *count)
    throw avo::Error(fmt::format("{}: found {} rows, must be {} as of position", name, n, *count));
  std::vector<Vec3> all(n);
  for (std::size_t k = 0; k < n; ++k)
    all[k] = {array.data()[3 * k], array.data()[3 * k + 1], array.data()[3 * k + 2]};
  return all;
}

/// One number for each of n, or none.
std::optional<PerRobot> if_given(const char* name, const py::object& given, std::size_t n) {
  return given.is_none() ? std::nullopt : std::optional<PerRobot>(std::in_place, name, given, n);
}
std::optional<double> at(const std::optional<PerRobot>& column, std::size_t k) {
  return column ? std::optional((*column)[k]) : std::nullopt;
}

SpaceRobots make_robots(const py::object& position, const py::object& velocity,
                        const py::object& preferred_velocity, const py::object& radius,
                        const py::object& max_acceleration, const py::object& max_speed,
                        const py::object& vertical, const py::object& climb, const py::object& sink,
                        const py::object& downwash, const py::object& priority,
                        const py::object& max_braking, const py::object& distance_to_goal) {
  const std::vector<Vec3> p = places("position", position);
  const std::size_t n = p.size();
  const std::vector<Vec3> v = places("velocity", velocity, n),
                          preferred = places("preferred_velocity", preferred_velocity, n);
  const PerRobot r("radius", radius, n), a("max_acceleration", max_acceleration, n),
      speed("max_speed", max_speed, n), e("vertical", vertical, n), up("climb", climb, n),
      down("sink", sink, n), wash("downwash", downwash, n), weight("priority", priority, n),
      distance("distance_to_goal", distance_to_goal, n);
  const auto braking = if_given("max_braking", max_braking, n);
  SpaceRobots robots;
  robots.all.reserve(n);
  for (std::size_t k = 0; k < n; ++k)
    robots.all.push_back({p[k], v[k], preferred[k], r[k], a[k], speed[k], e[k], up[k], down[k],
                          wash[k], weight[k], at(braking, k), distance[k]});
  return robots;
}

SpaceNeighbors make_neighbors(const py::object& position, const py::object& velocity,
                              const py::object& offsets, const py::object& radius,
                              const py::object& max_acceleration, const py::object& vertical,
                              const py::object& downwash, const py::object& priority,
                              const py::object& max_braking, const py::object& age) {
  const std::vector<Vec3> p = places("position", position);
  const std::size_t m = p.size();
  const std::vector<Vec3> v = places("velocity", velocity, m);
  const PerRobot r("radius", radius, m), a("max_acceleration", max_acceleration, m),
      e("vertical", vertical, m), wash("downwash", downwash, m), weight("priority", priority, m),
      ages("age", age, m);
  const auto braking = if_given("max_braking", max_braking, m);
  SpaceNeighbors neighbors;
  neighbors.first = checked_offsets(offsets, m);
  neighbors.all.reserve(m);
  for (std::size_t k = 0; k < m; ++k)
    neighbors.all.push_back(
        {p[k], v[k], r[k], a[k], e[k], wash[k], weight[k], at(braking, k), checked_age(ages[k])});
  return neighbors;
}

/// Returns the neighbors that each robot senses, sorted by row, as a simulation has them.
SpaceNeighbors among(const SpaceRobots& robots, double sensing_radius) {
  if (!(sensing_radius > 0.0))
    throw avo::Error(fmt::format("sensing_radius: found {}, must be > 0 m", sensing_radius));
  SpaceNeighbors neighbors;
  for (const Robot& own : robots.all) {
    for (const Robot& other : robots.all) {
      if (&other == &own ||
          !(norm_squared(other.position - own.position) <= sensing_radius * sensing_radius))
        continue;
      neighbors.all.push_back(neighbor_of(other));
    }
    neighbors.first.push_back(neighbors.all.size());
  }
  return neighbors;
}

SpacePlans plan_all(const Planner& planner, const SpaceRobots& robots,
                    const SpaceNeighbors& neighbors, const Surroundings& around, Detour* detours) {
  avo::space::PlanWorkspace workspace;
  SpacePlans plans;
  plans.all.reserve(robots.all.size());
  for (std::size_t k = 0; k < robots.all.size(); ++k) {
    const std::span seen =
        std::span(neighbors.all)
            .subspan(neighbors.first[k], neighbors.first[k + 1] - neighbors.first[k]);
    plans.all.push_back(planner.plan(robots.all[k], seen, workspace,
                                     detours != nullptr ? &detours[k] : nullptr, around.boxes,
                                     around.movers));
  }
  return plans;
}

SpacePlans plan_batch(const Planner& planner, const SpaceRobots& robots,
                      const SpaceNeighbors& neighbors, const std::vector<avo::space::Box>& boxes,
                      SpaceDetours* detours, const std::vector<avo::space::Mover>& movers) {
  const std::size_t n = robots.all.size();
  if (neighbors.first.size() != n + 1)
    throw avo::Error(fmt::format("neighbors: found those of {} robots, must be those of {}",
                                 neighbors.first.size() - 1, n));
  if (detours != nullptr && detours->size != n)
    throw avo::Error(
        fmt::format("detour: found those of {} robots, must be those of {}", detours->size, n));
  if (detours != nullptr)
    return detours->alone([&](std::vector<Detour>& remembered) {
      return plan_all(planner, robots, neighbors, {boxes, movers}, remembered.data());
    });
  const py::gil_scoped_release release;
  return plan_all(planner, robots, neighbors, {boxes, movers}, nullptr);
}

template <typename Of>  // Vec3 of(plan)
auto points_of_plans(Of of) {
  return [of](const SpacePlans& plans) {
    return rows_of_space(plans.all.size(), [&](std::size_t k) { return of(plans.all[k]); });
  };
}

template <typename Value, typename Of>
auto column_of_plans(Of of) {
  return [of](const SpacePlans& plans) {
    py::array_t<Value> array(static_cast<py::ssize_t>(plans.all.size()));
    for (std::size_t k = 0; k < plans.all.size(); ++k)
      array.mutable_data()[k] = static_cast<Value>(of(plans.all[k]));
    return array;
  };
}

void bind_inputs(py::module_& module) {
  py::class_<SpaceRobots>(module, "Robots", "Many robots that decide, for Planner.plan().")
      .def(py::init(&make_robots), py::kw_only(), arg("position"), arg("velocity"),
           arg("preferred_velocity"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("max_speed") = 2.0, arg("vertical") = 1.0, arg("climb") = kInfinity,
           arg("sink") = kInfinity, arg("downwash") = 0.0, arg("priority") = 1.0,
           arg("max_braking") = py::none(), arg("distance_to_goal") = kInfinity,
           "position: (n, 3), m; velocity, preferred_velocity: (n, 3), m/s. One number, or (n,): "
           "the others, as those of Robot.")
      .def("__len__", [](const SpaceRobots& robots) { return robots.all.size(); })
      .def("__getitem__", [](const SpaceRobots& robots, std::size_t k) {
        if (k >= robots.all.size()) throw py::index_error();
        return robots.all[k];
      });
  py::class_<SpaceNeighbors>(module, "Neighbors", "What many robots sense, for Planner.plan().")
      .def(py::init(&make_neighbors), py::kw_only(), arg("position"), arg("velocity"),
           arg("offsets"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("vertical") = 1.0, arg("downwash") = 0.0, arg("priority") = 1.0,
           arg("max_braking") = py::none(), arg("age") = 0,
           "position: (m, 3), m, and velocity: (m, 3), m/s, of all that all robots sense, robot "
           "after robot; offsets: (n + 1,), those of robot k are rows offsets[k] to offsets[k + 1] "
           "- 1. One number, or (m,): the others, as those of Neighbor.")
      .def_static("among", &among, arg("robots"), arg("sensing_radius"),
                  py::call_guard<py::gil_scoped_release>(),
                  "As Robots sense each other within sensing_radius, m, between centers.")
      .def_property_readonly(
          "offsets",
          [](const SpaceNeighbors& self) {
            py::array_t<std::int64_t> array(static_cast<py::ssize_t>(self.first.size()));
            std::copy(self.first.begin(), self.first.end(), array.mutable_data());
            return array;
          },
          "(n + 1,) int64, a copy.");
  py::class_<SpaceDetours>(module, "Detours",
                           "What n robots remember, for Planner.plan(). Threads may share it: one "
                           "uses it at a time, the others wait.")
      .def(py::init<std::size_t>(), arg("n"))
      .def("__len__", [](const SpaceDetours& detours) { return detours.size; })
      .def("__getitem__",
           [](SpaceDetours& detours, std::size_t k) {
             if (k >= detours.size) throw py::index_error();
             return detours.briefly([k](const auto& all) { return all[k]; });
           })
      .def("__setitem__", [](SpaceDetours& detours, std::size_t k, const Detour detour) {
        if (k >= detours.size) throw py::index_error();
        detours.alone([&](auto& all) { all[k] = detour; });
      });
}

}  // namespace

void bind_batches(py::module_& module) {
  bind_inputs(module);
  py::class_<SpacePlans>(module, "Plans", "Decisions of n robots, as arrays.")
      .def("__len__", [](const SpacePlans& plans) { return plans.all.size(); })
      .def("__getitem__",
           [](const SpacePlans& plans, std::size_t k) {
             if (k >= plans.all.size()) throw py::index_error();
             return plans.all[k];
           })
      .def("new_velocity", points_of_plans([](const Plan& plan) { return plan.new_velocity; }),
           "(n, 3) float64, m/s.")
      .def("next_velocity", points_of_plans([](const Plan& plan) { return plan.next_velocity; }),
           "(n, 3) float64, m/s.")
      .def("acceleration", points_of_plans([](const Plan& plan) { return plan.acceleration; }),
           "(n, 3) float64, m/s^2.")
      .def("violation", column_of_plans<double>([](const Plan& plan) { return plan.violation; }),
           "(n,) float64, m/s.")
      .def("status", column_of_plans<std::uint8_t>([](const Plan& plan) { return plan.status; }),
           "(n,) uint8: indices into PLAN_STATUS.")
      .def("state", column_of_plans<std::uint8_t>([](const Plan& plan) { return plan.state; }),
           "(n,) uint8: indices into SAFETY_STATE.");
  // another overload of Planner.plan, which space_planner.cpp has bound for one robot
  const py::object planner = module.attr("Planner");
  planner.attr("plan") = py::cpp_function(
      &plan_batch, py::name("plan"), py::is_method(planner), py::sibling(planner.attr("plan")),
      arg("robots"), arg("neighbors"), arg("boxes") = py::tuple(), arg("detour") = py::none(),
      arg("movers") = py::tuple(),
      "The same for Robots, each among its own of Neighbors; boxes, movers: all of theirs; detour: "
      "Detours, updated, None: nothing. Every decision has the bits of that of one robot alone.");
}

}  // namespace avo_python::space
