// SPDX-License-Identifier: Apache-2.0
// Reads many robots, and what each of them senses and remembers, from arrays.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include "arrays.h"
#include "batches.h"

namespace avo_python {

int checked_age(double age) {
  if (age != std::floor(age) || age < 0.0 || age > avo::kMostAge)
    throw avo::Error(
        fmt::format("age: found {}, must be a whole number, 0 to {}", age, avo::kMostAge));
  return static_cast<int>(age);
}

std::vector<std::size_t> checked_offsets(const py::object& object, std::size_t m) {
  const py::array any = py::array::ensure(object);
  const char kind = any ? any.dtype().kind() : '?';
  if (kind != 'i' && kind != 'u')
    throw avo::Error("offsets: found " + std::string(py::repr(object)) + ", must be whole numbers");
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> offsets(any);
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

namespace {

using py::arg;

/// Throws Error for any other field: one that only a single robot has, or one that does not exist.
void refuse_fields(const py::kwargs& others, const std::vector<std::string_view>& known) {
  constexpr std::string_view kOfOne[] = {"model",     "heading", "loiter", "trajectory",
                                         "footprint", "ahead",   "spread"};
  for (const auto& [key, value] : others) {
    const auto field = key.cast<std::string>();
    if (std::find(std::begin(kOfOne), std::end(kOfOne), field) == std::end(kOfOne))
      refuse_word("field", field, known);
    throw avo::Error(field +
                     ": found in a batch, must be left out: robots of other models than holonomic, "
                     "and those that sense airplanes or know of trajectories, plan one by one");
  }
}

/// Columns of n rows.
struct Columns {
  std::size_t n;

  /// Reads one point for each row.
  [[nodiscard]] std::vector<avo::Vec2> points(const char* name, const py::object& given) const {
    const Numbers array = numbers(name, given);
    const auto all = rows(name, array);
    if (all.size() != n)
      throw avo::Error(
          fmt::format("{}: found {} rows, must be {} as of position", name, all.size(), n));
    return {all.begin(), all.end()};
  }
  [[nodiscard]] PerRobot of(const char* name, const py::object& given) const {
    return {name, given, n};
  }
  /// Returns none if `given` is None: no robot has the value.
  [[nodiscard]] std::optional<PerRobot> if_given(const char* name, const py::object& given) const {
    return given.is_none() ? std::nullopt : std::optional(of(name, given));
  }
};

std::optional<double> at(const std::optional<PerRobot>& column, std::size_t k) {
  return column ? std::optional((*column)[k]) : std::nullopt;
}

Robots make_robots(const py::object& position, const py::object& velocity,
                   const py::object& preferred_velocity, const py::object& radius,
                   const py::object& max_acceleration, const py::object& max_speed,
                   const py::object& distance_to_goal, const py::object& priority,
                   const py::object& max_braking, const py::kwargs& others) {
  refuse_fields(others, {"position", "velocity", "preferred_velocity", "radius", "max_acceleration",
                         "max_speed", "distance_to_goal", "priority", "max_braking"});
  const Numbers places = numbers("position", position);
  const auto p = rows("position", places);
  const Columns columns{p.size()};
  const auto v = columns.points("velocity", velocity),
             preferred = columns.points("preferred_velocity", preferred_velocity);
  const PerRobot r = columns.of("radius", radius),
                 a = columns.of("max_acceleration", max_acceleration),
                 speed = columns.of("max_speed", max_speed),
                 distance = columns.of("distance_to_goal", distance_to_goal),
                 weight = columns.of("priority", priority);
  const auto braking = columns.if_given("max_braking", max_braking);
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
                          .priority = weight[k],
                          .max_braking = at(braking, k)});
  return robots;
}

/// Reads (m, 2), or returns 0 for all.
std::vector<avo::Vec2> accelerations(const Columns& columns, const py::object& given) {
  const Numbers array = numbers("acceleration", given);
  if (array.ndim() > 0) return columns.points("acceleration", array);
  if (*array.data() != 0.0)
    throw avo::Error("acceleration: found one number, must be (m, 2), or 0");
  return std::vector<avo::Vec2>(columns.n);
}

avo::Behavior behavior_of(bool moves_on, bool cooperates) {
  if (moves_on && cooperates)
    throw avo::Error("cooperates: found True for a neighbor that moves on, must be False");
  if (moves_on) return avo::Behavior::moves_on;
  return cooperates ? avo::Behavior::cooperates : avo::Behavior::decides;
}

Neighbors make_neighbors(const py::object& position, const py::object& velocity,
                         const py::object& offsets, const py::object& radius,
                         const py::object& max_acceleration, const py::object& priority,
                         const py::object& acceleration, const py::object& moves_on,
                         const py::object& cooperates, const py::object& max_deviation,
                         const py::object& max_speed, const py::object& age,
                         const py::object& max_braking, const py::object& position_error,
                         const py::object& likely_deviation, const py::kwargs& others) {
  refuse_fields(others, {"position", "velocity", "offsets", "radius", "max_acceleration",
                         "priority", "acceleration", "moves_on", "cooperates", "max_deviation",
                         "max_speed", "age", "max_braking", "position_error", "likely_deviation"});
  const Numbers places = numbers("position", position);
  const auto p = rows("position", places);
  const Columns columns{p.size()};
  const auto v = columns.points("velocity", velocity), a = accelerations(columns, acceleration);
  const PerRobot r = columns.of("radius", radius),
                 most = columns.of("max_acceleration", max_acceleration),
                 weight = columns.of("priority", priority),
                 moves = columns.of("moves_on", moves_on),
                 shares = columns.of("cooperates", cooperates),
                 deviation = columns.of("max_deviation", max_deviation),
                 speed = columns.of("max_speed", max_speed), ages = columns.of("age", age),
                 error = columns.of("position_error", position_error),
                 likely = columns.of("likely_deviation", likely_deviation);
  const auto braking = columns.if_given("max_braking", max_braking);
  Neighbors neighbors;
  neighbors.first = checked_offsets(offsets, p.size());
  neighbors.all.reserve(p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    neighbors.all.push_back({.position = p[k],
                             .velocity = v[k],
                             .radius = r[k],
                             .max_acceleration = most[k],
                             .behavior = behavior_of(moves[k] != 0.0, shares[k] != 0.0),
                             .age = checked_age(ages[k]),
                             .priority = weight[k],
                             .max_braking = at(braking, k),
                             .max_deviation = deviation[k],
                             .position_error = error[k],
                             .acceleration = a[k],
                             .max_speed = speed[k],
                             .likely_deviation = likely[k]});
  return neighbors;
}

/// Returns the neighbors that each robot senses, sorted by (distance, row).
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
    for (const auto& [squared, j] : near) {
      const bool coincide =
          all[j].position == all[i].position && all[j].velocity == all[i].velocity;
      neighbors.all.push_back({.position = all[j].position,
                               .velocity = all[j].velocity,
                               .radius = all[j].radius,
                               .max_acceleration = all[j].max_acceleration,
                               .priority = all[j].priority,
                               .max_braking = all[j].max_braking,
                               .parting = coincide ? avo::parting_direction(i, j) : avo::Vec2{}});
    }
    neighbors.first.push_back(neighbors.all.size());
  }
  return neighbors;
}

