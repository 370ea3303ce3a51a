// SPDX-License-Identifier: Apache-2.0
// The runs of avo compare, and their table.
#include "reports/comparison.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>

#include "avo_io/nearest.h"
#include "avo_io/printable.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

using TextRow = std::vector<std::string>;

constexpr std::size_t kRunColumn = 1;
constexpr std::size_t kBehindSeed = 2;  // from the seed to the first result

constexpr const char* kUsualColumns[] = {"all_arrived",   "collided",
                                         "mean_arrival",  "last_arrival",
                                         "min_clearance", "step_milliseconds_median"};

/// Returns rows of text in columns of minimal width, with numbers to the right.
std::string aligned(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> width;
  for (const TextRow& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c >= width.size()) width.push_back(0);
      width[c] = std::max(width[c], row[c].size());
    }
  std::string text;
  for (const TextRow& row : rows) {
    text += fmt::format("  {:<{}}", row[0], width[0]);
    for (std::size_t c = 1; c < row.size(); ++c) text += fmt::format("  {:>{}}", row[c], width[c]);
    text += "\n";
  }
  return text;
}

/// Returns "35.2 [34.9, 35.5]", or "35.2" without an interval.
std::string cell(const Case& entry, const avo_io::SweepTable& summary, const std::string& column) {
  const auto value = [&](const char* statistic) -> std::optional<double> {
    const auto at = std::find(summary.columns.begin(), summary.columns.end(),
                              fmt::format("{}.{}", column, statistic));
    if (at == summary.columns.end()) return std::nullopt;
    return avo_io::number_in(
        summary.rows[0][static_cast<std::size_t>(at - summary.columns.begin())]);
  };
  const std::optional<double> mean = value("mean"), low = value("low"), high = value("high");
  if (!mean) return "-";
  std::string text = fmt::format("{:.4g}", *mean);
  if (low && high && *low < *high) text += fmt::format(" [{:.4g}, {:.4g}]", *low, *high);
  const std::size_t count = entry.values(column).size();
  if (count < entry.runs.size()) text += fmt::format(" of {}", count);
  return text;
}

/// Returns the statistics of this case's runs alone.
avo_io::SweepTable summary_of(const Case& entry) {
  avo_io::SweepTable table{entry.table->columns, {}};
  for (const auto* run : entry.runs) table.rows.push_back(*run);
  return avo_io::summary_of(table);
}

std::vector<std::string> keys_of(const std::vector<Case>& cases) {
  std::vector<std::string> keys;
  for (const Case& entry : cases)
    for (const auto& [key, value] : entry.keys)
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

/// Throws UsageError if `word` is none of `words`.
void require_one_of(const std::string& option, const std::string& word,
                    const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return;
  const std::vector<std::string_view> views(words.begin(), words.end());
  throw UsageError(fmt::format("{}: found {}, {}", option, avo_io::printable(word, kLongestWord),
                               avo_io::allowed_words(word, views)));
}

}  // namespace

std::string Case::value_of(const std::string& key) const {
  for (const auto& [name, value] : keys)
    if (name == key) return value;
  return "";
}

std::vector<double> Case::values(const std::string& column) const {
  const auto at = std::find(table->columns.begin(), table->columns.end(), column);
  std::vector<double> found;
  if (at == table->columns.end()) return found;
  for (const auto* run : runs)
    if (const auto value =
            avo_io::number_in((*run)[static_cast<std::size_t>(at - table->columns.begin())]))
      found.push_back(*value);
  return found;
}

std::vector<Case> cases_of(const Comparison& comparison) {
  std::vector<Case> cases;
  for (const auto& [name, table] : comparison.tables) {
    const std::size_t end = parameters_of(table).second;
    std::map<TextRow, std::size_t> known;  // index into cases
    for (const TextRow& row : table.rows) {
      constexpr std::ptrdiff_t kSceneColumn = 2;
      TextRow values(row.begin() + kSceneColumn, row.begin() + static_cast<std::ptrdiff_t>(end));
      const auto [place, is_new] = known.try_emplace(values, cases.size());
      if (is_new) {
        Case& entry = cases.emplace_back();
        entry.file = name;
        entry.table = &table;
        if (comparison.tables.size() > 1) entry.keys.emplace_back("table", name);
        for (std::size_t i = 0; i < values.size(); ++i)
          entry.keys.emplace_back(table.columns[i + kSceneColumn], values[i]);
      }
      cases[place->second].runs.push_back(&row);
    }
  }
  return cases;
}

std::vector<std::string> varying_keys(const std::vector<Case>& cases) {
  std::vector<std::string> keys = keys_of(cases);
  std::erase_if(keys, [&](const std::string& key) {
    return std::all_of(cases.begin(), cases.end(), [&](const Case& entry) {
      return entry.value_of(key) == cases.front().value_of(key);
    });
  });
  return keys;
}

