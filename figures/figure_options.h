// SPDX-License-Identifier: Apache-2.0
// Options that every figure has.
#pragma once
#include <string>

namespace avo::figures {

struct FigureOptions {
  double width = 450.0;  ///< pt; a PNG has two pixels per point
  std::string title{};   ///< one line above the figure; empty: none
  bool axes = true;      ///< frame with ticks and units
  std::string y_label = "y (m)";
};

}  // namespace avo::figures
