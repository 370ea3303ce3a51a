// SPDX-License-Identifier: Apache-2.0
// The general search for the half-plane in the horn case, and the entry by which half_planes() uses
// it.
#pragma once
#include <array>
#include <cstddef>

#include "avo/half_plane.h"
#include "obstacles/half_planes_kernel.h"

namespace avo::inline obstacles {

/// Corners of the hull on one side of a horn: the crossings of that side and the circle |w| = R.
/// They have the order of walking along it with the obstacle on the right, by ascending time.
struct NearCorners {
  // |b| turns at most five times (three signs of `tangential`, two cusps): six pieces with one
  // crossing each, three ends of the first disc.
  static constexpr std::size_t kMost = 9;
  using Point = scalar::Vec<scalar::Pack<double>>;
  std::array<Point, kMost> points{};
  std::size_t count = 0;

  void add(Point point) {
    if (count < kMost) points[count++] = point;
  }
  void add(const scalar::TwoPoints<scalar::Pack<double>>& ends) {
    add(ends.near);
    add(ends.far);
  }
};

/// The corners of the side on the left of p, in the pair's frame, along which n . v >= 0: v.y >= 0,
/// or v.x >= 0 and a miss distance below r.
NearCorners near_corners(const scalar::Local<scalar::Pack<double>>& pair, const Horizon& horizon);

/// The horn case: v does not lead into a collision (p . v >= 0 or a miss distance >= r, and d >=
/// r), and the disc of τ alone is not nearest. The result is always settled.
scalar::HornPlane<scalar::Pack<double>> searched_horn(
    const scalar::Local<scalar::Pack<double>>& pair, const Horizon& horizon);

/// half_plane() of a pair in the horn case that no kernel settles.
RelativeHalfPlane searched_half_plane(const Pair& pair, double reach,
                                      const Horizon& horizon) noexcept;

}  // namespace avo::inline obstacles
