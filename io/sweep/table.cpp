// SPDX-License-Identifier: Apache-2.0
// Reads tables of sweeps as text, and merges several of them.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "io/files/regular_file.h"
#include "io/sweep/hdf5.h"
#include "io/sweep/runs.h"
#include "io/text/csv_text.h"
#include "io/text/line_reader.h"

namespace avo_io {
namespace {

using Row = std::vector<std::string>;
constexpr std::size_t kRun = 1;  // column

// Columns of earlier builds, and their names now.
constexpr std::pair<std::string_view, std::string_view> kRenamed[] = {
    {"obstacle_collisions", "mover_collisions"},
    {"obstacle_collisions_in_motion", "mover_collisions_in_motion"},
    {"obstacle_collisions_evadable", "mover_collisions_evadable"},
    {"collision_obstacles", "static_collisions"},
    {"min_obstacle_clearance", "min_static_clearance"}};

std::string present_name(const std::string& column) {
  for (const auto& [before, now] : kRenamed)
    if (column == before) return std::string(now);
  return column;
}

void require_columns(const SweepTable& table, const std::string& path) {
  try {
    parameters_of(table);
  } catch (const RecordingError& error) {
    throw RecordingError(fmt::format("{}: {}", path, error.what()));
  }
}

SweepTable read_sweep_csv(const std::string& path) {
  constexpr std::size_t kLongestRow = std::size_t{1} << 20U;  // bytes
  std::error_code error;
  // throws with the reason
  if (!std::filesystem::is_regular_file(path, error)) read_regular_file(path);
  LineReader lines(path, kLongestRow);
  SweepTable table;
  while (const std::optional<std::string_view> line = lines.next()) {
    if (!lines.has_end())  // a row that was cut off may look whole: 12 for 123
      throw RecordingError(fmt::format("{}:{}: found no end of the line, the table was cut off",
                                       path, lines.number()));
    std::optional<Row> row = csv_fields(*line);
    if (!row) throw RecordingError(fmt::format("{}:{}: found wrong quotes", path, lines.number()));
    if (lines.number() == 1) {
      table.columns = std::move(*row);
      require_columns(table, path);
      continue;
    }
    if (row->size() != table.columns.size())
      throw RecordingError(fmt::format("{}:{}: found {} values, must be {}", path, lines.number(),
                                       row->size(), table.columns.size()));
    table.rows.push_back(std::move(*row));
  }
  return table;
}

/// Returns the number of the row's run; there are `all` runs.
std::int64_t number_of_run(const std::string& table, const Row& row, std::int64_t all) {
  std::int64_t run = -1;
  const std::string& field = row[kRun];
  const char* const last = field.data() + field.size();
  if (std::from_chars(field.data(), last, run).ptr != last || run < 0 || run >= all)
    throw RecordingError(
        fmt::format("{}: found run {}, must be 0 to {}", table, printable(field, 40), all - 1));
  return run;
}

void require_same(const std::string& table, const Row& columns, const Row& a, const Row& b) {
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (a[c] != b[c] && !is_sweep_timing(columns[c]))
      throw RecordingError(fmt::format("{}: run {}: {}: found {}, must be {} as in another table",
                                       table, a[kRun], columns[c], printable(b[c], 40),
                                       printable(a[c], 40)));
}

}  // namespace

std::pair<std::size_t, std::size_t> parameters_of(const SweepTable& table) {
  constexpr const char* kFirst[] = {"sweep", "run", "scene", "method"};
  constexpr std::size_t kCount = std::size(kFirst);
  const auto& columns = table.columns;
  const auto seed = std::find(columns.begin(), columns.end(), "seed");
  if (columns.size() < kCount || !std::equal(kFirst, kFirst + kCount, columns.begin()) ||
      seed == columns.end() || std::next(seed) == columns.end() || *std::next(seed) != "state_hash")
    throw RecordingError(
        "found no table of avo sweep, whose first columns must be sweep, run, "
        "scene, method, parameters, seed, state_hash");
  return {kCount, static_cast<std::size_t>(seed - columns.begin())};
}

SweepTable read_sweep(const std::string& path) {
  SweepTable table = is_hdf5_path(path) ? read_sweep_hdf5(path) : read_sweep_csv(path);
  for (std::string& column : table.columns) column = present_name(column);
  require_columns(table, path);
  if (table.rows.empty())
    throw RecordingError(path + ": found a table without runs, must have one or more");
  return table;
}

std::string to_csv(const SweepTable& table) {
  std::string text = csv_line(table.columns) + "\n";
  for (const Row& row : table.rows) text += csv_line(row) + "\n";
  return text;
}

SweepMerge merge_sweep(const SweepSpec& spec,
                       const std::vector<std::pair<std::string, SweepTable>>& tables) {
  const std::string sweep = fingerprint(spec, hash_sources(spec));
  const std::int64_t all = run_count(spec);
  SweepMerge merged;
  merged.table.columns = sweep_columns(spec);
  std::map<std::int64_t, Row> rows;
  for (const auto& [name, table] : tables) {
    const bool same = table.columns == merged.table.columns;
    for (const Row& row : table.rows) {
      if (!same || row[0] != sweep)
        throw RecordingError(name +
                             ": found a table of another sweep, or of other scenes or "
                             "another version of avo, must be of " +
                             spec.name);
      const std::int64_t run = number_of_run(name, row, all);
      const auto [known, is_new] = rows.try_emplace(run, row);
      if (!is_new) require_same(name, table.columns, known->second, row);
    }
  }
  for (std::int64_t run = 0; run < all; ++run) {
    const auto found = rows.find(run);
    if (found == rows.end())
      merged.missing.push_back(run);
    else
      merged.table.rows.push_back(std::move(found->second));
  }
  return merged;
}

}  // namespace avo_io
