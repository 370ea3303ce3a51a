// SPDX-License-Identifier: Apache-2.0
// Many runs: scenes x methods x parameters x seeds, as one table with one row for each run.
// Statistics cover runs that differ only in their seeds (docs/experiments.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "avo/export.h"
#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo/space/scenario.h"
#include "avo/space/simulation.h"
#include "avo_io/errors.h"

namespace avo_io {

/// A key of scenes that varies.
struct SweepParameter {
  std::string key;                  ///< as --set takes it, e.g. "groups.0.max_speed"
  std::vector<std::string> values;  ///< as --set takes them
};

/// A method of the caller's own, which sweeps name beside avo's (docs/own_method.md).
struct OwnMethod {
  std::string name;  ///< 1 to 64 bytes, none of avo's
  avo::ExternalMethod function;
  bool clamped = true;     ///< method external_clamped, or else external
  bool certified = false;  ///< with braking_trajectories behind it; only where it is clamped
  std::string version;     ///< anything that changes with the function: results are not mixed
};
/// The changes of a scene by which its robots have that method, as `avo run --set` takes them.
AVO_API std::vector<std::string> overrides_of(const OwnMethod& method);

/// The content of a sweep's file. Its runs are numbered from 0: seeds vary fastest, then the last
/// parameter, and scenes slowest.
struct SweepSpec {
  std::string name;                    ///< of the file, for messages
  std::string text;                    ///< of the file
  std::vector<std::string> scenes;     ///< built-in names, or paths relative to the file
  std::vector<std::string> methods;    ///< empty: each scene's own
  std::vector<OwnMethod> own_methods;  ///< that `methods` may name
  /// every value is combined with every value of the other keys
  std::vector<SweepParameter> parameters;
  std::vector<std::uint64_t> seeds;  ///< empty: each scene's own
  int threads = 1;                   ///< for one run
  bool until_arrived = false;        ///< a run ends once every robot has arrived
  /// The line across which every run measures the flow, as RunMetrics::flow; none: no columns of
  /// it.
  std::optional<avo::MeasuringLine> line = {};
  /// Numbers of the robots that the metrics cover, see avo::MetricsOptions; empty: all. With
  /// until_arrived a run ends once these have arrived.
  std::vector<std::uint64_t> judged = {};
};
/// The largest number of runs in a sweep.
inline constexpr std::int64_t kMostSweepRuns = 1'000'000;

/// Throws FileError, and SceneError with line and column.
AVO_API SweepSpec load_sweep(const std::string& path, std::vector<OwnMethod> own_methods = {});
AVO_API SweepSpec parse_sweep(std::string_view yaml, const std::string& name,
                              std::vector<OwnMethod> own_methods = {});

/// Returns the number of runs.
AVO_API std::int64_t run_count(const SweepSpec& spec);
/// Returns the value of the column "sweep" in its tables: a hash of all inputs of their results.
/// Throws SceneError on a run that is refused.
AVO_API std::string fingerprint(const SweepSpec& spec);
/// Returns one of the runs in words, e.g. "circle-100 orca time_horizon=5 seed=3".
AVO_API std::string run_name(const SweepSpec& spec, std::int64_t run);
/// A scene of the plane or of space.
using SweepScenario = std::variant<avo::Scenario, avo::space::Scenario>;

/// The scene of a run, and the name and the overrides (key=value) with which `avo run` makes it.
/// Throws SceneError with the run's name.
struct SweepRunScene {
  SweepScenario scenario;
  std::string name;
  std::vector<std::string> overrides;
  std::string yaml;  ///< its text, without the overrides
};
AVO_API SweepRunScene scene_of_run(const SweepSpec& spec, std::int64_t run);
/// Simulates such a scene to the end of its run. Calls `observe` at first and after each step.
/// Returns the hash of the last state, as in the table.
AVO_API std::uint64_t simulate_again(
    const SweepSpec& spec, const avo::Scenario& scenario,
    const std::function<void(const avo::Simulation& simulation)>& observe);
AVO_API std::uint64_t simulate_again(
    const SweepSpec& spec, const avo::space::Scenario& scenario,
    const std::function<void(const avo::space::Simulation& simulation)>& observe);

/// One row for each run, by ascending number. All values are text: numbers have the shortest digits
/// that read back to the same bits; a missing value is empty. The first columns are "sweep" (a hash
/// of the inputs, the same for all), "run", "scene", "method", one for each parameter, "seed".
struct SweepTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};
/// Returns whether the column differs from one time to the next: the duration of the runs.
AVO_API bool is_sweep_timing(std::string_view column);
/// Returns the columns of parameters: the first, and one after the last. Throws RecordingError
/// where the table lacks the columns of a sweep.
AVO_API std::pair<std::size_t, std::size_t> parameters_of(const SweepTable& table);

