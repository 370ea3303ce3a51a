// SPDX-License-Identifier: Apache-2.0
// How near two bodies come over one step, and when, by isolating the roots of d/du |x(u)|².
//
// |x|² is a sextic, x·x' a quintic. In Bernstein form the number of sign changes of its six
// coefficients bounds the number of its roots from above (Descartes). None means that the distance
// is monotone, one means exactly one root, which is bisected; with more, the interval is halved.
// The halves' coefficients are computed anew from the halved cubic. Its rounding is that of the
// distance itself.
#include "check/relative_path.h"

#include <algorithm>
#include <cmath>

namespace avo::judge {
namespace {

// A distance may have an error of this part of the largest one. Rounding makes up a sixth of it.
constexpr double kResolution = 0x1p-45;

using Quintic = std::array<double, 6>;

// A part of the path and the fractions of the step that it covers.
struct Part {
  std::array<Vec2, 4> b;
  double from, to;
};

Vec2 middle(Vec2 a, Vec2 b) {
  return 0.5 * (a + b);
}

std::array<Part, 2> halves(const Part& part) {
  const auto& b = part.b;
  const Vec2 b01 = middle(b[0], b[1]), b12 = middle(b[1], b[2]), b23 = middle(b[2], b[3]);
  const Vec2 b012 = middle(b01, b12), b123 = middle(b12, b23), center = middle(b012, b123);
  const double half = 0.5 * (part.from + part.to);
  return {
      {{{b[0], b01, b012, center}, part.from, half}, {{center, b123, b23, b[3]}, half, part.to}}};
}

Vec2 point_at(const std::array<Vec2, 4>& b, double u) {
  const auto between = [u](Vec2 from, Vec2 to) { return (1.0 - u) * from + u * to; };
  const Vec2 b01 = between(b[0], b[1]), b12 = between(b[1], b[2]), b23 = between(b[2], b[3]);
  return between(between(b01, b12), between(b12, b23));
}

// x·x'/3 of the part in Bernstein form, by its own fraction.
Quintic slope(const std::array<Vec2, 4>& x) {
  const Vec2 d0 = x[1] - x[0], d1 = x[2] - x[1], d2 = x[3] - x[2];
  return {dot(x[0], d0),
          (2.0 * dot(x[0], d1) + 3.0 * dot(x[1], d0)) / 5.0,
          (dot(x[0], d2) + 6.0 * dot(x[1], d1) + 3.0 * dot(x[2], d0)) / 10.0,
          (3.0 * dot(x[1], d2) + 6.0 * dot(x[2], d1) + dot(x[3], d0)) / 10.0,
          (3.0 * dot(x[2], d2) + 2.0 * dot(x[3], d1)) / 5.0,
          dot(x[3], d2)};
}

struct Signs {
  int changes = 0;
  bool falls_first = false;  // the first coefficient that is not zero is negative
};

Signs signs(const Quintic& b) {
  Signs result;
  double last = 0.0;
  for (const double coefficient : b) {
    if (coefficient == 0.0) continue;
    if (last == 0.0) result.falls_first = coefficient < 0.0;
    if (last != 0.0 && (last < 0.0) != (coefficient < 0.0)) ++result.changes;
    last = coefficient;
  }
  return result;
}

// The root of b, which is negative before and positive after it.
double rising_root(const Quintic& b) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 52; ++i) {
    const double half = 0.5 * (low + high);
    (value_at(b, half) < 0.0 ? low : high) = half;
  }
  return 0.5 * (low + high);
}

// Returns whether the ends of the part give the smallest distance to kResolution * size. Either the
// part is that short, or |x|² changes by at most 3 max|b| from the nearer end on, and |x| by that
// over |x|.
bool is_settled(const Part& part, const Quintic& b, double size) {
  const double length =
      norm(part.b[1] - part.b[0]) + norm(part.b[2] - part.b[1]) + norm(part.b[3] - part.b[2]);
  const double resolution = kResolution * size;
  if (length <= resolution) return true;
  double most = 0.0;
  for (const double coefficient : b) most = std::max(most, std::abs(coefficient));
  return 3.0 * most <= resolution * std::min(norm(part.b[0]), norm(part.b[3]));
}

// Calls visit(instant) for all local minima within the part, its end and some more instants, by
// ascending time, until visit returns false. Between two instants the distance rises, falls, or
// rises and then falls.
template <typename Visit>
bool visit_turns(const Part& part, double size, const Visit& visit) {
  const Quintic b = slope(part.b);
  const Signs counted = signs(b);
  if (counted.changes > 1 && !is_settled(part, b, size)) {
    const auto [left, right] = halves(part);
    return visit_turns(left, size, visit) && visit_turns(right, size, visit);
  }
  if (counted.changes == 1 && counted.falls_first) {
    const double u = rising_root(b);
    if (!visit(Instant{part.from + u * (part.to - part.from), norm(point_at(part.b, u))}))
      return false;
  }
  return visit(Instant{part.to, norm(part.b[3])});
}

template <typename Visit>
void visit_turns(const RelativePath& path, const Visit& visit) {
  double size = 0.0;
  for (const Vec2 point : path.control) size = std::max(size, norm(point));
  if (visit(Instant{0.0, norm(path.control[0])}))
    visit_turns(Part{path.control, 0.0, 1.0}, size, visit);
}

}  // namespace

Instant nearest_instant(const RelativePath& path) {
  Instant nearest{0.0, norm(path.control[0])};
  visit_turns(path, [&nearest](const Instant& instant) {
    if (instant.distance < nearest.distance) nearest = instant;
    return true;
  });
  return nearest;
}

std::optional<double> first_below(const RelativePath& path, double limit) {
  std::optional<double> first;
  visit_turns(path, [&](const Instant& instant) {
    if (instant.distance < limit) first = instant.fraction;
    return !first;
  });
  if (!first || *first == 0.0) return first;
  // all minima before this instant are above the limit: one crossing
  double low = 0.0, high = *first;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    (norm(point_at(path.control, half)) < limit ? high : low) = half;
  }
  return high;
}

std::optional<double> last_below(const RelativePath& path, double limit) {
  const auto& c = path.control;
  const std::optional<double> first = first_below(RelativePath{{c[3], c[2], c[1], c[0]}}, limit);
  if (!first) return first;
  return 1.0 - *first;
}

double lower_bound(const RelativePath& path) {
  const auto& c = path.control;
  const Vec2 center = middle(c[0], c[3]);
  double spread = 0.0;
  for (const Vec2 point : c) spread = std::max(spread, norm_squared(point - center));
  return norm(center) - std::sqrt(spread);
}

}  // namespace avo::judge
