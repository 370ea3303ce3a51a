// SPDX-License-Identifier: Apache-2.0
// The summary of a sweep's runs that differ in nothing but their seeds.
#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <system_error>

#include "avo_io/sweep.h"
#include "core/ranges.h"
#include "io/sweep/statistics.h"

namespace avo_io {
namespace {

constexpr std::array<std::string_view, 2> kShares{"all_arrived", "collided"};
constexpr std::array<const char*, 6> kStatistics{"count", "median", "p95", "mean", "low", "high"};
constexpr std::size_t kScene = 2;  // column

bool is_share(std::string_view column) {
  return std::find(kShares.begin(), kShares.end(), column) != kShares.end();
}

/// Returns whether the runs are a sample. One run is not, nor are several runs with the same final
/// state of a scene that does not use the seed.
bool is_sample(const std::vector<const std::vector<std::string>*>& group, std::size_t state_hash) {
  return std::any_of(group.begin(), group.end(), [&](const std::vector<std::string>* run) {
    return (*run)[state_hash] != (*group.front())[state_hash];
  });
}

void append_statistics(std::vector<double> values, bool share, bool sample,
                       std::vector<std::string>& row) {
  row.push_back(fmt::format("{}", values.size()));
  if (values.empty()) {
    row.resize(row.size() + kStatistics.size() - 1);
    return;
  }
  std::sort(values.begin(), values.end());  // sums in another order could differ in the last bit
  if (share)
    row.resize(row.size() + 2);
  else
    for (const double part : {0.5, 0.95}) row.push_back(avo::text(quantile(values, part)));
  row.push_back(avo::text(mean_of(values)));
  std::optional<Interval> interval;
  if (sample && !share) interval = mean_interval(values);
  if (sample && share) {
    const auto ones = std::count(values.begin(), values.end(), 1.0);
    interval = share_interval(ones, std::ssize(values));
  }
  row.push_back(interval ? avo::text(interval->low) : "");
  row.push_back(interval ? avo::text(interval->high) : "");
}

}  // namespace

std::optional<double> number_in(std::string_view field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

SweepTable summary_of(const SweepTable& runs) {
  const std::size_t seed = parameters_of(runs).second;
  const std::size_t first = seed + 2;  // behind "state_hash"
  SweepTable summary;
  summary.columns.assign(runs.columns.begin() + kScene,
                         runs.columns.begin() + static_cast<std::ptrdiff_t>(seed));
  summary.columns.emplace_back("runs");
  for (std::size_t c = first; c < runs.columns.size(); ++c)
    for (const char* name : kStatistics) summary.columns.push_back(runs.columns[c] + "." + name);
  using Row = std::vector<std::string>;
  std::vector<Row> keys;  // in the order of their first runs
  std::map<Row, std::vector<const Row*>> groups;
  for (const Row& row : runs.rows) {
    Row key(row.begin() + kScene, row.begin() + static_cast<std::ptrdiff_t>(seed));
    std::vector<const Row*>& group = groups[key];
    if (group.empty()) keys.push_back(key);
    group.push_back(&row);
  }
  for (Row& key : keys) {
    const std::vector<const Row*>& group = groups[key];
    Row row = std::move(key);
    row.push_back(fmt::format("{}", group.size()));
    const bool sample = is_sample(group, seed + 1);
    for (std::size_t c = first; c < runs.columns.size(); ++c) {
      std::vector<double> values;
      for (const Row* run : group)
        if (const std::optional<double> value = number_in((*run)[c])) values.push_back(*value);
      append_statistics(std::move(values), is_share(runs.columns[c]), sample, row);
    }
    summary.rows.push_back(std::move(row));
  }
  return summary;
}

}  // namespace avo_io
