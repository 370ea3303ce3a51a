// SPDX-License-Identifier: Apache-2.0
// The options of the harness.
#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "avo/scenario.h"

namespace avo::safety {

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  bool help = false, list = false;
  std::vector<std::string> rows;  ///< names, or beginnings of names; none: all rows
  std::optional<int> scenes;      ///< for each row whose scenes differ
  std::uint64_t first_seed = 1;
  double soak_steps = 1e7;  ///< see families()
  int threads = 1;
  std::string json, record;  ///< paths; empty: none
  std::optional<Method> method;
  std::optional<Certificate> certificate;
  std::optional<Motion> motion;
  std::optional<double> control_time, time_horizon;  ///< s
  /// the text of those of the five options above that were given
  std::vector<std::string> settings;
};

/// Throws UsageError with one line: where, what was found, what is allowed.
Options parse_options(int count, const char* const* arguments);

const char* usage();

/// Returns whether a row is selected by its name, or by the beginning of its name if no row has
/// exactly that name.
bool is_asked_for(const Options& options, const std::string& row,
                  const std::vector<std::string>& all_rows);

/// Applies the options to the scene.
void apply(const Options& options, Scenario& scenario);

}  // namespace avo::safety
