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
  std::vector<std::pair<std::string, std::string>> keys;  ///< what tells it from others
  std::string file;                                       ///< of the table
  const avo_io::SweepTable* table = nullptr;
  std::vector<const std::vector<std::string>*> runs;

  /// Empty where it has no such key.
  [[nodiscard]] std::string value_of(const std::string& key) const;
  /// Of all its runs that have one.
  [[nodiscard]] std::vector<double> values(const std::string& column) const;
};

/// Files that were read.
struct Comparison {
  std::vector<std::pair<std::string, avo_io::SweepTable>> tables;
  std::vector<std::pair<std::string, avo_io::RecordedRun>> recordings;
};

/// In the order of the tables and their rows. With several tables, "table" is one of the keys.
std::vector<Case> cases_of(const Comparison& comparison);

/// Keys that have more than one value.
std::vector<std::string> varying_keys(const std::vector<Case>& cases);

/// The values of those keys, e.g. "orca, 5"; `named`: "method orca, time_horizon 5".
std::string label_of(const Case& entry, const std::vector<std::string>& keys, bool named = false);

/// Cases that differ in one key, and what is said of them.
struct ComparisonBlock {
  std::string heading;                         ///< what they share and others do not; may be empty
  std::vector<std::vector<std::string>> rows;  ///< the heads of the columns, and a row a case
  std::vector<Case> cases;
};
/// The first of method, parameters, table and scene that varies.
std::string usual_by(const std::vector<Case>& cases);
/// A block for each set of all keys but `by`. Of each of `columns` the mean over the runs and its
/// 95 % interval. Empty `columns`: the usual ones. Throws UsageError on what there is not.
std::vector<ComparisonBlock> blocks_of(const std::vector<Case>& cases, const std::string& by,
                                       std::vector<std::string> columns);
/// The same as a text; an empty `by` is usual_by().
std::string readable(const std::vector<Case>& cases, std::string by,
                     std::vector<std::string> columns);
/// One row a recording.
std::string readable(const Comparison& comparison);

/// How much of the robots that are not parked had arrived, in % over s: the mean over the case's
/// runs. Each run's share grows on straight lines from its first arrival, at 0, through its columns
/// arrival_10 to arrival_100 to its last arrival, at 100, and stays as it is behind the last of
/// them that it has. Where the share jumps there are two points at one time.
std::vector<avo::Vec2> arrivals_of(const Case& entry);

/// Of a figure: more of them nobody tells apart.
inline constexpr std::size_t kMostCurves = 12;

/// The arrivals of these, with a curve for each, called by its values of `keys`.
std::string draw_arrivals(const std::vector<Case>& cases, const std::vector<std::string>& keys,
                          const std::string& role, const std::string& path);

/// ms a step over the number of robots, a curve for each label: at each number the median over all
/// runs with so many, in whatever case. Labels have what varies, but for scenes, and for keys that
/// do nothing but to say how many robots there are.
std::vector<std::pair<std::string, std::vector<avo::Vec2>>> scaling_of(
    const std::vector<Case>& cases);

/// What the files at `path` are to hold. Throw UsageError, which calls the option `role`, where
/// there is nothing to draw.
std::string draw_arrivals(const Comparison& comparison, const std::string& role,
                          const std::string& path);
std::string draw_clearances(const Comparison& comparison, const std::string& role,
                            const std::string& path);
std::string draw_traces(const Comparison& comparison, const std::string& role,
                        const std::string& path);
std::string draw_scaling(const Comparison& comparison, const std::string& role,
                         const std::string& path);

}  // namespace avo_cli
