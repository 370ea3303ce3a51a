// SPDX-License-Identifier: Apache-2.0
// The JSON output of the command line as dicts: decisions, recordings and runs.
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <utility>

#include "avo/metrics.h"
#include "avo_io/decision.h"
#include "avo_io/judgement.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "simulation.h"

namespace avo_python {
namespace {

using py::arg;

py::object explain_scene(const py::object& scene, std::int64_t robot, double time, int threads) {
  const avo::Scenario scenario = scenario_of(scene, py::none());
  std::string json;
  {
    const py::gil_scoped_release release;
    avo_io::require_explainable(scenario, robot, time);
    avo::Simulation simulation(scenario, threads);
    const auto go_on = [] {
      const py::gil_scoped_acquire acquire;
      return PyErr_CheckSignals() == 0;
    };
    if (avo_io::approach_decision(scenario, robot, time, simulation, go_on))
      json =
          to_json(avo_io::explain(simulation, scenario.name, {static_cast<std::uint64_t>(robot)}));
  }
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  return from_json(json);
}

py::object explain_now(SharedSimulation& self, std::int64_t id) {
  return from_json(self.alone([&](const avo::Simulation& simulation) {
    const avo::RobotId robot = robot_id(id);
    if (is_parked(simulation.setup(robot)))
      throw avo::Error(
          fmt::format("robot: found {}, which is parked, must be one that decides", id));
    return to_json(avo_io::explain(simulation, self.name(), robot));
  }));
}

/// Returns the scene; a scene of walls alone may be a file.
avo::Scenario surroundings_of(const py::object& source) {
  if (py::isinstance<avo::Scenario>(source) || py::isinstance<py::dict>(source))
    return scenario_of(source, py::none());
  return avo_io::load_surroundings(path_of(source));
}

/// Refuses limits unless the recording has no scene, or a scene without robots.
void require_fitting(bool scene, const char* name, const std::optional<double>& value) {
  if (scene && value)
    throw avo::Error(
        fmt::format("{}: found besides the robots of scene, must be one or the other", name));
  if (value && !(*value > 0.0))
    throw avo::Error(fmt::format("{}: found {}, must be > 0", name, *value));
}

/// The scene that a recording contains, if it contains one.
std::optional<avo::Scenario> own_scene_of(const std::string& path) {
  const py::gil_scoped_release release;
  auto own = avo_io::read_recorded_scene(path, {});
  if (!own) return std::nullopt;
  return std::move(own->scenario);
}

py::object check(const py::object& recording, const py::object& scene, std::optional<double> radius,
                 std::optional<double> max_acceleration, std::optional<double> max_speed,
                 std::optional<double> max_braking, double tolerance, bool require_arrival,
                 const std::string& movers_at_rest) {
  const auto path = path_of(recording);
  if (avo_io::is_space_recording(path))
    throw avo::Error(
        "recording: found one of space, must be of the plane here; avo.space.check "
        "judges those of space");
  std::optional<avo::Scenario> scenario;
  if (!scene.is_none())
    scenario = surroundings_of(scene);
  else if (!radius)
    scenario = own_scene_of(path);
  const bool has_scene = scenario && !scenario->robots.empty();
  require_fitting(has_scene, "radius", radius);
  require_fitting(has_scene, "max_acceleration", max_acceleration);
  require_fitting(has_scene, "max_speed", max_speed);
  require_fitting(has_scene, "max_braking", max_braking);
  if (!has_scene && !radius)
    throw avo::Error(
        "radius: found neither it nor robots in scene, must be one of the two; max_acceleration "
        "and max_speed may be with it");
  if (max_braking && !max_acceleration)
    throw avo::Error("max_braking: found without max_acceleration, must be with it");
  if (radius && !std::isfinite(*radius))
    throw avo::Error(fmt::format("radius: found {}, must be finite", *radius));
  if (!has_scene && require_arrival)
    throw avo::Error("require_arrival: found without scene, must be with it: goals are there");
  if (!(tolerance >= 0.0 && tolerance < 1.0))
    throw avo::Error(fmt::format("tolerance: found {}, must be >= 0 and < 1", tolerance));
  if (movers_at_rest != "ok" && movers_at_rest != "collision")
    throw avo::Error("movers_at_rest: found \"" + movers_at_rest +
                     "\", must be \"ok\" or \"collision\"");
  avo_io::JudgeOptions options{.tolerance = tolerance,
                               .require_arrival = require_arrival,
                               .movers_at_rest = movers_at_rest == "ok"};
  options.scenario = std::move(scenario);
  if (!has_scene)
    options.radius = *radius, options.max_acceleration = max_acceleration,
    options.max_speed = max_speed, options.max_braking = max_braking;
  std::string json;
  {
    const py::gil_scoped_release release;
    json = to_json(avo_io::judge(path, options));
  }
  return from_json(json);
}

using Line = std::optional<std::pair<avo::Vec2, avo::Vec2>>;

avo::MetricsOptions options_of(bool crowd, const Line& line,
                               const std::vector<std::uint64_t>& judged) {
  avo::MetricsOptions options{.crowd = crowd};
  if (line) options.line = {line->first, line->second};
  for (const std::uint64_t robot : judged) options.judged.push_back({robot});
  return options;
}

/// Does what `avo run` does: it simulates to the end of the scene.
py::object run(const py::object& scene, int threads, const py::object& record, bool crowd,
               const Line& line, const std::vector<std::uint64_t>& judged) {
  avo_io::SceneSource source;
  const avo::Scenario scenario = scenario_of(scene, py::none(), &source);
  std::unique_ptr<avo_io::Recording> recording;
  if (!record.is_none()) {
    const std::string path = recording_path(record);
    if (avo_io::is_hdf5_path(path) && source.yaml.empty())
      throw avo::Error(
          "record: found HDF5 for a Scenario, must be CSV, or HDF5 with the name, the file or the "
          "dict of a scene, which HDF5 contains");
    recording = avo_io::open_recording(path, scenario, source);
  }
  std::string json;
  {
    using Clock = std::chrono::steady_clock;
    const py::gil_scoped_release release;
    avo::Simulation simulation(scenario, threads);
    avo::Metrics metrics(scenario, options_of(crowd, line, judged));
    const auto observe = [&] {
      metrics.observe(simulation);
      if (recording) recording->add(simulation);
    };
    observe();
    while (simulation.can_step_by(scenario.duration)) {
      const Clock::time_point start = Clock::now();
      simulation.step();
      metrics.add_step_time(
          std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      observe();
      const py::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    if (recording) recording->finish(simulation), recording->commit();
    json = avo_io::to_json(metrics.summary());
  }
  return from_json(json);
}

/// Throws Error for a simulation of another scene, as far as names and robots show it before the
/// host has changed any. Robots that were added later belong to no scene.
void require_same(const avo::Scenario& scenario, const avo::Simulation& simulation,
                  const std::string& name) {
  if (!name.empty() && name != scenario.name)
    throw avo::Error(
        fmt::format("simulation: found one of the scene {}, must be of {}", name, scenario.name));
  const avo::FleetView fleet = simulation.fleet(avo::Columns::id | avo::Columns::setup);
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const std::uint64_t id = fleet.id[k].value;
    if (id >= scenario.robots.size()) continue;
    const avo::RobotSetup &now = fleet.setup[k], &own = scenario.robots[id];
    if (now.radius == own.radius && now.max_speed == own.max_speed &&
        now.max_acceleration == own.max_acceleration && is_parked(now) == is_parked(own))
      continue;
    throw avo::Error(
        fmt::format("simulation: found another robot {} than in {}, must be of the same scene", id,
                    scenario.name));
  }
}

/// An observer that threads share, like a simulation.
struct SharedMetrics {
  std::mutex mutex;
  avo::Scenario scenario;
  avo::Metrics metrics;
  bool has_begun = false;

  SharedMetrics(const py::object& scene, bool crowd, const Line& line,
                const std::vector<std::uint64_t>& judged)
      : scenario(scenario_of(scene, py::none())),
        metrics(scenario, options_of(crowd, line, judged)) {}
  void observe(SharedSimulation& simulation) {
    simulation.alone([&](const avo::Simulation& s) {
      const std::lock_guard lock(mutex);
      if (!has_begun) require_same(scenario, s, simulation.name());
      has_begun = true;
      metrics.observe(s);
    });
  }
  std::string summary() {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex);
    return avo_io::to_json(metrics.summary());
  }
};

}  // namespace

void bind_reports(py::module_& module) {
  module.def("explain", &explain_scene, arg("scene"), arg("robot"), arg("time") = 0.0,
             arg("threads") = 0,
             "Why the robot of that number chooses its velocity, in the last step by `time`, s: a "
             "dict, as `avo explain --json`.");
  const py::object simulation = module.attr("Simulation");
  simulation.attr("explain") = py::cpp_function(
      &explain_now, py::name("explain"), py::is_method(simulation), arg("robot"),
      "Why the robot of that id would choose its velocity now: a dict, as `avo explain --json`.");
  module.def(
      "check", &check, arg("recording"), arg("scene") = py::none(), py::kw_only(),
      arg("radius") = py::none(), arg("max_acceleration") = py::none(),
      arg("max_speed") = py::none(), arg("max_braking") = py::none(), arg("tolerance") = 1e-9,
      arg("require_arrival") = false, arg("movers_at_rest") = "collision",
      "Judges a recording, or trajectories of pedestrians: a dict, as `avo check --json`. Either a "
      "scene, which .h5 contains, or radius, m, of all robots, with a scene of walls alone or "
      "without; then "
      "max_acceleration, m/s^2, max_speed, m/s, and max_braking, m/s^2, where it is more than "
      "max_acceleration, are judged where they are given. movers_at_rest: whether a robot at rest "
      "may be "
      "run over, \"ok\", or is unsafe then, \"collision\".");
  module.def(
      "run", &run, arg("scene"), py::kw_only(), arg("threads") = 0, arg("record") = py::none(),
      arg("crowd") = false, arg("line") = py::none(), arg("judged") = std::vector<std::uint64_t>(),
      "Runs a scene to its end: a dict, as `avo run --summary`. record: file of the "
      "recording, .csv or .h5, which is whole or not there. crowd, line, judged: see Metrics.");
  py::class_<SharedMetrics>(module, "Metrics", "What a run did.")
      .def(py::init<const py::object&, bool, const Line&, const std::vector<std::uint64_t>&>(),
           arg("scene"), py::kw_only(), arg("crowd") = false, arg("line") = py::none(),
           arg("judged") = std::vector<std::uint64_t>(),
           "crowd: whether danger, order and density are measured as well, which costs time. line: "
           "two points, m; the flow is that of the robots that cross between them. judged: ids of "
           "robots; the metrics cover the trips of these; none: of all.")
      .def("observe", &SharedMetrics::observe, arg("simulation"),
           "Once before the first step, and once after every step.")
      .def(
          "summary", [](SharedMetrics& self) { return from_json(self.summary()); },
          "A dict, as `avo run --summary`.");
}

}  // namespace avo_python
