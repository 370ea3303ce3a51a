// SPDX-License-Identifier: Apache-2.0
// Scenes of any origin; all go through the reader of scene files.
#include <filesystem>
#include <fmt/format.h>
#include <pybind11/eval.h>
#include <utility>

#include "avo/assumptions.h"
#include "avo/reachability.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "external.h"
#include "fields.h"
#include "pickles.h"

namespace avo_python {

std::string json_of(const py::handle& value) {
  constexpr const char* kPlain = "lambda value: value.tolist()";
  try {
    return py::module_::import("json")
        .attr("dumps")(value, py::arg("ensure_ascii") = false,
                       py::arg("default") = py::eval(kPlain))
        .cast<std::string>();
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_AttributeError)) throw;
    throw py::type_error(
        "scene: found a value that is no number, text, list, dict or array of numbers");
  }
}

namespace {

std::string override_of(const py::handle& entry) {
  if (!py::isinstance<py::str>(entry))
    throw py::type_error("overrides: found an entry that is no \"key=value\"");
  return entry.cast<std::string>();
}

}  // namespace

std::vector<std::string> overrides_of(const py::object& overrides) {
  std::vector<std::string> all;
  if (overrides.is_none()) return all;
  if (py::isinstance<py::list>(overrides) || py::isinstance<py::tuple>(overrides)) {
    for (const py::handle entry : overrides) all.push_back(override_of(entry));
    return all;
  }
  if (!py::isinstance<py::dict>(overrides))
    throw py::type_error("overrides: must be a dict by keys, or a list of \"key=value\"");
  for (const auto& [key, value] : overrides.cast<py::dict>())
    all.push_back(py::str(key).cast<std::string>() + "=" +
                  (py::isinstance<py::str>(value) ? value.cast<std::string>() : json_of(value)));
  return all;
}

