// SPDX-License-Identifier: Apache-2.0
// Closed forms on the intersection of two discs: projection, support, corners (paper §IV-D).
#include "support/program/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::reference {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kToleranceUlps = 8.0;
constexpr double kTouchingUlps = 2.0;
// The corners need fourth powers: 2^-200 to 2^200 leaves room for these in a double.
constexpr double kLargest = 0x1p200;
constexpr double kSmallest = 0x1p-200;

double largest_component(Vec2 a) {
  return std::max(std::abs(a.x), std::abs(a.y));
}

// Returns a power of two that brings the discs into the range where squares are safe; it is nearly
// always 1.
double safe_scale(const Disc& a, const Disc& b) {
  double size = std::max(largest_component(a.center), largest_component(b.center));
  for (double radius : {a.radius, b.radius}) {
    if (std::isfinite(radius)) size = std::max(size, radius);
  }
  if (size <= kLargest && (size >= kSmallest || size == 0.0)) return 1.0;
  return std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

// A point just computed on one circle may miss the inside of the other by rounding alone. For discs
// that are nearly equal, that must not look like "outside both": the corner may be far away.
constexpr double kRoundingOfSquares = 1.0 + 8.0 * kUlp;

bool in_smaller(const Lens& lens, Vec2 u, double rounding = kRoundingOfSquares) {
  return norm_squared(u) <= lens.radius * lens.radius * rounding;
}

bool in_larger(const Lens& lens, Vec2 u, double rounding = kRoundingOfSquares) {
  return !lens.two_arcs ||
         norm_squared(u - lens.larger_center) <= lens.larger_radius * lens.larger_radius * rounding;
}

// Returns the point where the circles meet. It is on the left of the axis from the smaller to the
// larger disc (side = 1), or on its right (side = -1). It is on the smaller circle up to rounding,
// whatever the size of the larger one.
Vec2 corner(const Lens& lens, double side) {
  const double r = lens.radius;
  const double R = lens.larger_radius;
  const double D = lens.distance;
  const double along = std::clamp(((r - R) * (r + R) + D * D) / (2.0 * D), -r, r);
  const double height = std::sqrt((r - along) * (r + along));
  const Vec2 axis = lens.larger_center / D;
  return along * axis + (side * height) * perpendicular(axis);
}

Vec2 corner_towards(const Lens& lens, Vec2 p) {
  return corner(lens, cross(lens.larger_center, p) >= 0.0 ? 1.0 : -1.0);
}

}  // namespace

Lens make_lens(const Disc& acceleration, const Disc& speed) noexcept {
  const double scale = safe_scale(acceleration, speed);
  Lens lens;
  lens.scale = scale;
  lens.speed_is_larger = acceleration.radius <= speed.radius;
  const Disc& smaller = lens.speed_is_larger ? acceleration : speed;
  const Disc& larger = lens.speed_is_larger ? speed : acceleration;
  lens.origin = scale * smaller.center;
  lens.radius = scale * smaller.radius;
  lens.tolerance = kToleranceUlps * kUlp * (largest_component(lens.origin) + lens.radius);
  lens.larger_radius = scale * larger.radius;
  lens.larger_center = scale * larger.center - lens.origin;
  lens.distance = norm(lens.larger_center);
  lens.two_arcs = lens.distance > lens.larger_radius - lens.radius;
  if (lens.two_arcs) {
    lens.larger_tolerance =
        kToleranceUlps * kUlp * (scale * largest_component(larger.center) + lens.larger_radius);
    const double gap = (lens.distance - lens.larger_radius) - lens.radius;
    lens.empty = gap > kTouchingUlps / kToleranceUlps * lens.larger_tolerance;
  }
  return lens;
}

LensPoint nearest(const Lens& lens, Vec2 p) noexcept {
  const bool inside_smaller = in_smaller(lens, p, 1.0);
  const bool inside_larger = in_larger(lens, p, 1.0);
  if (inside_smaller && inside_larger) return {p};
  if (!inside_smaller) {
    const Vec2 u = (lens.radius / norm(p)) * p;
    if (in_larger(lens, u)) return {u, true};
  }
  if (!inside_larger) {
    const Vec2 q = p - lens.larger_center;
    const Vec2 u = lens.larger_center + (lens.larger_radius / norm(q)) * q;
    if (in_smaller(lens, u)) return {u, true};
  }
  return {corner_towards(lens, p), true};
}

Vec2 farthest_along(const Lens& lens, Vec2 direction) noexcept {
  const double length = norm(direction);
  if (!(length > 0.0)) return nearest(lens, {}).point;
  const Vec2 n = direction / length;
  if (const Vec2 u = lens.radius * n; in_larger(lens, u)) return u;
  if (const Vec2 u = lens.larger_center + lens.larger_radius * n; in_smaller(lens, u)) return u;
  return corner_towards(lens, n);
}

double lens_support_min(Vec2 normal, const Lens& lens) noexcept {
  if (lens.empty) return std::numeric_limits<double>::infinity();
  return dot(normal, lens.origin + farthest_along(lens, -normal)) / lens.scale;
}

double lens_support_min(Vec2 normal, const Disc& acceleration, const Disc& speed) noexcept {
  return lens_support_min(normal, make_lens(acceleration, speed));
}

}  // namespace avo::reference
