// SPDX-License-Identifier: Apache-2.0
// Lemmas 12 and 13 of docs/half_plane.md. The hull within reach has as near corners the wall of τ
// and points of the circle |w| = R. These are crossings of the circle and near sides of its two
// ends, or of the circle and the wall of τ.
#include "obstacles/wall_horn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "obstacles/horn.h"
#include "obstacles/wall_pair.h"

namespace avo::inline obstacles {
namespace {

using Real = scalar::Pack<double>;

struct WallHull {
  Vec2 separating{};
  double R = 0.0;              // m/s
  std::array<Disc, 2> last{};  // the ends' discs of τ
  bool last_in_reach = false;  // a part of the wall of τ is in reach
  // on the circle: at most four near sides; the discs of τ and the sides between them cut it in two
  // points each
  std::array<Vec2, 4 * NearCorners::kMost + 8> corners{};
  std::size_t count = 0;
  HalfPlane least{{}, std::numeric_limits<double>::infinity()};

  void add(Vec2 corner) { corners[count++] = corner; }

  // The support on the near side: where the extreme point of the wall of τ is out of reach, its
  // corners on the circle replace it.
  double support(Vec2 n) const {
    double h = -std::numeric_limits<double>::infinity();
    for (const Disc& disc : last) {
      const Vec2 extreme = disc.center + disc.radius * n;
      if (norm_squared(extreme) <= R * R) h = std::max(h, dot(n, disc.center) + disc.radius);
    }
    for (std::size_t k = 0; k < count; ++k) h = std::max(h, dot(n, corners[k]));
    return h;
  }

  void offer(Vec2 n) {
    if (!(dot(n, separating) >= 0.0)) return;
    const double h = support(n);
    if (h < least.offset - kEqualSupports * R) least = {n, h};
  }
};

// The sides of an end's horn along which n . v >= 0.
void add_near_sides(const WallPair& pair, Vec2 from_end, const Horizon& horizon, WallHull& hull) {
  const double d = norm(from_end);
  const Vec2 e = from_end / d, v = pair.velocity;
  const double along = dot(e, v), across = cross(e, v);
  const bool recedes = along >= 0.0 && d * std::abs(across) < pair.radius * norm(v);
  for (const double side : {1.0, -1.0}) {
    if (!(side * across >= 0.0 || recedes)) continue;
    const NearCorners corners =
        near_corners({d, {along, side * across}, pair.radius, hull.R}, horizon);
    for (std::size_t k = 0; k < corners.count; ++k) {
      const auto [x, y] = corners.points[k];
      hull.add(x.value * e + (side * y.value) * perpendicular(e));
    }
  }
}

// The points where the circle of radius R about 0 cuts a disc's edge.
void add_cuts(const Disc& disc, WallHull& hull) {
  const double c = norm(disc.center), R = hull.R;
  if (!(c > 0.0) || c > R + disc.radius || c < std::abs(R - disc.radius)) return;
  const double foot = 0.5 * (c + (R - disc.radius) * (R + disc.radius) / c);
  const double half = std::sqrt(std::max(0.0, (R - foot) * (R + foot)));
  const Vec2 e = disc.center / c;
  hull.add(foot * e + half * perpendicular(e));
  hull.add(foot * e - half * perpendicular(e));
}

// The points where it cuts a side between the two discs.
void add_cuts(Vec2 from, Vec2 to, WallHull& hull) {
  const Vec2 along = to - from;
  const double length = norm(along);
  if (!(length > 0.0)) return;
  const Vec2 e = along / length;
  const double foot = -dot(from, e), miss = std::abs(cross(e, from));
  if (!(miss < hull.R)) return;
  const double half = std::sqrt((hull.R - miss) * (hull.R + miss));
  for (const double place : {foot - half, foot + half}) {
    if (place >= 0.0 && place <= length) hull.add(from + place * e);
  }
}

// The wall of τ, a disc about each end and the area between them.
void add_last_wall(const WallPair& pair, Vec2 wall_normal, const Horizon& horizon, WallHull& hull) {
  const ResponseAt& end = horizon.end();
  const Vec2 coasted = end.time * pair.velocity;
  const double radius = pair.radius / end.gain;
  hull.last = {Disc{(-1.0 / end.gain) * (pair.from_a + coasted), radius},
               Disc{(-1.0 / end.gain) * (pair.from_b + coasted), radius}};
  hull.last_in_reach = norm(away_from_wall(pair, coasted)) - pair.radius < hull.R * end.gain;
  if (!hull.last_in_reach) return;
  for (const Disc& disc : hull.last) add_cuts(disc, hull);
  for (const double side : {radius, -radius}) {
    const Vec2 out = side * wall_normal;
    add_cuts(hull.last[0].center + out, hull.last[1].center + out, hull);
  }
}

// The two outermost of the corners, which all lie on one half of the circle.
struct Outermost {
  Vec2 left, right;
};
Outermost outermost(const WallHull& hull) {
  // tan(φ/2), φ is the angle from the middle of the half circle
  const Vec2 up = hull.separating;
  const auto place = [&](Vec2 w) { return cross(up, w) / (hull.R - dot(up, w)); };
  const auto begin = hull.corners.begin();
  const auto [right, left] =
      std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(hull.count),
                          [&](Vec2 a, Vec2 b) { return place(a) < place(b); });
  return {*left, *right};
}

// Normals of the lines through the corner that touch the disc.
void offer_tangents(Vec2 corner, const Disc& disc, WallHull& hull) {
  const Vec2 m = disc.center - corner;
  const double m2 = norm_squared(m), l2 = m2 - disc.radius * disc.radius;
  if (!(l2 > 0.0)) return;
  const double l = std::sqrt(l2);
  hull.offer((1.0 / m2) * (l * perpendicular(m) - disc.radius * m));
  hull.offer((-1.0 / m2) * (l * perpendicular(m) + disc.radius * m));
}

void offer_edges(WallHull& hull) {
  if (hull.count == 0) return;
  const auto [left, right] = outermost(hull);
  for (const Vec2 corner : {left, right}) {
    for (const Disc& disc : hull.last) {
      if (hull.last_in_reach) offer_tangents(corner, disc, hull);
    }
  }
  const Vec2 chord = right - left;
  const double length = norm(chord);
  if (!(length > 0.0)) return;
  hull.offer(perpendicular(chord) / length);
  hull.offer(perpendicular(chord) / -length);
}

}  // namespace

RelativeHalfPlane wall_horn(const WallPair& pair, Vec2 separating, double reach,
                            const Horizon& horizon) {
  const Vec2 end = away_from_wall(pair, horizon.end().time * pair.velocity);
  const double length = norm(end);
  const Vec2 n = end / length;
  const auto separates = [&](Vec2 from_end) { return dot(n, from_end) >= pair.radius; };
  if (separates(pair.from_a) && separates(pair.from_b)) {
    const double h = (pair.radius - length) / horizon.end().gain;
    if (h <= -reach) return {};
    return {PairState::constrained, {n, h}};
  }
  WallHull hull;
  hull.separating = separating, hull.R = reach;
  add_last_wall(pair, facing(pair).normal, horizon, hull);
  for (const Vec2 from_end : ends_of(pair)) add_near_sides(pair, from_end, horizon, hull);
  if (hull.last_in_reach) hull.offer(n);
  offer_edges(hull);
  if (!(hull.least.offset < reach)) return {};
  return {PairState::constrained, hull.least};
}

}  // namespace avo::inline obstacles
