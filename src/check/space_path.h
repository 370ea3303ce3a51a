// SPDX-License-Identifier: Apache-2.0
// The distance of a cubic path of space from a convex body.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "avo/space/box.h"
#include "avo/vec3.h"

namespace avo::judge {

/// The four Bézier points of a cubic path, m.
using Cubic = std::array<Vec3, 4>;

/// The cubic with these places and velocities at its ends.
inline Cubic cubic_of(Vec3 p0, Vec3 v0, Vec3 p1, Vec3 v1, double duration) {
  const double third = duration / 3.0;
  return {p0, p0 + third * v0, p1 - third * v1, p1};
}

/// A vertical segment from (0, 0, low) to (0, 0, high).
struct Stick {
  double low = 0.0, high = 0.0;  ///< m

  [[nodiscard]] Vec3 nearest(Vec3 a) const { return {0.0, 0.0, std::clamp(a.z, low, high)}; }
  /// The largest n . x of its points x.
  [[nodiscard]] double support(Vec3 n) const { return n.z > 0.0 ? n.z * high : n.z * low; }
};

/// A box along the axes, maybe without ends.
struct Block {
  Vec3 min, max;  ///< m

  [[nodiscard]] Vec3 nearest(Vec3 a) const {
    return {std::clamp(a.x, min.x, max.x), std::clamp(a.y, min.y, max.y),
            std::clamp(a.z, min.z, max.z)};
  }
  [[nodiscard]] double support(Vec3 n) const {
    const auto most = [](double part, double low, double high) {
      return part > 0.0 ? part * high : part < 0.0 ? part * low : 0.0;
    };
    return most(n.x, min.x, max.x) + most(n.y, min.y, max.y) + most(n.z, min.z, max.z);
  }
};

struct Halves {
  Cubic first, second;
};
inline Halves halved(const Cubic& q) {
  const auto middle = [](Vec3 a, Vec3 b) { return 0.5 * (a + b); };
  const Vec3 a = middle(q[0], q[1]), b = middle(q[1], q[2]), c = middle(q[2], q[3]);
  const Vec3 d = middle(a, b), e = middle(b, c), f = middle(d, e);
  return {{q[0], a, d, f}, {f, e, c, q[3]}};
}

/// m: the least distance of the path from the body, to 1e-12 m and the rounding of its places.
/// Where it is at least `enough`, any value that is at least `enough`. The path lies in the hull of
/// its four points. The plane across the direction from the body to the middle of the path bounds
/// the hull's distance from below.
template <typename Body>
double least_distance(const Cubic& path, const Body& body, double enough) {
  double tolerance = 1e-12;
  for (const Vec3& point : path)
    tolerance =
        std::max(tolerance, 8e-16 * (std::abs(point.x) + std::abs(point.y) + std::abs(point.z)));
  const auto distance = [&body](Vec3 a) { return norm(a - body.nearest(a)); };
  double best = std::min(distance(path[0]), distance(path[3]));
  std::vector<Cubic> open{path};
  while (!open.empty()) {
    const Cubic piece = open.back();
    open.pop_back();
    const Halves halves = halved(piece);
    const Vec3 middle = halves.second[0], away = middle - body.nearest(middle);
    const double here = norm(away);
    best = std::min(best, here);
    if (!(here > 0.0)) return 0.0;
    const Vec3 n = away / here;
    double least = dot(n, piece[0]);
    for (const Vec3& point : piece) least = std::min(least, dot(n, point));
    const double bound = least - body.support(n);
    if (bound >= std::min(best, enough) - tolerance) continue;
    // nothing is shorter than rounding
    if (norm(piece[3] - piece[0]) + norm(piece[1] - piece[0]) + norm(piece[2] - piece[0]) <
        tolerance)
      continue;
    open.push_back(halves.first);
    open.push_back(halves.second);
  }
  return best;
}

}  // namespace avo::judge
