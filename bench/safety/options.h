// SPDX-License-Identifier: Apache-2.0
// What the harness is asked for.
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
  std::vector<std::string> rows;  ///< names or their beginnings; none: all
  std::optional<int> scenes;      ///< of each row whose scenes differ
  std::uint64_t first_seed = 1;
  double soak_steps = 1e7;  ///< see families()
  int threads = 1;
  std::string json, record;  ///< paths; empty: none
  std::optional<Method> method;
  std::optional<Certificate> certificate;
  std::optional<Motion> motion;
  std::optional<double> control_time, time_horizon;  ///< s
  std::vector<std::string> settings;  ///< those of the five above, as they were given
};

/// Throws UsageError with one line: where, what was found, what is allowed.
Options parse_options(int count, const char* const* arguments);

const char* usage();

/// A row is asked for by its name, or by the beginning of its name where no row has it as its name.
bool is_asked_for(const Options& options, const std::string& row,
                  const std::vector<std::string>& all_rows);

/// Puts what was asked for into the scene.
void apply(const Options& options, Scenario& scenario);

}  // namespace avo::safety
