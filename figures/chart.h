// SPDX-License-Identifier: Apache-2.0
// Lines over a common x axis, as the paper's Fig. 10.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "avo/vec.h"
#include "figures/canvas.h"
#include "figures/figure_options.h"

namespace avo::figures {

struct Series {
  std::string label;         ///< markup, for the legend below the axes; empty: not there
  std::vector<Vec2> points;  ///< by ascending x
  Color color;
  bool marks = true;   ///< a dot at each point
  double dash = 0.0;   ///< pt, 0: solid
  bool plain = false;  ///< the label is no markup
  /// pt, drawn and left out in turn, in place of `dash` where the first one is not 0.
  std::array<double, 4> pattern = {};
};

struct Chart {
  std::string x_label, y_label;  ///< markup, with the unit
  std::vector<Series> series;
  std::optional<double> y_most = {};  ///< where the y axis ends; none: above all points
};

/// Both axes start at 0 unless a value is negative. Throws Error where no series has a point, and
/// on a path that is no figure. Returns what the file at `path` is to hold.
[[nodiscard]] std::string draw_chart(const Chart& chart, const std::string& path,
                                     const FigureOptions& options = {});

}  // namespace avo::figures
