// SPDX-License-Identifier: Apache-2.0
// What a scene says of a robot: a class with the fields of scene files.
#include <string>

#include "avo_io/nearest.h"
#include "fields.h"
#include "pickles.h"
#include "renamed.h"

namespace avo_python {
namespace {

using Setup = avo::RobotSetup;

constexpr std::string_view kSetup = "RobotSetup";

[[noreturn]] void refuse_key(const std::string& key) {
  if (key == "parked")
    throw py::type_error("RobotSetup: found \"parked\", must be behavior=\"parked\"");
  std::vector<std::string_view> known{"model", "heading"};
  for_each_field(avo_io::robot_fields(),
                 [&](const auto& field, auto) { known.push_back(field.key); });
  throw py::type_error(
      fmt::format("RobotSetup: found \"{}\", {}", key, avo_io::allowed_words(key, known)));
}

void set(Setup& setup, const std::string& key, const py::handle& given) {
  bool is_known = key == "heading";
  if (is_known) setup.heading = value_of<double>(kSetup, key, given);
  for_each_field(avo_io::robot_fields(), [&](const auto& field, auto member) {
    if (field.key != key) return;
    is_known = true;
    setup.*member = value_of<std::decay_t<decltype(setup.*member)>>(kSetup, key, given);
  });
  if (!is_known) refuse_key(key);
}

}  // namespace

void set_fields(Setup& setup, const py::kwargs& given) {
  for (const auto& [name, value] : given)
    if (const auto key = name.cast<std::string>(); key != "model") set(setup, key, value);
  if (given.contains("model"))  // its default offset depends on the radius
    setup.model =
        with_offset(value_of<avo::MotionModel>(kSetup, "model", given["model"]), setup.radius);
}

namespace {

Setup made_of(const py::kwargs& given) {
  Setup setup;
  for_each_field(avo_io::robot_fields(), [&](const auto& field, auto) {
    if (field.is_required && !given.contains(std::string(field.key).c_str()))
      throw py::type_error(fmt::format("RobotSetup: found no {}, must be given", field.key));
  });
  py::kwargs fields = given;
  const bool has_preferred =
      given.contains("preferred_speed") && !given["preferred_speed"].is_none();
  if (!has_preferred && given.contains("preferred_speed")) {
    fields = py::kwargs(given.attr("copy")());
    fields.attr("pop")("preferred_speed");
  }
  set_fields(setup, fields);
  if (!has_preferred) setup.preferred_speed = setup.max_speed;
  return setup;
}

}  // namespace

py::object Plain<Setup>::of(const Setup& setup) {
  py::list values;
  values.append(setup.model);
  values.append(setup.heading);
  for_each_field(avo_io::robot_fields(),
                 [&](const auto&, auto member) { values.append(setup.*member); });
  return py::tuple(values);
}

Setup Plain<Setup>::from(const py::handle& plain) {
  const auto values = plain.cast<py::tuple>();
  std::size_t number = 2;
  for_each_field(avo_io::robot_fields(), [&](const auto&, auto) { ++number; });
  if (values.size() != number) refuse_pickle();
  Setup setup;
  setup.model = values[0].cast<avo::MotionModel>(), setup.heading = values[1].cast<double>();
  std::size_t k = 2;
  for_each_field(avo_io::robot_fields(), [&](const auto&, auto member) {
    setup.*member = values[k++].template cast<std::decay_t<decltype(setup.*member)>>();
  });
  return setup;
}

void bind_setup(py::module_& module) {
  py::class_<Setup> setup(module, "RobotSetup", "What a scene says of a robot.");
  std::string all = "Arguments by name, as in scene files. model: how it moves; heading: rad.";
  for_each_field(avo_io::robot_fields(), [&](const auto& field, auto member) {
    const std::string text = described(field);
    setup.def_readwrite(std::string(field.key).c_str(), member, text.c_str());
    all += fmt::format(" {}: {}.", field.key, text);
  });
  refuse_renamed(setup, {{"parked", "behavior"}});
  setup.def(pickled<Setup>())
      .def(py::init(&made_of), all.c_str())
      .def_property(
          "model", [](const Setup& own) { return own.model; },
          [](Setup& own, avo::MotionModel model) { own.model = with_offset(model, own.radius); },
          "how it moves: Car, DifferentialDrive, Airplane, or None: holonomic")
      .def_readwrite("heading", &Setup::heading, "rad, counter-clockwise from +x");
}

}  // namespace avo_python
