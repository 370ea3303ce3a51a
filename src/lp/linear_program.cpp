// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23): the nearest point of all half-planes and both discs, and the least unsafe one
// (the 3-D linear program of §IV-D) where they leave nothing.
#include "lp/linear_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace avo {
namespace {

// Where plane a is violated no more than plane b: (n_a - n_b) . u >= o_a - o_b. Its violations
// are differences of violations of a and b, so it is left unnormalized.
HalfPlane bisector(const HalfPlane& a, const HalfPlane& b) {
  return {a.normal - b.normal, a.offset - b.offset};
}

double largest_violation(Planes planes, Vec2 u) {
  double largest = 0.0;
  for (const HalfPlane& plane : planes) largest = std::max(largest, violation(plane, u));
  return largest;
}

// The violation to report, of the half-planes as given and the point as returned. It is not 0 even
// where the point's last rounding made it so, among denormal numbers.
double violation_at(Planes given, Vec2 u, double before_rounding) {
  const double largest = largest_violation(given, u);
  return largest > 0.0 ? largest : before_rounding;
}

// CA_A of Eq. (22) is empty, the 3-D program: the smallest s such that some point of the lens and
// of `keep` violates no plane of `give` by more than s. Incremental as well: a plane violated by no
// more than s changes nothing; otherwise it is the worst of those so far, and the new point lies
// farthest along its normal among the points that violate no earlier plane more than this one.
// Equals are settled by the distance to `preferred` in each program, hence in the whole.
// On entry `solution` satisfies `keep` and the planes before give[first], which cannot be added.
std::array<int, 3> least_unsafe(const Lens& lens, Planes keep, Planes give, std::size_t first,
                                Vec2 preferred, std::span<HalfPlane> projected,
                                PlanarSolution& solution) {
  std::array<int, 3> binding{kNoConstraint, kNoConstraint, kNoConstraint};
  double worst = 0.0;
  std::copy(keep.begin(), keep.end(), projected.begin());
  for (std::size_t i = first; i < give.size(); ++i) {
    if (!(violation(give[i], solution.point) > worst + lens.tolerance)) continue;
    for (std::size_t j = 0; j < i; ++j) projected[keep.size() + j] = bisector(give[j], give[i]);
    const Planes planes = projected.first(keep.size() + i);
    PlanarSolution candidate;
    if (solve_planar(lens, planes, {preferred, give[i].normal}, candidate) == planes.size()) {
      solution = candidate;
      binding = {static_cast<int>(planes.size()), candidate.binding[0], candidate.binding[1]};
    }
    worst = violation(give[i], solution.point);
  }
  return binding;
}

// A point as far away as this has the same nearest points as any farther one in that direction.
constexpr double kFarthestPoint = 0x1p400;

Vec2 relative_point(const Lens& lens, Vec2 u) {
  const double size = std::max(std::abs(u.x), std::abs(u.y));
  const double limit = kFarthestPoint / lens.scale;
  if (size > limit) u = (limit / size) * u;
  return lens.scale * u - lens.origin;
}

HalfPlane relative_plane(const Lens& lens, const HalfPlane& plane) {
  return {plane.normal, lens.scale * plane.offset - dot(plane.normal, lens.origin)};
}

// Back into the discs, the smaller one last: rounding may have left it by some ulp of the larger
// one's size, or of the distance between center and origin.
Vec2 absolute_point(const Lens& lens, const Disc& acceleration, const Disc& speed, Vec2 relative) {
  const Disc& smaller = lens.speed_is_larger ? acceleration : speed;
  const Disc& larger = lens.speed_is_larger ? speed : acceleration;
  Vec2 u = (lens.origin + relative) / lens.scale;
  for (const Disc& disc : {larger, smaller}) {
    const Vec2 q = lens.scale * (u - disc.center);
    const double length = norm(q);
    if (length > lens.scale * disc.radius) u = disc.center + disc.radius * (q / length);
  }
  return u;
}

ProgramResult nearest_to_speed_disc(const Lens& lens, const Disc& acceleration, const Disc& speed) {
  const Vec2 towards = lens.speed_is_larger ? lens.larger_center : -lens.larger_center;
  ProgramResult result;
  result.point = acceleration.center + acceleration.radius * (towards / lens.distance);
  result.violation = norm(lens.scale * (result.point - speed.center)) / lens.scale - speed.radius;
  result.state = ProgramState::discs_disjoint;
  result.binding = {kAccelerationDisc, kSpeedDisc, kNoConstraint};
  return result;
}

}  // namespace

ProgramResult nearest_point(std::span<const HalfPlane> hard, std::span<const HalfPlane> soft,
                            const Disc& acceleration, const Disc& speed, Vec2 preferred,
                            std::vector<HalfPlane>& scratch) noexcept {
  const Lens lens = make_lens(acceleration, speed);
  if (lens.empty) return nearest_to_speed_disc(lens, acceleration, speed);

  const std::size_t count = hard.size() + soft.size();
  if (scratch.size() < 2 * count) scratch.resize(2 * count);
  const std::span<HalfPlane> planes{scratch.data(), count};
  const std::span<HalfPlane> projected{scratch.data() + count, count};
  std::size_t next = 0;
  for (const HalfPlane& plane : hard) planes[next++] = relative_plane(lens, plane);
  for (const HalfPlane& plane : soft) planes[next++] = relative_plane(lens, plane);
  const Vec2 target = relative_point(lens, preferred);

  // Eq. (23): all half-planes in one program, the hard ones first
  ProgramResult result;
  PlanarSolution solution;
  const std::span<HalfPlane> keep = planes.first(hard.size());
  const std::span<HalfPlane> give = planes.subspan(hard.size());
  std::size_t failed = solve_planar(lens, planes, {target, {}}, solution);
  if (failed < hard.size()) {
    result.binding = least_unsafe(lens, {}, keep, failed, target, projected, solution);
    const double worst = largest_violation(keep, solution.point);
    if (worst > lens.tolerance) {
      result.point = absolute_point(lens, acceleration, speed, solution.point);
      result.violation = violation_at(hard, result.point, worst / lens.scale);
      result.state = ProgramState::hard_infeasible;
      return result;
    }
    // The hard half-planes leave a set thinner than rounding: widen it by more.
    for (HalfPlane& plane : keep) plane.offset -= 1.5 * lens.tolerance;
    const PlanarSolution inside = solution;
    failed = solve_planar(lens, planes, {target, {}}, solution);
    if (failed < hard.size()) solution = inside, failed = hard.size();
  }
  if (failed == count) {
    const bool moved = solution.binding[0] != kNoConstraint;
    result.point = moved ? absolute_point(lens, acceleration, speed, solution.point) : preferred;
    result.binding = {solution.binding[0], solution.binding[1], kNoConstraint};
    return result;
  }
  result.binding =
      least_unsafe(lens, keep, give, failed - hard.size(), target, projected, solution);
  result.point = absolute_point(lens, acceleration, speed, solution.point);
  const double worst = largest_violation(give, solution.point);
  if (worst > lens.tolerance) {
    result.violation = violation_at(soft, result.point, worst / lens.scale);
    result.state = ProgramState::least_unsafe;
  }
  return result;
}

}  // namespace avo
