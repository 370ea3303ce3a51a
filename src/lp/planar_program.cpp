// SPDX-License-Identifier: Apache-2.0
// Eq. (23) in the plane: one half-plane after the other, one line at a time.
#include "lp/planar_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace avo {
namespace {

// The boundary of a half-plane: offset * normal + t * along, |normal| = |along| = 1.
struct Line {
  Vec2 normal;
  Vec2 along;
  double offset = 0.0;
};

// What is left of a line, lo <= t <= hi, and which constraint ends it.
struct Range {
  double lo = 0.0;
  double hi = 0.0;
  int at_lo = kNoConstraint;
  int at_hi = kNoConstraint;
};

int smaller_disc(const Lens& lens) {
  return lens.speed_is_larger ? kAccelerationDisc : kSpeedDisc;
}
int larger_disc(const Lens& lens) {
  return lens.speed_is_larger ? kSpeedDisc : kAccelerationDisc;
}

// Both ends in factors (r - o)(r + o): r² - o² would lose half the digits of a short chord.
bool clip_to_discs(const Lens& lens, const Line& line, bool relaxed, Range& range) {
  const double slack = relaxed ? 0.5 * lens.tolerance : 0.0;
  const double gap = lens.radius - std::abs(line.offset);
  if (gap < -slack) return false;
  const double half =
      slack + (gap > 0.0 ? std::sqrt(gap * (lens.radius + std::abs(line.offset))) : 0.0);
  range = {-half, half, smaller_disc(lens), smaller_disc(lens)};
  if (!lens.two_arcs) return true;

  const double larger_slack = relaxed ? 0.5 * lens.larger_tolerance : 0.0;
  const double offset = std::abs(line.offset - dot(line.normal, lens.larger_center));
  const double larger_gap = lens.larger_radius - offset;
  if (larger_gap < -larger_slack) return false;
  const double larger_half =
      larger_slack +
      (larger_gap > 0.0 ? std::sqrt(larger_gap * (lens.larger_radius + offset)) : 0.0);
  const double middle = dot(line.along, lens.larger_center);
  if (middle - larger_half > range.lo) {
    range.lo = middle - larger_half;
    range.at_lo = larger_disc(lens);
  }
  if (middle + larger_half < range.hi) {
    range.hi = middle + larger_half;
    range.at_hi = larger_disc(lens);
  }
  return true;
}

// Along the line, plane j reads t * slope >= excess. Where the whole lens cannot change t * slope
// by more than rounding, the two lines are parallel and only the excess counts.
bool clip_to_planes(const Lens& lens, const Line& line, Planes planes, bool relaxed, Range& range) {
  const double slack = relaxed ? 0.5 * lens.tolerance : 0.0;
  for (std::size_t j = 0; j < planes.size(); ++j) {
    const double slope = dot(planes[j].normal, line.along);
    const double excess = planes[j].offset - line.offset * dot(planes[j].normal, line.normal);
    if (std::abs(slope) * lens.radius <= lens.tolerance) {
      if (excess > lens.tolerance) return false;
      continue;
    }
    const double t = (excess - slack) / slope;
    if (slope > 0.0) {
      if (t > range.lo) range.lo = t, range.at_lo = static_cast<int>(j);
    } else {
      if (t < range.hi) range.hi = t, range.at_hi = static_cast<int>(j);
    }
  }
  return range.lo <= range.hi;
}

// The 1-D program: the best point of the plane's boundary within the discs and all planes before
// it. Nothing is given up to rounding: where exact clipping leaves nothing (planes through one
// point, touching discs), all bounds are relaxed by half the tolerance before the answer is
// "empty"; by half, so that the point found counts as inside for every plane to come.
bool move_to_boundary(const Lens& lens, Planes before, const HalfPlane& plane, const Goal& goal,
                      PlanarSolution& solution) {
  const double length = norm(plane.normal);
  if (!(length > 0.0)) return false;
  const Vec2 normal = plane.normal / length;
  Line line{normal, perpendicular(normal), plane.offset / length};
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
  solution.binding = {static_cast<int>(before.size()), kNoConstraint};
  if (t <= range.lo) t = range.lo, solution.binding[1] = range.at_lo;
  if (t >= range.hi) t = range.hi, solution.binding[1] = range.at_hi;
  solution.point = line.offset * line.normal + t * line.along;
  return true;
}

PlanarSolution start(const Lens& lens, const Goal& goal) {
  const bool linear = goal.direction.x != 0.0 || goal.direction.y != 0.0;
  const LensPoint p = linear ? farthest_along(lens, goal.direction) : nearest(lens, goal.preferred);
  switch (p.arc) {
    case Arc::none:
      return {p.point};
    case Arc::smaller:
      return {p.point, {smaller_disc(lens), kNoConstraint}};
    case Arc::larger:
      return {p.point, {larger_disc(lens), kNoConstraint}};
    case Arc::corner:
      break;
  }
  return {p.point, {smaller_disc(lens), larger_disc(lens)}};
}

}  // namespace

std::size_t solve_planar(const Lens& lens, Planes planes, const Goal& goal,
                         PlanarSolution& solution) noexcept {
  solution = start(lens, goal);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!(violation(planes[i], solution.point) > lens.tolerance)) continue;
    if (!move_to_boundary(lens, planes.first(i), planes[i], goal, solution)) return i;
  }
  return planes.size();
}

}  // namespace avo
