// SPDX-License-Identifier: Apache-2.0
// The runs of a sweep, one at a time.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo_io/scene.h"
#include "avo_io/sweep.h"

namespace avo_io {

struct SweepRun {
  std::int64_t number = 0;
  std::string scene = {};
  std::string method = {};                 ///< empty: the scene's own
  std::vector<std::string> values;         ///< of the spec's parameters
  std::optional<std::uint64_t> seed = {};  ///< unset: the scene's own
};
SweepRun run_of(const SweepSpec& spec, std::int64_t run);
/// key=value, as --set takes them.
std::vector<std::string> overrides_of(const SweepSpec& spec, const SweepRun& run);
/// Name or path for load_scenario().
std::string scene_of(const SweepSpec& spec, const SweepRun& run);

/// Its scene, checked as `avo run` does. Throws SceneError with the run's name. `source` becomes
/// what it was made of.
avo::Scenario scenario_of(const SweepSpec& spec, const SweepRun& run, SceneSource& source);
/// Of the texts of a scene.
std::uint64_t hash_of(const SceneSource& source);

/// What a run leaves behind.
struct RunOutcome {
  avo::RunSummary summary;
  std::vector<double> arrivals;  ///< s, ascending, of robots that are not parked
  std::uint64_t state_hash = 0;  ///< at the end
  double seconds = 0.0;          ///< that it took
};
RunOutcome simulate_run(const SweepSpec& spec, const avo::Scenario& scenario);

/// The columns of a sweep's table.
std::vector<std::string> sweep_columns(const SweepSpec& spec);
/// A row of it. `sweep`: fingerprint().
std::vector<std::string> sweep_row(const SweepSpec& spec, const std::string& sweep,
                                   const SweepRun& run, const avo::Scenario& scenario,
                                   const RunOutcome& outcome);

/// Of each scene x method x parameters, by ascending number of its runs, a hash of the texts that
/// it is made of; `tell` hears of how many by now. Throws what scenario_of() does.
std::vector<std::uint64_t> hash_sources(const SweepSpec& spec, int jobs = 1,
                                        const std::function<void(std::int64_t done)>& tell = {});
/// Of all that the results follow from: what varies, the sources, and the version of avo.
std::string fingerprint(const SweepSpec& spec, const std::vector<std::uint64_t>& sources);
/// How many runs, one after the other, differ in nothing but their seeds.
std::int64_t runs_of_one_kind(const SweepSpec& spec);

}  // namespace avo_io