void bind_neighbors(py::class_<Neighbors>& neighbors) {
  neighbors
      .def(py::init(&make_neighbors), py::kw_only(), arg("position"), arg("velocity"),
           arg("offsets"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("priority") = 1.0, arg("acceleration") = 0.0, arg("moves_on") = false,
           arg("cooperates") = false, arg("max_deviation") = 0.0, arg("max_speed") = kInfinity,
           arg("age") = 0, arg("max_braking") = py::none(), arg("position_error") = 0.0,
           arg("likely_deviation") = 0.0,
           "position: (m, 2), m, and velocity: (m, 2), m/s, of all that all robots sense, robot "
           "after robot; offsets: (n + 1,), those of robot k are rows offsets[k] to offsets[k + 1] "
           "- 1. One number, or (m,): radius, m; max_acceleration, m/s^2; priority; moves_on: "
           "reacts to no robot, cooperates: does its share and promises nothing; then "
           "max_deviation, "
           "m/s^2, max_speed, m/s, and acceleration: (m, "
           "2), m/s^2; age, steps since it was sensed; max_braking, m/s^2, None: "
           "max_acceleration; position_error, m; likely_deviation, m/s^2. Those that sense "
           "airplanes plan one by one.")
      .def_static("among", &among, arg("robots"), arg("sensing_radius"),
                  py::call_guard<py::gil_scoped_release>(),
                  "As Robots sense each other within sensing_radius, m, between centers.")
      .def_property_readonly(
          "offsets",
          [](const Neighbors& self) {
            py::array_t<std::int64_t> array(static_cast<py::ssize_t>(self.first.size()));
            std::copy(self.first.begin(), self.first.end(), array.mutable_data());
            return array;
          },
          "(n + 1,) int64, a copy.")
      .def(
          "of",
          [](const Neighbors& self, std::size_t k) {
            if (k + 1 >= self.first.size()) throw py::index_error();
            const std::span all(self.all);
            const auto seen = all.subspan(self.first[k], self.first[k + 1] - self.first[k]);
            return std::vector<avo::Neighbor>(seen.begin(), seen.end());
          },
          arg("robot"), "list of Neighbor, of robot k.");
}

}  // namespace

void bind_batch_inputs(py::module_& module) {
  py::class_<Robots>(module, "Robots", "Many holonomic robots that decide, for Planner.plan().")
      .def(py::init(&make_robots), py::kw_only(), arg("position"), arg("velocity"),
           arg("preferred_velocity"), arg("radius") = 0.5, arg("max_acceleration") = 1.0,
           arg("max_speed") = 2.0, arg("distance_to_goal") = kInfinity, arg("priority") = 1.0,
           arg("max_braking") = py::none(),
           "position: (n, 2), m; velocity, preferred_velocity: (n, 2), m/s. One number, or (n,): "
           "radius, m; max_acceleration, m/s^2; max_speed, m/s; distance_to_goal, m; priority; "
           "max_braking, m/s^2, None: max_acceleration. Robots of other models plan one by one.")
      .def("__len__", [](const Robots& robots) { return robots.all.size(); })
      .def("__getitem__", [](const Robots& robots, std::size_t k) {
        if (k >= robots.all.size()) throw py::index_error();
        return robots.all[k];
      });
  py::class_<Neighbors> neighbors(module, "Neighbors",
                                  "What many robots sense, for Planner.plan().");
  bind_neighbors(neighbors);
  py::class_<Detours>(module, "Detours",
                      "What n robots remember, for Planner.plan(). Threads may share it: one uses "
                      "it at a time, the others wait.")
      .def(py::init<std::size_t>(), arg("n"))
      .def("__len__", [](const Detours& detours) { return detours.size; })
      .def("__getitem__",
           [](Detours& detours, std::size_t k) {
             if (k >= detours.size) throw py::index_error();
             return detours.briefly([k](const auto& all) { return all[k]; });
           })
      .def("__setitem__",
           [](Detours& detours, std::size_t k, const avo::Detour detour) {  // their present values
             if (k >= detours.size) throw py::index_error();
             detours.alone([&](auto& all) { all[k] = detour; });
           });
}

}  // namespace avo_python
