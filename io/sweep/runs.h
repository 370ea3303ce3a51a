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
  std::vector<std::string> values;         ///< of the parameters in the spec
  std::optional<std::uint64_t> seed = {};  ///< unset: the scene's own
};
SweepRun run_of(const SweepSpec& spec, std::int64_t run);
/// Returns the caller's own method of the run; none for avo's methods.
const OwnMethod* own_method_of(const SweepSpec& spec, const SweepRun& run);
/// Returns key=value, as --set takes them.
std::vector<std::string> overrides_of(const SweepSpec& spec, const SweepRun& run);
/// Returns a name or path for load_scenario().
std::string scene_of(const SweepSpec& spec, const SweepRun& run);

/// Returns the run's scene, checked as `avo run` checks it. Throws SceneError with the run's name.
/// `source` receives the texts that it was made of.
SweepScenario scenario_of(const SweepSpec& spec, const SweepRun& run, SceneSource& source);
/// Returns the hash of a scene's texts.
std::uint64_t hash_of(const SceneSource& source);

/// The result of a run.
struct RunOutcome {
  avo::RunSummary summary;
  std::vector<double> arrivals;  ///< s, ascending, of robots that are not parked
  std::uint64_t state_hash = 0;  ///< at the end
  double seconds = 0.0;          ///< s, the time that the run took
};
RunOutcome simulate_run(const SweepSpec& spec, const SweepScenario& scenario);

/// Returns the columns of a sweep's table.
std::vector<std::string> sweep_columns(const SweepSpec& spec);
/// Returns a row of the table. `sweep`: fingerprint().
std::vector<std::string> sweep_row(const SweepSpec& spec, const std::string& sweep,
                                   const SweepRun& run, const SweepScenario& scenario,
                                   const RunOutcome& outcome);

/// Returns a hash of the source texts for each scene x method x parameters, by ascending number of
/// its runs. It calls `tell` with the number so far. Throws what scenario_of() throws.
std::vector<std::uint64_t> hash_sources(const SweepSpec& spec, int jobs = 1,
                                        const std::function<void(std::int64_t done)>& tell = {});
/// Returns a hash of everything that the results follow from: the parameters, the sources, and the
/// version of avo.
std::string fingerprint(const SweepSpec& spec, const std::vector<std::uint64_t>& sources);
/// Returns the number of consecutive runs that differ in nothing but their seeds.
std::int64_t runs_of_one_kind(const SweepSpec& spec);

}  // namespace avo_io
