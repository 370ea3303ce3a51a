// SPDX-License-Identifier: Apache-2.0
// Many runs: scenes x methods x parameters x seeds, as one table with a row a run, and what is to
// be said of runs that differ in nothing but their seeds (docs/experiments.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "avo/export.h"
#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo_io/errors.h"

namespace avo_io {

/// A key of scenes that varies.
struct SweepParameter {
  std::string key;                  ///< as --set takes it, e.g. "groups.0.max_speed"
  std::vector<std::string> values;  ///< likewise
};

/// What a sweep's file says. Its runs are numbered from 0: seeds vary fastest, then the last
/// parameter, and scenes slowest.
struct SweepSpec {
  std::string name;                        ///< of the file, in front of messages
  std::string text;                        ///< of the file
  std::vector<std::string> scenes;         ///< built-in names, or paths relative to the file
  std::vector<std::string> methods;        ///< empty: each scene's own
  std::vector<SweepParameter> parameters;  ///< every value with every other key's
  std::vector<std::uint64_t> seeds;        ///< empty: each scene's own
  int threads = 1;                         ///< of one run
  bool until_arrived = false;              ///< a run ends once every robot has arrived
  /// Whose flow is measured in every run, as RunMetrics::flow; none: no columns of it.
  std::optional<avo::MeasuringLine> line = {};
  /// Numbers of the robots whose trips the metrics are of, see avo::MetricsOptions; empty: all.
  /// With until_arrived a run ends once these have arrived.
  std::vector<std::uint64_t> judged = {};
};
/// A sweep has no more runs.
inline constexpr std::int64_t kMostSweepRuns = 1'000'000;

/// Throws FileError, and SceneError with line and column.
AVO_API SweepSpec load_sweep(const std::string& path);
AVO_API SweepSpec parse_sweep(std::string_view yaml, const std::string& name);

/// How many runs it has.
AVO_API std::int64_t run_count(const SweepSpec& spec);
/// What the column "sweep" of its tables holds: a hash of all that their results follow from.
/// Throws SceneError on a run that is refused.
AVO_API std::string fingerprint(const SweepSpec& spec);
/// One of them in words, e.g. "circle-100 orca time_horizon=5 seed=3".
AVO_API std::string run_name(const SweepSpec& spec, std::int64_t run);
/// Its scene, and the name and the overrides (key=value) with which `avo run` makes it. Throws
/// SceneError with the run's name.
struct SweepRunScene {
  avo::Scenario scenario;
  std::string name;
  std::vector<std::string> overrides;
  std::string yaml;  ///< its text, without these
};
AVO_API SweepRunScene scene_of_run(const SweepSpec& spec, std::int64_t run);
/// Simulates such a scene to the end of its run, which it shows to `observe` at first and after
/// each step. Returns the hash of the last state, as in the table.
AVO_API std::uint64_t simulate_again(
    const SweepSpec& spec, const avo::Scenario& scenario,
    const std::function<void(const avo::Simulation& simulation)>& observe);

/// A row a run, by ascending number. All values as text: numbers with the shortest digits that read
/// back to the same bits, nothing where there is no value. The first columns are "sweep" (what its
/// runs follow from, the same for all), "run", "scene", "method", one for each parameter, "seed".
struct SweepTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};
/// Columns that differ from one time to the next: what the runs took.
AVO_API bool is_sweep_timing(std::string_view column);
/// The columns of parameters: first, and one behind the last. Throws RecordingError where the table
/// has not the columns of a sweep.
AVO_API std::pair<std::size_t, std::size_t> parameters_of(const SweepTable& table);

/// Part `index` of `count`: the runs k with k % count == index - 1.
struct SweepShard {
  std::int64_t index = 1, count = 1;
};

/// How run_sweep() goes about it.
struct SweepOptions {
  int jobs = 0;  ///< runs at a time; 0: as many as the machine has processors
  SweepShard shard = {};
  /// A file to which every finished run is added at once. Runs that are there already are not
  /// simulated again.
  std::string journal;
  /// Told from the calling thread ten times a second: how many runs are done, those of the journal
  /// included, and how many there are.
  std::function<void(std::int64_t done, std::int64_t all)> progress = {};
  /// Told likewise before that: how many scenes are made and checked, of those that there are to
  /// be.
  std::function<void(std::int64_t done, std::int64_t all)> preparing = {};
  /// Asked before each run, from any thread; true: no further run begins.
  std::function<bool()> stops = {};
};

/// What run_sweep() has, at its end or where it was stopped.
struct SweepResult {
  SweepTable table;          ///< of the runs that are done
  std::int64_t runs = 0;     ///< of the shard
  std::int64_t resumed = 0;  ///< of them, those of the journal
  [[nodiscard]] bool complete() const { return std::ssize(table.rows) == runs; }
};

/// Runs it. Every scene is made and checked before the first run begins. Throws SceneError on a run
/// that is refused, with its name, and where the journal is that of another sweep, or in use;
/// FileError.
AVO_API SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options);

/// The tables of shards as one.
struct SweepMerge {
  SweepTable table;
  std::vector<std::int64_t> missing;  ///< runs that are in no table
};
/// Throws RecordingError on a table of another sweep, or where two differ in a run, but for
/// timings.
AVO_API SweepMerge merge_sweep(const SweepSpec& spec,
                               const std::vector<std::pair<std::string, SweepTable>>& tables);

/// One row for each scene x method x parameters: in how many runs a column has a value ("count"),
/// their median, 95th percentile ("p95"), mean, and a 95 % interval of the mean ("low", "high"): by
/// Student's t, of shares (columns of 0 and 1) by Wilson's score. No interval of runs whose states
/// at the end are all the same: they are one run.
AVO_API SweepTable summary_of(const SweepTable& runs);

/// As text with commas, as RFC 4180 quotes them.
AVO_API std::string to_csv(const SweepTable& table);
/// Writes an HDF5 file at `path`, which messages call `name`: groups "runs" and "summary" with a
/// dataset a column. Throws FileError.
AVO_API void write_sweep_hdf5(const SweepTable& runs, const std::string& path,
                              const std::string& name);
/// Whether an HDF5 file is such a one. False where it cannot be opened.
AVO_API bool is_sweep_hdf5(const std::string& path);
/// The runs of either. Throws FileError and RecordingError.
AVO_API SweepTable read_sweep(const std::string& path);

/// The number in a field; none where it is empty or no number.
AVO_API std::optional<double> number_in(std::string_view field);

}  // namespace avo_io
