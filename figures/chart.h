// SPDX-License-Identifier: Apache-2.0
// Lines over a common x axis, as the paper's Fig. 10.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/vec.h"
#include "figures/canvas.h"
#include "figures/figure_options.h"

namespace avo::figures {

struct Series {
  std::string label;         ///< markup, for the legend below the axes; empty: not in the legend
  std::vector<Vec2> points;  ///< by ascending x
  Color color;
  bool marks = true;   ///< a dot at each point
  double dash = 0.0;   ///< pt, 0: solid
  bool plain = false;  ///< the label is plain text, not markup
  /// pt, drawn and left out in turn; it replaces `dash` if its first value is not 0.
  std::array<double, 4> pattern = {};
};

struct Chart {
  std::string x_label, y_label;  ///< markup, with the unit
  std::vector<Series> series;
  std::optional<double> y_most = {};  ///< upper end of the y axis; none: above all points
  std::string title{};                ///< plain text above the axes; empty: none
};

/// Both axes start at 0 unless a value is negative. The x axis ends behind the last curve, with
/// marks at the next tick. Throws Error if no series has a point, or if the path is not that of a
/// figure. Returns the contents of the file at `path`.
[[nodiscard]] std::string draw_chart(const Chart& chart, const std::string& path,
                                     const FigureOptions& options = {});

/// Draws the charts in rows, each on its own axes, with one legend for all. Series of one label
/// must look the same. The width in `options` is that of a chart which stands alone.
[[nodiscard]] std::string draw_charts(std::span<const Chart> charts, const std::string& path,
                                      const FigureOptions& options = {});

}  // namespace avo::figures
