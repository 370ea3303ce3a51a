// SPDX-License-Identifier: Apache-2.0
// Runs of scenes of space, decisions in words, and what the judge says of recordings.
#include <fmt/format.h>
#include <memory>

#include "avo/space/metrics.h"
#include "avo_io/space.h"
#include "avo_io/space_decision.h"
#include "space.h"

namespace avo_python::space {
namespace {

using avo::space::Scenario;
using avo::space::Simulation;
using py::arg;

/// Does what `avo run` does: it simulates to the end of the scene.
std::string results_of(const Scenario& scenario, int threads, bool until_arrived,
                       avo_io::SpaceRecording* recording) {
  const py::gil_scoped_release release;
  Simulation simulation(scenario, threads);
  avo::space::Metrics metrics(scenario);
  const auto observe = [&] {
    metrics.observe(simulation);
    if (recording != nullptr) recording->add(simulation);
  };
  observe();
  while (simulation.can_step_by(scenario.duration) && !(until_arrived && metrics.all_arrived())) {
    simulation.step();
    observe();
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  if (recording != nullptr) {
    recording->finish(simulation);
    recording->file().commit();
  }
  return avo_io::to_json(metrics.summary());
}

py::object run(const py::object& scene, int threads, const py::object& record, bool until_arrived) {
  avo_io::SceneSource source;
  const bool is_file = !py::isinstance<Scenario>(scene) && !py::isinstance<py::dict>(scene);
  const auto loaded =
      is_file ? avo_io::load_space_scenario(path_of(scene), {}, &source) : std::nullopt;
  const Scenario scenario = loaded ? *loaded : scenario_of_space(scene, py::none());
  std::unique_ptr<avo_io::SpaceRecording> recording;
  if (!record.is_none()) {
    const std::string path = recording_path(record);
    if (avo_io::is_hdf5_path(path) && !loaded)
      throw avo::Error(
          "record: found HDF5 without a scene file, must be CSV, or with the path of "
          "a scene file, which HDF5 contains");
    recording =
        avo_io::open_space_recording(path, scenario, source, {.until_arrived = until_arrived});
  }
  return from_json(results_of(scenario, threads, until_arrived, recording.get()));
}

py::object explain(const py::object& scene, std::int64_t robot, double time, int threads) {
  const Scenario scenario = scenario_of_space(scene, py::none());
  const auto go_on = [](double) {
    const py::gil_scoped_acquire acquire;
    return PyErr_CheckSignals() == 0;
  };
  const std::string json = [&] {
    const py::gil_scoped_release release;
    const auto decision = avo_io::explain_in_space(scenario, robot, time, threads, go_on);
    return decision ? avo_io::to_json(*decision, scenario.name) : std::string();
  }();
  if (json.empty()) throw py::error_already_set();
  return from_json(json);
}

py::object explain_now(SharedSpaceSimulation& self, std::int64_t robot) {
  return from_json(self.alone([&](const Simulation& simulation) {
    if (robot < 0 || robot >= static_cast<std::int64_t>(simulation.size()))
      throw avo::Error(
          fmt::format("robot: found {}, must be 0 to {}", robot, simulation.size() - 1));
    return avo_io::to_json(simulation.explain({static_cast<std::uint64_t>(robot)}),
                           simulation.scenario().name);
  }));
}

bool is_in_space(const py::object& source) {
  if (py::isinstance<py::dict>(source)) {
    const auto keys = source.cast<py::dict>();
    return keys.contains("space") && py::object(keys["space"]).equal(py::int_(3));
  }
  return avo_io::load_space_scenario(path_of(source)).has_value();
}

py::object check(const py::object& recording, const py::object& scene, double tolerance,
                 bool require_arrival) {
  const std::string path = path_of(recording);
  std::optional<Scenario> scenario;
  if (!scene.is_none()) {
    scenario = scenario_of_space(scene, py::none());
  } else if (auto own = avo_io::read_recorded_space_scene(path)) {
    scenario = std::move(own->scenario);
  } else {
    throw avo::Error("scene: found none, must be given with a recording as CSV");
  }
  if (!(tolerance >= 0.0 && tolerance < 1.0))
    throw avo::Error(fmt::format("tolerance: found {}, must be >= 0 and < 1", tolerance));
  return from_json([&] {
    const py::gil_scoped_release release;
    return to_json(avo_io::judge_in_space(path, *scenario, tolerance, require_arrival));
  }());
}

}  // namespace

void bind_runs(py::module_& space) {
  space.def("_is_in_space", &is_in_space, arg("source"), "Whether it is a scene with space: 3.");
  space.def("run", &run, arg("scene"), py::kw_only(), arg("threads") = 0,
            arg("record") = py::none(), arg("until_arrived") = false,
            "Runs a scene to its end, or until all robots have arrived: a dict, as `avo run "
            "--summary`. record: file of the recording, which is whole or not there; .h5 needs the "
            "path of a scene file.");
  space.def("explain", &explain, arg("scene"), arg("robot"), arg("time") = 0.0, arg("threads") = 0,
            "Why the robot of that number chooses its velocity, in the last step by `time`, s: a "
            "dict, as `avo explain --json`.");
  const py::object simulation = space.attr("Simulation");
  simulation.attr("explain") = py::cpp_function(
      &explain_now, py::name("explain"), py::is_method(simulation), arg("robot"),
      "Why the robot of that id chooses its velocity in the next step: a dict, as `avo explain "
      "--json`.");
  space.def("check", &check, arg("recording"), arg("scene") = py::none(), py::kw_only(),
            arg("tolerance") = 1e-9, arg("require_arrival") = false,
            "Judges a recording: a dict, as `avo check --json`. HDF5 contains its scene.");
}

}  // namespace avo_python::space