std::string label_of(const Case& entry, const std::vector<std::string>& keys, bool named) {
  std::string label;
  for (const std::string& key : keys) {
    const std::string value = entry.value_of(key);
    if (value.empty()) continue;
    label += fmt::format("{}{}{}", label.empty() ? "" : ", ", named ? key + " " : "", value);
  }
  return avo_io::printable(label);
}

/// Throws UsageError if a column of --columns is not a result, and RecordingError if a run has no
/// number in it.
void require_numbers(const std::vector<Case>& cases, const std::string& column) {
  const avo_io::SweepTable& first = *cases.front().table;
  const auto results = static_cast<std::ptrdiff_t>(parameters_of(first).second + kBehindSeed);
  const TextRow allowed(first.columns.begin() + results, first.columns.end());
  const bool is_key = std::find(first.columns.begin(), first.columns.begin() + results, column) !=
                      first.columns.begin() + results;
  if (is_key)
    throw UsageError(fmt::format(
        "--columns: found {}, which says what a run is, must be a result in numbers, e.g. {}",
        avo_io::printable(column, kLongestWord), allowed.empty() ? "robots" : allowed.front()));
  require_one_of("--columns", column, allowed);
  for (const Case& entry : cases) {
    const std::vector<std::string>& columns = entry.table->columns;
    const auto at = std::find(columns.begin(), columns.end(), column);
    if (at == columns.end()) continue;
    for (const auto* run : entry.runs) {
      const std::string& field = (*run)[static_cast<std::size_t>(at - columns.begin())];
      if (!field.empty() && !avo_io::number_in(field))
        throw avo_io::RecordingError(
            fmt::format("{}: run {}: {}: found {}, must be a number or empty", entry.file,
                        avo_io::printable((*run)[kRunColumn], kLongestWord), column,
                        avo_io::printable(field, kLongestWord)));
    }
  }
}

std::string usual_by(const std::vector<Case>& cases) {
  const std::vector<std::string> varying = varying_keys(cases);
  const auto has = [&](const std::string& key) {
    return std::find(varying.begin(), varying.end(), key) != varying.end();
  };
  if (has("method")) return "method";
  for (const std::string& key : varying)
    if (key != "table" && key != "scene") return key;
  return has("table") ? "table" : has("scene") ? "scene" : "method";
}

std::vector<ComparisonBlock> blocks_of(const std::vector<Case>& cases, const std::string& by,
                                       std::vector<std::string> columns) {
  require_one_of("--by", by, keys_of(cases));
  const std::vector<std::string>& known = cases.front().table->columns;
  for (const std::string& column : columns) require_numbers(cases, column);
  if (columns.empty())
    std::copy_if(std::begin(kUsualColumns), std::end(kUsualColumns), std::back_inserter(columns),
                 [&](const char* name) {
                   return std::find(known.begin(), known.end(), name) != known.end();
                 });
  std::vector<std::string> others = varying_keys(cases);
  std::erase(others, by);
  std::vector<ComparisonBlock> blocks;
  for (const Case& entry : cases) {
    const std::string heading = label_of(entry, others, true);
    auto block = std::find_if(blocks.begin(), blocks.end(), [&](const ComparisonBlock& other) {
      return other.heading == heading;
    });
    if (block == blocks.end()) {
      TextRow head{by, "runs"};
      head.insert(head.end(), columns.begin(), columns.end());
      block = blocks.insert(block, {heading, {head}, {}});
    }
    TextRow row{avo_io::printable(entry.value_of(by)), fmt::format("{}", entry.runs.size())};
    const avo_io::SweepTable summary = summary_of(entry);
    for (const std::string& column : columns) row.push_back(cell(entry, summary, column));
    block->rows.push_back(std::move(row));
    block->cases.push_back(entry);
  }
  return blocks;
}

std::string readable(const std::vector<Case>& cases, std::string by,
                     std::vector<std::string> columns) {
  if (cases.empty()) return "";
  if (by.empty()) by = usual_by(cases);
  std::string text;
  for (const ComparisonBlock& block : blocks_of(cases, by, std::move(columns)))
    text += (block.heading.empty() ? "" : block.heading + "\n") + aligned(block.rows);
  return text;
}

std::string readable(const Comparison& comparison) {
  if (comparison.recordings.empty()) return "";
  std::vector<TextRow> rows{{"recording", "arrived", "until", "min_clearance"}};
  for (const auto& [name, run] : comparison.recordings) {
    std::optional<double> least;
    for (const avo_io::RecordedMoment& moment : run.moments)
      if (moment.clearance && (!least || *moment.clearance < *least)) least = moment.clearance;
    const avo_io::RecordedMoment& last = run.moments.back();
    rows.push_back({avo_io::printable(name), fmt::format("{} of {}", last.arrived, run.travelers),
                    fmt::format("{:.4g} s", last.time),
                    least ? fmt::format("{:.4g} m", *least) : "-"});
  }
  return aligned(rows);
}

}  // namespace avo_cli