namespace {

using avo::Scenario;
using py::arg;

Scenario parse(const std::string& yaml, const std::string& file, const py::object& overrides) {
  const auto all = overrides_of(overrides);
  const py::gil_scoped_release release;
  return avo_io::parse_scenario(yaml, file, all);
}

Scenario load(const std::string& name, const py::object& overrides, avo_io::SceneSource& source) {
  if (name == "-")
    throw avo::Error("scene: found \"-\", must be a name or a file; see from_yaml()");
  const auto all = overrides_of(overrides);
  Scenario scenario = [&] {
    const py::gil_scoped_release release;
    return avo_io::load_scenario(name, all, &source);
  }();
  for (const std::string& note : source.notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  return scenario;
}

py::list out_of_reach_of(const Scenario& scenario) {
  py::list list;
  for (const avo::OutOfReach& one : avo::out_of_reach(scenario)) {
    py::dict entry;
    entry["robot"] = one.robot.value;
    entry["nearest"] = one.nearest;
    entry["distance_left"] = one.distance_left;
    entry["is_in_wall"] = one.is_in_wall;
    entry["counts_as_there"] = one.counts_as_there;
    list.append(entry);
  }
  return list;
}

py::dict broken_of(const Scenario& scenario) {
  const avo::BrokenAssumptions broken = avo::broken_assumptions(scenario);
  py::dict counts;
  counts["starts"] = broken.start_count;
  counts["beside"] = broken.beside_count;
  counts["misplaced"] = broken.misplaced_count;
  counts["fast"] = broken.fast_count;
  if (broken.unseen)
    counts["unseen"] = broken.unseen->range;
  else
    counts["unseen"] = py::none();
  return counts;
}

std::vector<std::pair<std::string, std::string>> builtin_scenes() {
  std::vector<std::pair<std::string, std::string>> scenes;
  for (const avo_io::BuiltinScene& scene : avo_io::builtin_scenes())
    scenes.emplace_back(scene.name, scene.description);
  return scenes;
}

}  // namespace

std::string path_of(const py::object& path) {
  const std::string bytes = py::module_::import("os").attr("fsencode")(path).cast<std::string>();
  if (bytes.find('\0') != std::string::npos)
    throw avo::Error("path: found a null character, must have none");
  return bytes;
}

std::string recording_path(const py::object& path) {
  const std::string name = path_of(path);
  const std::string ending = std::filesystem::path(name).extension().string();
  if (!ending.empty() && ending != ".csv" && !avo_io::is_hdf5_path(name))
    throw avo::Error(fmt::format("record: found the ending {}, must be .csv, .h5 or none",
                                 avo_io::printable(ending)));
  return name;
}

Scenario scenario_of(const py::object& source, const py::object& overrides,
                     avo_io::SceneSource* made_of) {
  if (py::isinstance<Scenario>(source)) {
    if (overrides.is_none()) return source.cast<Scenario>();
    throw avo::Error("overrides: found beside a Scenario, must be given where it is made");
  }
  avo_io::SceneSource own;
  avo_io::SceneSource& texts = made_of != nullptr ? *made_of : own;
  if (!py::isinstance<py::dict>(source)) return load(path_of(source), overrides, texts);
  texts.name = "dict", texts.yaml = json_of(source), texts.overrides = overrides_of(overrides);
  return parse(texts.yaml, texts.name, overrides);
}

void bind_scenario(py::module_& module) {
  py::class_<Scenario> scene(module, "Scenario",
                             "A scene: robots, obstacles, and how they are simulated. Read only.");
  bind_fields(scene, avo_io::scene_fields(), "sensing_radius");
  scene
      .def(py::init([](const py::object& source, const py::object& overrides) {
             return scenario_of(source, overrides);
           }),
           arg("source"), arg("overrides") = py::none(),
           "source: name of a built-in scene, path of a scene file, or a dict with the keys of "
           "scene files. overrides: {\"robots.0.radius\": 0.4}, or [\"robots.0.radius=0.4\"]. "
           "Raises Error with the reader's message, and warns of what is left out of the files of "
           "a scene file.")
      .def(pickled<Scenario>(&avo::validate))
      .def_static("from_yaml", &parse, arg("text"), arg("file") = "text",
                  arg("overrides") = py::none(),
                  "From the text of a scene file. file: stands in front of messages, and files "
                  "that the scene names are relative to it, or else built in.")
      .def_property_readonly("sensing_radius", &avo::sensing_radius_of,
                             "m, between centers; what the robots need where the scene names none")
      .def_property_readonly("needed_sensing_radius", &avo::needed_sensing_radius,
                             "m: the sensing radius that its robots need, whatever it names")
      .def(
          "with_method", &with_method, arg("name"), arg("function"), py::kw_only(),
          arg("clamped") = true, arg("certified") = false, arg("output") = "velocity",
          "The same scene with a method of your own for all robots that name none. function: is "
          "called once a step with a MethodBatch of n robots, and returns (n, 2): velocities, m/s, "
          "or, by output, accelerations, m/s^2. clamped: the velocity takes the part that "
          "max_acceleration allows within a step. certified: the certificate is behind it, only "
          "where it is clamped.")
      .def_readonly("robots", &Scenario::robots, "list of RobotSetup, a copy")
      .def_readonly("moving_obstacles", &Scenario::moving_obstacles, "list, a copy")
      .def_readonly("obstacles", &Scenario::obstacles, "list of StaticObstacle, a copy")
      .def_property_readonly(
          "walls", [](const Scenario& scenario) { return avo::walls_of(scenario.obstacles); },
          "list of Wall, of all obstacles")
      .def(
          "planner_options",
          [](const Scenario& scenario) { return arguments_of(avo::planner_options(scenario)); },
          "What its robots plan with: Planner(**scenario.planner_options()).")
      .def("advice", &avo::advice, "One line for each setting that does not fit the robots.")
      .def("out_of_reach", &out_of_reach_of,
           "A dict of each robot that walls keep from its goal: its \"robot\" number, the "
           "\"nearest\" place that it gets to, m, the \"distance_left\" from there to the goal, m, "
           "whether the goal \"is_in_wall\", nearer to a wall than the radius, and whether that "
           "place \"counts_as_there\", within arrival_distance.")
      .def("broken_assumptions", &broken_of,
           "How many robots or pairs break what the certificate assumes, and the sensing radius "
           "that it needs, m, where that is too small: {\"starts\": 0, ..., \"unseen\": None}.")
      .def(
          "complaints", [](const Scenario& scenario) { return avo::complaints(scenario); },
          "One line for each thing that breaks what the certificate assumes, the worst first.")
      .def("_repr_svg_",
           [](const py::object& self) { return py::module_::import("avo.svg").attr("draw")(self); })
      .def("__repr__", [](const Scenario& scenario) {
        return "<avo.Scenario " + scenario.name + ": " + std::to_string(scenario.robots.size()) +
               " robots>";
      });
  module.def("builtin_scenes", &builtin_scenes, "list of (name, description).");
  module.def(
      "schema", [] { return from_json(avo_io::scenario_schema()); },
      "JSON Schema of scene files, a dict.");
}

}  // namespace avo_python
