// SPDX-License-Identifier: Apache-2.0
// The options of a figure of a run as words: --figure-size, --figure-time and --figure-robots.
#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace avo_cli {

struct FigureSize {
  double width = 450.0;  ///< pt
  double height = 0.0;   ///< pt; 0: what fits
};
/// "600", or "600x400": from 100 to 5000 pt. These functions throw UsageError.
FigureSize figure_size(const std::string& word);

struct TimeWindow {
  double from = 0.0;                                    ///< s
  double to = std::numeric_limits<double>::infinity();  ///< s, > from
};
/// "5:20", "5:" or ":20".
TimeWindow figure_time(const std::string& word);

/// "0,3,7-9": numbers of robots, which come back in ascending order, each once.
std::vector<std::size_t> figure_robots(const std::string& word);

}  // namespace avo_cli
