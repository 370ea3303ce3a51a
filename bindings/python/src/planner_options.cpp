// SPDX-License-Identifier: Apache-2.0
// The options of a planner: arguments and attributes by the table of fields.
#include <tuple>
#include <utility>

#include "core/removed.h"
#include "fields.h"

namespace avo_python {
namespace {

using Options = avo::PlannerOptions;
using Errors = std::pair<double, double>;          // m, m/s
using Noise = std::tuple<double, double, double>;  // m, m/s, standard deviations

template <class Value>
Value given_as(const std::string& key, const py::handle& given) {
  return value_of<Value>("Planner", key, given);
}

/// Refuses an option that there is not, one of earlier versions by what replaces it.
[[noreturn]] void refuse_option(const std::string& key) {
  if (const avo::Removed* gone = avo::removed_key(key))
    throw avo::Error(key + ": found the removed option, must be " + allowed_instead(*gone));
  throw py::type_error("Planner: found the unknown option " + key);
}

void set(Options& options, const std::string& key, const py::handle& given) {
  if (key == "sensing_error") {
    const auto [position, velocity] = given_as<Errors>(key, given);
    options.sensing_error = {position, velocity};
  } else if (key == "sensing_noise") {
    const auto [position, velocity, quantile] = given_as<Noise>(key, given);
    options.sensing_noise = {position, velocity, quantile};
  } else if (key == "wall_range") {
    options.wall_range = given_as<double>(key, given);
  } else {
    bool is_known = false;
    for_each_field(avo_io::planner_fields(), [&](const auto& field, auto member) {
      if (field.key != key) return;
      is_known = true;
      if (!given.is_none())
        options.*member = given_as<std::decay_t<decltype(options.*member)>>(key, given);
    });
    if (!is_known) refuse_option(key);
  }
}

}  // namespace

Options options_of(const py::kwargs& given) {
  const bool has_method = given.contains("method");
  Options options = avo::default_options(
      has_method ? given_as<avo::Method>("method", given["method"]) : avo::Method::avo);
  for (const auto& [name, value] : given) set(options, name.cast<std::string>(), value);
  return options;
}

py::dict arguments_of(const Options& options) {
  py::dict all;
  for_each_field(avo_io::planner_fields(), [&](const auto& field, auto member) {
    all[std::string(field.key).c_str()] = options.*member;
  });
  const auto& [position, velocity, quantile] = options.sensing_noise;
  all["sensing_error"] =
      py::make_tuple(options.sensing_error.position, options.sensing_error.velocity);
  all["sensing_noise"] = py::make_tuple(position, velocity, quantile);
  all["wall_range"] = options.wall_range;
  return all;
}

void bind_options(py::class_<avo::Planner>& planner) {
  std::string all = "Arguments by name, None: what is customary. ";
  for_each_field(avo_io::planner_fields(), [&](const auto& field, auto member) {
    const std::string text = described(field);
    planner.def_property_readonly(
        std::string(field.key).c_str(),
        [member](const avo::Planner& self) { return self.options().*member; }, text.c_str());
    all += fmt::format("{}: {}. ", field.key, text);
  });
  const char* walls = "m, from the robot's disc, within which all walls are given";
  planner.def_property_readonly(
      "wall_range", [](const avo::Planner& self) { return self.options().wall_range; }, walls);
  all += fmt::format(
      "wall_range: {}. sensing_error: (m, m/s). sensing_noise: (m, m/s, standard deviations). "
      "Raises Error on options out of range.",
      walls);
  planner.def(py::init([](const py::kwargs& given) { return avo::Planner(options_of(given)); }),
              all.c_str());
}

}  // namespace avo_python
