// SPDX-License-Identifier: Apache-2.0
// Eq. (23) in the plane: one half-plane after the other, one line at a time.
#include "support/program/planar_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace avo::reference {
namespace {

// The boundary of a half-plane: offset * normal + t * along, |normal| = |along| = 1.
struct Line {
  Vec2 normal;
  Vec2 along;
  double offset = 0.0;
};

// The remaining part of a line, lo <= t <= hi.
struct Range {
  double lo = 0.0;
  double hi = 0.0;
};

bool is_linear(const Goal& goal) {
  return goal.direction.x != 0.0 || goal.direction.y != 0.0;
}

// Computes both ends in factors (r - o)(r + o): r² - o² would lose half the digits of a short
// chord.
bool clip_to_discs(const Lens& lens, const Line& line, bool relaxed, Range& range) {
  const double slack = relaxed ? 0.5 * lens.tolerance : 0.0;
  const double gap = lens.radius - std::abs(line.offset);
  if (gap < -slack) return false;
  const double half =
      slack + (gap > 0.0 ? std::sqrt(gap * (lens.radius + std::abs(line.offset))) : 0.0);
  range = {-half, half};
  if (!lens.two_arcs) return true;

  const double larger_slack = relaxed ? 0.5 * lens.larger_tolerance : 0.0;
  const double offset = std::abs(line.offset - dot(line.normal, lens.larger_center));
  const double larger_gap = lens.larger_radius - offset;
  if (larger_gap < -larger_slack) return false;
  const double larger_half =
      larger_slack +
      (larger_gap > 0.0 ? std::sqrt(larger_gap * (lens.larger_radius + offset)) : 0.0);
  const double middle = dot(line.along, lens.larger_center);
  range.lo = std::max(range.lo, middle - larger_half);
  range.hi = std::min(range.hi, middle + larger_half);
  return true;
}

// Along the line, a plane means t * slope >= excess. If the whole lens cannot change t * slope by
// more than rounding, the two lines are parallel, and only the excess counts.
bool clip_to_planes(const Lens& lens, const Line& line, Planes planes, bool relaxed, Range& range) {
  const double slack = relaxed ? 0.5 * lens.tolerance : 0.0;
  for (const HalfPlane& plane : planes) {
    const double slope = dot(plane.normal, line.along);
    const double excess = plane.offset - line.offset * dot(plane.normal, line.normal);
    if (std::abs(slope) * lens.radius <= lens.tolerance) {
      if (excess > lens.tolerance) return false;
      continue;
    }
    const double t = (excess - slack) / slope;
    if (slope > 0.0) {
      range.lo = std::max(range.lo, t);
    } else {
      range.hi = std::min(range.hi, t);
    }
  }
  return range.lo <= range.hi;
}

// The 1-D program: it finds the best point of the plane's boundary within the discs and all planes
// before it. Rounding alone never makes it fail. If exact clipping leaves no point (planes through
// one point, touching discs), all bounds are relaxed by half the tolerance before the answer is
// "empty". They are relaxed by half, so that the found point counts as inside for every later
// plane.
bool move_to_boundary(const Lens& lens, Planes before, const HalfPlane& plane, const Goal& goal,
                      Vec2& point) {
  Line line{plane.normal, perpendicular(plane.normal), plane.offset};
  if (is_linear(goal)) {
    const double length = norm(plane.normal);
    if (!(length > 0.0)) return false;
    const double per_length = 1.0 / length;
    const Vec2 normal = per_length * plane.normal;
    line = {normal, perpendicular(normal), per_length * plane.offset};
  }
  Range range;
  bool found =
      clip_to_discs(lens, line, false, range) && clip_to_planes(lens, line, before, false, range);
  if (!found) {
    found =
        clip_to_discs(lens, line, true, range) && clip_to_planes(lens, line, before, true, range);
    if (!found) return false;
    line.offset = std::clamp(line.offset, -lens.radius, lens.radius);
  }

  const double slope = dot(goal.direction, line.along);
  const bool flat = std::abs(slope) * lens.radius <= lens.tolerance;
  double t = dot(goal.preferred, line.along);
  if (!flat) t = slope > 0.0 ? range.hi : range.lo;
  t = std::clamp(t, range.lo, range.hi);
  point = line.offset * line.normal + t * line.along;
  return true;
}

}  // namespace

PlanarSolution start_planar(const Lens& lens, const Goal& goal) noexcept {
  if (is_linear(goal)) return {farthest_along(lens, goal.direction), true};
  const LensPoint start = nearest(lens, goal.preferred);
  return {start.point, start.moved};
}

std::size_t most_violated(Planes planes, Vec2 u, double least) noexcept {
  std::size_t worst = planes.size();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double by = violation(planes[i], u);
    if (by > least) worst = i, least = by;
  }
  return worst;
}

bool contains(Planes planes, const HalfPlane& plane) noexcept {
  return std::any_of(planes.begin(), planes.end(), [&plane](const HalfPlane& each) {
    return each.normal == plane.normal && each.offset == plane.offset;
  });
}

std::size_t solve_planar(const Lens& lens, Planes planes, const Goal& goal,
                         std::span<HalfPlane> taken, PlanarSolution& solution) noexcept {
  for (;;) {
    const std::size_t worst = most_violated(planes, solution.point, lens.tolerance);
    if (worst == planes.size()) return worst;
    const HalfPlane& plane = planes[worst];
    const Planes before = taken.first(solution.taken);
    // if only rounding is left of the largest violation, only rounding is left of all
    if (contains(before, plane)) return planes.size();
    if (!move_to_boundary(lens, before, plane, goal, solution.point)) return worst;
    taken[solution.taken++] = plane;
    solution.moved = true;
  }
}

}  // namespace avo::reference
