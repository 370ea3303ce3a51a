// SPDX-License-Identifier: Apache-2.0
// Footprints that are not discs: up to five discs of one radius in a row along the heading.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// Discs of one radius with centers at equal distances along the heading. They move and turn
/// with the robot, and together they cover its body. Others keep clear of these discs, and of
/// nothing else (docs/certificate/footprints.md).
struct Footprint {
  int discs = 0;         ///< 1 to kMostDiscs; 0: no footprint, the robot is one disc
  double radius = 0.5;   ///< m, > 0, of each disc
  double first = 0.0;    ///< m, from the robot's position forward to the rearmost center
  double spacing = 0.0;  ///< m, >= 0, from one center to the next

  static constexpr int kMostDiscs = 5;
  constexpr explicit operator bool() const { return discs > 0; }
  /// m, from the robot's position forward to the center of disc k.
  [[nodiscard]] constexpr double ahead(int k) const { return first + k * spacing; }
  friend constexpr bool operator==(const Footprint&, const Footprint&) = default;
};

/// m: the largest distance of a center from the robot's position.
inline double farthest_center(const Footprint& footprint) {
  return std::max(std::abs(footprint.first), std::abs(footprint.ahead(footprint.discs - 1)));
}
/// m: the radius of the disc about the robot's position that covers the footprint at any heading.
inline double bounding_radius(const Footprint& footprint) {
  return farthest_center(footprint) + footprint.radius;
}

/// A body for which no cover was asked for in particular may be exceeded at its sides by this part
/// of its width.
inline constexpr double kUsualExcess = 0.25;

/// Returns the fewest discs that cover a rectangle along the heading and exceed its long sides by
/// at most `excess`, m. `offset`: m, from the robot's position forward to the rectangle's center.
/// Throws Error if kMostDiscs discs exceed the sides by more, or on values out of range.
AVO_API Footprint cover_rectangle(double length, double width, double offset, double excess);

/// The same for a polygon, by its corners in the robot's frame: x along the heading, y to its left.
/// The discs exceed the polygon's largest |y| by at most `excess`. They are centered on the line
/// y = 0.
AVO_API Footprint cover_polygon(std::span<const Vec2> corners, double excess);

}  // namespace avo
