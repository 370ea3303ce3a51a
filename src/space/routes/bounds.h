// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <limits>

#include "avo/vec3.h"

namespace avo::space {

inline Vec3 least_of(Vec3 a, Vec3 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vec3 most_of(Vec3 a, Vec3 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Points between two corners, m. Nothing at first; bounds may be infinite.
struct Bounds {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 low = {kFar, kFar, kFar};
  Vec3 high = {-kFar, -kFar, -kFar};

  void include(Vec3 a) { low = least_of(low, a), high = most_of(high, a); }
  void include(const Bounds& other) {
    low = least_of(low, other.low), high = most_of(high, other.high);
  }
  [[nodiscard]] bool contain(Vec3 a) const {
    return low.x <= a.x && a.x <= high.x && low.y <= a.y && a.y <= high.y && low.z <= a.z &&
           a.z <= high.z;
  }
  [[nodiscard]] Bounds grown(double by) const {
    const Vec3 all{by, by, by};
    return {low - all, high + all};
  }
};

}  // namespace avo::space
