// SPDX-License-Identifier: Apache-2.0
// The runs of a sweep, one at a time.
#include "io/sweep/runs.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "avo/assumptions.h"
#include "avo/simulation.h"
#include "avo/space/metrics.h"
#include "avo/space/simulation.h"
#include "avo/version.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "core/ranges.h"
#include "io/sweep/hash.h"
#include "io/sweep/parallel_work.h"

namespace avo_io {
namespace {

using SweepClock = std::chrono::steady_clock;

double seconds_since(SweepClock::time_point start) {
  return std::chrono::duration<double>(SweepClock::now() - start).count();
}

std::vector<avo::RobotId> judged_of(const SweepSpec& spec) {
  std::vector<avo::RobotId> robots;
  for (const std::uint64_t number : spec.judged) robots.push_back({number});
  return robots;
}

bool is_parked(const avo::Simulation& simulation, avo::RobotId robot) {
  return is_parked(simulation.setup(robot));
}
bool is_parked(const avo::space::Simulation& /*simulation*/, avo::RobotId /*robot*/) {
  return false;
}

avo::RobotId id_at(const avo::Simulation& simulation, std::size_t row) {
  return simulation.fleet(avo::Columns::id).id[row];
}
avo::RobotId id_at(const avo::space::Simulation& /*simulation*/, std::size_t row) {
  return {row};
}

/// The time when each robot first arrives, as avo::Metrics counts it.
class ArrivalTimes {
 public:
  template <class Simulation>
  void observe(const Simulation& simulation) {
    for (std::size_t row = 0; row < simulation.size(); ++row) {
      const avo::RobotId robot = id_at(simulation, row);
      const auto k = static_cast<std::size_t>(robot.value);
      if (has_arrived_.size() <= k) has_arrived_.resize(k + 1);
      if (has_arrived_[k] || !simulation.is_at_goal(robot)) continue;
      has_arrived_[k] = true;
      if (is_parked(simulation, robot)) continue;
      times_.push_back(simulation.time());
    }
  }
  [[nodiscard]] std::vector<double> times() && { return std::move(times_); }

