// SPDX-License-Identifier: Apache-2.0
// Places labels such that they cover as little as possible.
#pragma once
#include <string>
#include <vector>

#include "figures/canvas.h"

namespace avo::figures {

/// Stores the areas of one view that labels must not cover, and the places of the labels.
class Labels {
 public:
  explicit Labels(Canvas& canvas) : canvas_(canvas) {}

  /// Adds a square of the page around a point of the world; the half-width is in pt.
  void keep_free(Vec2 world, double half_width);

  /// Places markup beside `world`, `distance` pt or a little more from it (negative: onto it). It
  /// takes the place that covers least. It prefers near places, and the first of equal sides.
  /// Returns the rectangle that the label takes on the page.
  Box place(Vec2 world, const std::string& markup, const TextStyle& style, double distance);

 private:
  [[nodiscard]] double hidden(const Box& box) const;  // pt^2, including the part outside the view

  Canvas& canvas_;
  std::vector<Box> taken_;
};

}  // namespace avo::figures
