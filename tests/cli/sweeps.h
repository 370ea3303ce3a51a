// SPDX-License-Identifier: Apache-2.0
// Sweeps by the command line, and their tables without what differs from one time to the next.
#pragma once
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo_io/sweep.h"
#include "run_avo.h"

namespace avo_test {

using Strings = std::vector<std::string>;

/// 2 scenes x 2 methods x 2 parameters x 3 seeds.
inline const std::string kSmallSweep =
    "version: 1\n"
    "scenes: [circle-5, uniform-8]\n"
    "methods: [avo, orca]\n"
    "parameters: {sensing_radius: [12, 20]}\n"
    "seeds: {from: 4, count: 3}\n";

inline ProcessResult sweep(const std::string& yaml, Strings more,
                           const ProcessOptions& options = {}) {
  const std::string spec = path_of("sweep.yaml");
  write_file(spec, yaml);
  more.insert(more.begin(), {"sweep", spec});
  return run_avo(more, options);
}

/// Runs it to its end; the name of the table.
inline std::string swept(const std::string& yaml, const std::string& table, Strings more = {}) {
  more.insert(more.end(), {"--out", path_of(table)});
  const ProcessResult result = sweep(yaml, more);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return path_of(table);
}

/// Its text without the columns of times.
inline std::string untimed(const std::string& path) {
  avo_io::SweepTable table = avo_io::read_sweep(path);
  for (std::size_t c = table.columns.size(); c > 0; --c) {
    if (!avo_io::is_sweep_timing(table.columns[c - 1])) continue;
    const auto at = static_cast<std::ptrdiff_t>(c - 1);
    table.columns.erase(table.columns.begin() + at);
    for (Strings& row : table.rows) row.erase(row.begin() + at);
  }
  return to_csv(table);
}

/// The fields of a column.
inline Strings column(const avo_io::SweepTable& table, const std::string& name) {
  Strings fields;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c] == name)
      for (const Strings& row : table.rows) fields.push_back(row[c]);
  return fields;
}

}  // namespace avo_test
