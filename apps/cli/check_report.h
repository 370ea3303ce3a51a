// SPDX-License-Identifier: Apache-2.0
// What avo check says.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/check.h"

namespace avo_cli {

struct Judgement {
  avo::CheckReport report;
  std::string recording;
  std::optional<std::string> scene;
  std::optional<double> time_step;             ///< s, of the scene
  std::vector<std::int64_t> numbers;           ///< of the robots by index; empty: their indices
  std::vector<std::int64_t> obstacle_of_wall;  ///< number of the static obstacle
  double tolerance = 0.0;
  std::int64_t uneven_steps = 0;  ///< not time_step long
  std::int64_t every = 1;         ///< the recording has rows of every so many steps, as it says
  bool require_arrival = false;
  bool free_clocks = false;  ///< in the scene

  [[nodiscard]] bool passed() const {
    return report.safe() && (!require_arrival || report.arrived == report.with_goal);
  }
  /// Rows are missing, and those that are there break no rule.
  [[nodiscard]] bool incomplete() const { return !report.broken() && report.unjudged_steps > 0; }
};

/// A short table.
std::string readable(const Judgement& judgement);
/// One JSON object, keys in a fixed order; what there is not is null.
std::string to_json(const Judgement& judgement);

}  // namespace avo_cli
