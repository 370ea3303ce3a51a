// SPDX-License-Identifier: Apache-2.0
// Puts labels where they hide least.
#pragma once
#include <string>
#include <vector>

#include "figures/canvas.h"

namespace avo::figures {

/// Remembers what the labels of one view must not cover, and where they stand.
class Labels {
 public:
  explicit Labels(Canvas& canvas) : canvas_(canvas) {}

  /// A square of the page around a point of the world; half-width in pt.
  void keep_free(Vec2 world, double half_width);

  /// Markup beside `world`, `distance` pt or a little more from it (negative: onto it): where it
  /// hides least; near rather than far, and the first of equal sides. Returns the rectangle taken
  /// on the page.
  Box place(Vec2 world, const std::string& markup, const TextStyle& style, double distance);

 private:
  [[nodiscard]] double hidden(const Box& box) const;  // pt^2, what leaves the view included

  Canvas& canvas_;
  std::vector<Box> taken_;
};

}  // namespace avo::figures