 private:
  std::vector<bool> has_arrived_;  // by the values of ids
  std::vector<double> times_;      // s
};

}  // namespace

std::uint64_t hash_of(const SceneSource& source) {
  TextHash hash;
  hash.add(source.yaml);
  for (const SceneFile& file : source.files) hash.add(file.text);
  return hash.value();
}

namespace {

// Space has method avo alone.
std::vector<std::string> overrides_in_space(const SweepSpec& spec, const SweepRun& run) {
  std::vector<std::string> overrides = overrides_of(spec, run);
  std::erase(overrides, "method=avo");
  return overrides;
}

// Returns the scene if it is one of space.
std::optional<avo::space::Scenario> scenario_of_space(const SweepSpec& spec, const SweepRun& run,
                                                      SceneSource& source) {
  std::optional<avo::space::Scenario> scenario =
      load_space_scenario(scene_of(spec, run), overrides_in_space(spec, run), &source);
  if (scenario && spec.line)
    throw SceneError("line: found with a scene of space, must be left out");
  if (scenario && !spec.judged.empty())
    throw SceneError("judged: found with a scene of space, must be left out");
  return scenario;
}

}  // namespace

SweepScenario scenario_of(const SweepSpec& spec, const SweepRun& run, SceneSource& source) {
  try {
    if (auto in_space = scenario_of_space(spec, run, source)) return std::move(*in_space);
    avo::Scenario scenario = load_scenario(scene_of(spec, run), overrides_of(spec, run), &source);
    if (const OwnMethod* own = own_method_of(spec, run)) scenario.external = own->function;
    if (!scenario.allow_broken_assumptions && !avo::broken_assumptions(scenario).none())
      throw SceneError(
          "found a scene that breaks what its certificate assumes, must keep it; avo validate says "
          "where");
    for (const std::uint64_t robot : spec.judged)
      if (robot >= scenario.robots.size())
        throw SceneError(fmt::format("found robot {} judged, must be 0 to {}", robot,
                                     scenario.robots.size() - 1));
    return scenario;
  } catch (const FileError&) {
    throw;
  } catch (const avo::Error& error) {
    throw SceneError(
        fmt::format("{}: {}: {}", spec.name, run_name(spec, run.number), error.what()));
  }
}

namespace {

template <class Simulation, class Metrics>
RunOutcome outcome_of(const SweepSpec& spec, double duration, Simulation simulation,
                      Metrics metrics) {
  const SweepClock::time_point begin = SweepClock::now();
  ArrivalTimes arrivals;
  metrics.observe(simulation);
  arrivals.observe(simulation);
  bool ends = false;
  while (!ends && simulation.can_step_by(duration)) {
    const SweepClock::time_point start = SweepClock::now();
    simulation.step();
    metrics.add_step_time(1e3 * seconds_since(start));
    metrics.observe(simulation);
    arrivals.observe(simulation);
    ends = spec.until_arrived && metrics.all_arrived();
  }
  return {metrics.summary(), std::move(arrivals).times(), simulation.state_hash(),
          seconds_since(begin)};
}

}  // namespace

RunOutcome simulate_run(const SweepSpec& spec, const SweepScenario& scenario) {
  if (const auto* space = std::get_if<avo::space::Scenario>(&scenario))
    return outcome_of(spec, space->duration, avo::space::Simulation(*space, spec.threads),
                      avo::space::Metrics(*space));
  const auto& plane = std::get<avo::Scenario>(scenario);
  return outcome_of(
      spec, plane.duration, avo::Simulation(plane, spec.threads),
      avo::Metrics(plane, {.crowd = true, .line = spec.line, .judged = judged_of(spec)}));
}

SweepRunScene scene_of_run(const SweepSpec& spec, std::int64_t number) {
  const SweepRun run = run_of(spec, number);
  SceneSource source;
  SweepScenario scenario = scenario_of(spec, run, source);
  const bool in_space = std::holds_alternative<avo::space::Scenario>(scenario);
  return {std::move(scenario), scene_of(spec, run),
          in_space ? overrides_in_space(spec, run) : overrides_of(spec, run),
          std::move(source.yaml)};
}

namespace {

template <class Simulation, class Metrics>
std::uint64_t hash_after(const SweepSpec& spec, double duration, Simulation simulation,
                         Metrics metrics, const std::function<void(const Simulation&)>& observe) {
  metrics.observe(simulation);
  observe(simulation);
  bool ends = false;
  while (!ends && simulation.can_step_by(duration)) {
    simulation.step();
    metrics.observe(simulation);
    observe(simulation);
    ends = spec.until_arrived && metrics.all_arrived();
  }
  return simulation.state_hash();
}

}  // namespace

std::uint64_t simulate_again(const SweepSpec& spec, const avo::Scenario& scenario,
                             const std::function<void(const avo::Simulation&)>& observe) {
  return hash_after(spec, scenario.duration, avo::Simulation(scenario, spec.threads),
                    avo::Metrics(scenario, {.judged = judged_of(spec)}), observe);
}

std::uint64_t simulate_again(const SweepSpec& spec, const avo::space::Scenario& scenario,
                             const std::function<void(const avo::space::Simulation&)>& observe) {
  return hash_after(spec, scenario.duration, avo::space::Simulation(scenario, spec.threads),
                    avo::space::Metrics(scenario), observe);
}

std::int64_t runs_of_one_kind(const SweepSpec& spec) {
  return std::max<std::int64_t>(std::ssize(spec.seeds), 1);
}

std::vector<std::uint64_t> hash_sources(const SweepSpec& spec, int jobs,
                                        const std::function<void(std::int64_t done)>& tell) {
  const std::int64_t each = runs_of_one_kind(spec);
  std::vector<std::uint64_t> hashes(static_cast<std::size_t>(run_count(spec) / each));
  std::atomic<std::int64_t> done = 0;
  work_through(
      hashes.size(), jobs,
      [&](std::size_t kind) {
        SceneSource source;
        scenario_of(spec, run_of(spec, static_cast<std::int64_t>(kind) * each), source);
        hashes[kind] = hash_of(source);
        ++done;
      },
      {},
      [&] {
        if (tell) tell(done);
      });
  return hashes;
}

std::string fingerprint(const SweepSpec& spec) {
  return fingerprint(spec, hash_sources(spec));
}

std::string fingerprint(const SweepSpec& spec, const std::vector<std::uint64_t>& sources) {
  TextHash hash;
  hash.add(avo::kVersion);
  for (const std::uint64_t source : sources) hash.add(fmt::format("{}", source));
  for (const auto* list : {&spec.scenes, &spec.methods}) {
    hash.add(fmt::format("{}", list->size()));
    for (const std::string& item : *list) hash.add(item);
  }
  for (const std::string& column : sweep_columns(spec)) hash.add(column);
  for (const SweepParameter& parameter : spec.parameters) {
    hash.add(fmt::format("{}", parameter.values.size()));
    for (const std::string& value : parameter.values) hash.add(value);
  }
  for (const std::uint64_t seed : spec.seeds) hash.add(fmt::format("{}", seed));
  for (const OwnMethod& own : spec.own_methods) {
    for (const std::string& change : overrides_of(own)) hash.add(change);
    hash.add(own.version);
  }
  hash.add(spec.until_arrived ? "until_arrived" : "");
  for (const std::uint64_t robot : spec.judged) hash.add(fmt::format("judged {}", robot));
  if (spec.line)
    for (const avo::Vec2 end : {spec.line->a, spec.line->b})
      for (const double value : {end.x, end.y}) hash.add(avo::text(value));
  return hash.text();
}

}  // namespace avo_io
