// SPDX-License-Identifier: Apache-2.0
// Options that every figure has.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace avo::figures {

struct FigureOptions {
  double width = 450.0;               ///< pt; a PNG has two pixels per point
  double height = 0.0;                ///< pt, of a time-lapse; 0: what fits its content
  std::string title{};                ///< one line above the figure; empty: none
  bool axes = true;                   ///< frame with ticks and units
  std::vector<std::size_t> robots{};  ///< rows of those in a time-lapse, ascending; empty: all
  std::string y_label = "y (m)";      ///< of a time-lapse
};

}  // namespace avo::figures
