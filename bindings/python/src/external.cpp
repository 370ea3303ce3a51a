// SPDX-License-Identifier: Apache-2.0
#include "external.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <span>

#include "arrays.h"

namespace avo_python {
namespace {

using py::arg;

py::array_t<double> array_of(std::span<const avo::Vec2> values) {
  py::array_t<double> array({static_cast<py::ssize_t>(values.size()), py::ssize_t{2}});
  fill(array, values);
  return array;
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

template <typename Value>
py::array_t<std::int64_t> indices_of(std::span<const Value> values) {
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(values.size()));
  std::transform(values.begin(), values.end(), array.mutable_data(),
                 [](Value value) { return static_cast<std::int64_t>(value); });
  return array;
}

py::object batch_of(const avo::MethodBatch& batch) {
  avo::MethodColumns columns;
  columns.take(batch);
  return py::module_::import("avo._method")
      .attr("MethodBatch")(
          arg("time") = batch.time, arg("time_step") = batch.time_step,
          arg("id") = indices_of(std::span<const std::uint64_t>(columns.id)),
          arg("position") = array_of(columns.position),
          arg("velocity") = array_of(columns.velocity),
          arg("preferred_velocity") = array_of(columns.preferred_velocity),
          arg("goal") = array_of(batch.goal), arg("radius") = array_of(columns.radius),
          arg("max_speed") = array_of(columns.max_speed),
          arg("max_acceleration") = array_of(columns.max_acceleration),
          arg("max_braking") = array_of(columns.max_braking),
          arg("heading") = array_of(columns.heading),
          arg("first_neighbor") = indices_of(batch.first_neighbor),
          arg("first_wall") = indices_of(batch.first_wall),
          arg("neighbor_position") = array_of(columns.neighbor_position),
          arg("neighbor_velocity") = array_of(columns.neighbor_velocity),
          arg("neighbor_radius") = array_of(columns.neighbor_radius),
          arg("neighbor_max_acceleration") = array_of(columns.neighbor_max_acceleration),
          arg("wall_a") = array_of(columns.wall_a), arg("wall_b") = array_of(columns.wall_b),
          arg("wall_radius") = array_of(columns.wall_radius));
}

}  // namespace

Output output_of(const std::string& word) {
  if (word == "velocity") return Output::velocity;
  if (word == "acceleration") return Output::acceleration;
  throw avo::Error(
      fmt::format("output: found \"{}\", must be \"velocity\" or \"acceleration\"", word));
}

avo::ExternalMethod external_of(const py::object& function, Output output) {
  if (function.is_none()) return {};
  if (!py::isinstance<py::function>(function) && PyCallable_Check(function.ptr()) == 0)
    throw py::type_error("function: must be one that takes a MethodBatch");
  // copies of the method are made and dropped without Python's lock
  const std::shared_ptr<py::object> held(new py::object(function), [](py::object* own) {
    const py::gil_scoped_acquire acquire;
    delete own;
  });
  avo::ExternalMethod method = [held](const avo::MethodBatch& batch,
                                      std::span<avo::Vec2> velocities) {
    const py::gil_scoped_acquire acquire;
    const Numbers chosen = numbers("external method", (*held)(batch_of(batch)));
    const auto n = static_cast<py::ssize_t>(batch.size());
    if (chosen.ndim() != 2 || chosen.shape(0) != n || chosen.shape(1) != 2)
      throw avo::Error(
          fmt::format("external method: found shape {}, must be ({}, 2)", shape_of(chosen), n));
    std::ranges::copy(rows("external method", chosen), velocities.begin());
  };
  return output == Output::velocity ? method : avo::by_acceleration(std::move(method));
}

avo::Scenario with_method(const avo::Scenario& scenario, const std::string& name,
                          const py::object& function, bool clamped, bool certified,
                          const std::string& output) {
  avo::Scenario result = scenario;
  result.method = clamped ? avo::Method::external_clamped : avo::Method::external;
  result.certificate = certified ? avo::Certificate::braking_trajectories : avo::Certificate::none;
  result.external_method = name;
  result.external = external_of(function, output_of(output));
  avo::validate(result);
  return result;
}

}  // namespace avo_python
