// SPDX-License-Identifier: Apache-2.0
// What every figure lets its caller choose.
#pragma once
#include <string>

namespace avo::figures {

struct FigureOptions {
  double width = 450.0;  ///< pt; a PNG has two pixels to the point
  std::string title{};   ///< one line above the figure; empty: none
  bool axes = true;      ///< frame with ticks and units
};

}  // namespace avo::figures
