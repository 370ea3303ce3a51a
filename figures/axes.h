// SPDX-License-Identifier: Apache-2.0
// Frame, ticks and units around the view of a canvas.
#pragma once
#include <string>
#include <vector>

#include "figures/canvas.h"

namespace avo::figures {

inline constexpr double kTitleHeight = 18.0;  // pt
inline constexpr double kMargin = 8.0;        // pt, for figures without axes

/// Returns round numbers (1, 2 or 5 times a power of ten apart) in [lower, upper], at most `most`
/// of them for most >= 2.
std::vector<double> nice_ticks(double lower, double upper, int most);

/// Returns the shortest text of a tick: "0", "2.5", "-10".
std::string tick_label(double value, double spacing);

/// The limit for an axis of any length.
inline constexpr int kMostTicks = 9;

struct Axes {
  std::string x_label = {}, y_label = {};  ///< markup, with the unit
  int most_ticks_x = 7;
  int most_ticks_y = 7;
  bool y_numbers = true;  ///< false: only ticks, for all panels of a row except the first
};

/// The space that draw_axes needs to the left of and below the view, in pt; it needs more to the
/// left if numbers are wide.
inline constexpr double kAxesLeft = 38.0;
inline constexpr double kAxesBottom = 32.0;

/// Returns the space that it needs to the left of a view of `world` in a figure at `path`, at least
/// kAxesLeft.
double axes_left(const std::string& path, const Box& world, const Axes& axes);

/// Draws the frame of the present view, with ticks and labels outside it.
void draw_axes(Canvas& canvas, const Axes& axes);

/// Draws only the lines at the ticks; call it before the data are drawn.
void draw_grid(Canvas& canvas, const Axes& axes);

}  // namespace avo::figures