/// Part `index` of `count`: the runs k with k % count == index - 1.
struct SweepShard {
  std::int64_t index = 1, count = 1;
};

/// Options of run_sweep().
struct SweepOptions {
  int jobs = 0;  ///< runs at a time; 0: as many as the machine has processors
  SweepShard shard = {};
  /// A file to which every finished run is added at once. Runs in the file are not simulated again.
  /// Empty: none.
  std::string journal;
  /// Called from the calling thread ten times a second. `done` is the number of runs that are done,
  /// with those in the journal, and `all` the number of all runs.
  std::function<void(std::int64_t done, std::int64_t all)> progress = {};
  /// Called in the same manner before the runs begin, with the number of scenes that are made and
  /// checked, and the number of all scenes.
  std::function<void(std::int64_t done, std::int64_t all)> preparing = {};
  /// Asked before each run, from any thread; true: no further run begins.
  std::function<bool()> stops = {};
};

/// The result of run_sweep(), at its end or where it was stopped.
struct SweepResult {
  SweepTable table;          ///< of the runs that are done
  std::int64_t runs = 0;     ///< of the shard
  std::int64_t resumed = 0;  ///< the runs among them that come from the journal
  [[nodiscard]] bool complete() const { return std::ssize(table.rows) == runs; }
};

/// Runs the sweep. Every scene is made and checked before the first run begins. Throws SceneError
/// on a run that is refused, with its name. Throws it also where the journal belongs to another
/// sweep, or is in use. Throws FileError.
AVO_API SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options);

/// The tables of shards as one.
struct SweepMerge {
  SweepTable table;
  std::vector<std::int64_t> missing;  ///< runs that are in no table
};
/// Throws RecordingError on a table of another sweep, or where two tables differ in a run, except
/// in timings.
AVO_API SweepMerge merge_sweep(const SweepSpec& spec,
                               const std::vector<std::pair<std::string, SweepTable>>& tables);

/// Returns one row for each scene x method x parameters. It has the number of runs in which a
/// column has a value ("count"), and their median, 95th percentile ("p95") and mean. It also has a
/// 95 % interval of the mean ("low", "high"). The interval follows Student's t; for shares (columns
/// of 0 and 1) it follows Wilson's score. There is no interval for runs that end in the same state:
/// they are one run.
AVO_API SweepTable summary_of(const SweepTable& runs);

/// Returns text with commas, quoted as in RFC 4180.
AVO_API std::string to_csv(const SweepTable& table);
/// Writes an HDF5 file at `path`, which messages call `name`: groups "runs" and "summary" with one
/// dataset for each column. Throws FileError.
AVO_API void write_sweep_hdf5(const SweepTable& runs, const std::string& path,
                              const std::string& name);
/// Returns whether an HDF5 file holds a sweep. False where it cannot be opened.
AVO_API bool is_sweep_hdf5(const std::string& path);
/// Reads the runs of either format. Throws FileError and RecordingError.
AVO_API SweepTable read_sweep(const std::string& path);

/// Returns the number in a field; none where it is empty or no number.
AVO_API std::optional<double> number_in(std::string_view field);

}  // namespace avo_io
