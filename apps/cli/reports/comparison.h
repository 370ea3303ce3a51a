// SPDX-License-Identifier: Apache-2.0
// The runs that avo compare compares: rows of sweeps' tables that differ in nothing but their
// seeds, and recordings.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "avo/vec.h"
#include "avo_io/recorded_run.h"
#include "avo_io/sweep.h"

namespace avo_cli {

/// Runs of one table, scene, method and set of parameters.
struct Case {
  std::vector<std::pair<std::string, std::string>> keys;  ///< distinguish it from other cases
  std::string file;                                       ///< the table
  const avo_io::SweepTable* table = nullptr;
  std::vector<const std::vector<std::string>*> runs;

  /// Returns the value; empty if the case has no such key.
  [[nodiscard]] std::string value_of(const std::string& key) const;
  /// Returns the values of all its runs that have one.
  [[nodiscard]] std::vector<double> values(const std::string& column) const;
};

/// The files that avo compare has read.
struct Comparison {
  std::vector<std::pair<std::string, avo_io::SweepTable>> tables;
  std::vector<std::pair<std::string, avo_io::RecordedRun>> recordings;
  std::string by = {};  ///< the key with values that have colors; empty: usual_by()
};

/// Returns the cases in the order of the tables and their rows. With several tables, "table" is one
/// of the keys.
std::vector<Case> cases_of(const Comparison& comparison);

/// Returns the keys that have more than one value.
std::vector<std::string> varying_keys(const std::vector<Case>& cases);

/// Returns the values of those keys, e.g. "orca, 5"; with `named`: "method orca, time_horizon 5".
std::string label_of(const Case& entry, const std::vector<std::string>& keys, bool named = false);

/// Cases that differ in one key, and their results.
struct ComparisonBlock {
  /// keys that they share and that distinguish them from other blocks; may be empty
  std::string heading;
  /// the heads of the columns, and a row for each case
  std::vector<std::vector<std::string>> rows;
  std::vector<Case> cases;
};
/// Returns the first of method, parameters, table and scene that varies.
std::string usual_by(const std::vector<Case>& cases);
/// Returns a block for each set of all keys except `by`. It has the mean over the runs and its 95 %
/// interval for each of `columns`. Empty `columns`: the usual ones. Throws UsageError for an
/// unknown key or column.
std::vector<ComparisonBlock> blocks_of(const std::vector<Case>& cases, const std::string& by,
                                       std::vector<std::string> columns);
/// Returns the blocks as text; an empty `by` means usual_by().
std::string readable(const std::vector<Case>& cases, std::string by,
                     std::vector<std::string> columns);
/// Returns one row for each recording.
std::string readable(const Comparison& comparison);

/// Returns the share of arrived robots among those not parked, in % over s: the mean over the
/// case's runs. Each run's share grows linearly from its first arrival, at 0, through its columns
/// arrival_10 to arrival_100 to its last arrival, at 100. Behind the last of these columns that the
/// run has, it stays constant. A jump of the share has two points at one time.
std::vector<avo::Vec2> arrivals_of(const Case& entry);

/// The limit for a figure: readers cannot tell more curves apart.
inline constexpr std::size_t kMostCurves = 12;

/// Draws the arrivals of these cases, with a curve for each, named by its values of `keys`.
std::string draw_arrivals(const std::vector<Case>& cases, const std::vector<std::string>& keys,
                          const std::string& role, const std::string& path);

/// Returns ms per step over the number of robots, with a curve for each label. Each point is the
/// median over all runs with that number, in whatever case. Labels have the keys that vary, except
/// scenes and keys that only set the number of robots.
std::vector<std::pair<std::string, std::vector<avo::Vec2>>> scaling_of(
    const std::vector<Case>& cases);

/// Return the contents of the files at `path`. They throw UsageError, which names the option
/// `role`, if there is nothing to draw.
std::string draw_arrivals(const Comparison& comparison, const std::string& role,
                          const std::string& path);
std::string draw_clearances(const Comparison& comparison, const std::string& role,
                            const std::string& path);
std::string draw_traces(const Comparison& comparison, const std::string& role,
                        const std::string& path);
std::string draw_scaling(const Comparison& comparison, const std::string& role,
                         const std::string& path);

}  // namespace avo_cli
