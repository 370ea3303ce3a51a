// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23): the nearest point of all half-planes and both discs. If they leave no point, it
// is the least unsafe point (the 3-D linear program of §IV-D).
#include "support/program/linear_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "support/program/lens.h"
#include "support/program/planar_program.h"

namespace avo::reference {
namespace {

// Returns the half-plane where plane a is violated no more than plane b: (n_a - n_b) . u >= o_a -
// o_b. Its violations are differences of violations of a and b, so it is not normalized.
HalfPlane bisector(const HalfPlane& a, const HalfPlane& b) {
  return {a.normal - b.normal, a.offset - b.offset};
}

double largest_violation(Planes planes, Vec2 u) {
  double largest = 0.0;
  for (const HalfPlane& plane : planes) largest = std::max(largest, violation(plane, u));
  return largest;
}

// Returns the violation to report, of the given half-planes and the returned point. It is not 0
// even if the point's last rounding made it so, among denormal numbers.
double violation_at(Planes given, Vec2 u, double before_rounding) {
  const double largest = largest_violation(given, u);
  return largest > 0.0 ? largest : before_rounding;
}

// Scratch memory; each part has room for all half-planes.
struct Room {
  std::span<HalfPlane> planes;  // relative, with the hard ones first
  std::span<HalfPlane> taken;
  std::span<HalfPlane> projected, projected_taken;  // of least_unsafe
};

Room room_for(std::size_t count, std::vector<HalfPlane>& scratch) {
  if (scratch.size() < 4 * count) scratch.resize(4 * count);
  HalfPlane* const first = scratch.data();
  return {{first, count},
          {first + count, count},
          {first + 2 * count, count},
          {first + 3 * count, count}};
}

// CA_A of Eq. (22) is empty, so this is the 3-D program. It finds the smallest s such that some
// point of the lens and of `keep` violates no plane of `give` by more than s. It is incremental as
// well: of the planes violated by more than s, the one violated most is taken next. That plane is
// then the worst of the taken planes. The new point lies farthest along its normal among the points
// that violate no taken plane more than this one. Ties are broken by the distance to `preferred` in
// each program, hence in the whole. On entry, `solution` satisfies `keep` and the planes of `give`
// in taken[from .. solution.taken), to which give[next] cannot be added.
void least_unsafe(const Lens& lens, Planes keep, Planes give, std::size_t next, Vec2 preferred,
                  const Room& room, std::size_t from, PlanarSolution& solution) {
  std::copy(keep.begin(), keep.end(), room.projected.begin());
  while (next < give.size()) {
    const HalfPlane& worst = give[next];
    std::size_t count = keep.size();
    for (std::size_t j = from; j < solution.taken; ++j) {
      room.projected[count++] = bisector(room.taken[j], worst);
    }
    const Goal goal{preferred, worst.normal};
    PlanarSolution candidate = start_planar(lens, goal);
    if (solve_planar(lens, room.projected.first(count), goal, room.projected_taken, candidate) ==
        count) {
      solution.point = candidate.point;
    }
    room.taken[solution.taken++] = worst;
    next = most_violated(give, solution.point, violation(worst, solution.point) + lens.tolerance);
    if (next < give.size() && contains(room.taken.first(solution.taken), give[next])) break;
  }
}

// A point at this distance has the same nearest points as any farther point in that direction.
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

// Moves the point back into the discs, the smaller one last. Rounding may have moved it out by some
// ulp of the size of the larger one, or of the distance between center and origin.
Vec2 absolute_point(const Lens& lens, const Disc& acceleration, const Disc& speed, Vec2 relative) {
  const Disc& smaller = lens.speed_is_larger ? acceleration : speed;
  const Disc& larger = lens.speed_is_larger ? speed : acceleration;
  Vec2 u = (lens.origin + relative) / lens.scale;
  for (const Disc& disc : {larger, smaller}) {
    const Vec2 q = lens.scale * (u - disc.center);
    const double radius = lens.scale * disc.radius;
    if (norm_squared(q) > radius * radius) u = disc.center + (disc.radius / norm(q)) * q;
  }
  return u;
}

ProgramResult nearest_to_speed_disc(const Lens& lens, const Disc& acceleration, const Disc& speed) {
  const Vec2 towards = lens.speed_is_larger ? lens.larger_center : -lens.larger_center;
  ProgramResult result;
  result.point = acceleration.center + acceleration.radius * (towards / lens.distance);
  result.violation = norm(lens.scale * (result.point - speed.center)) / lens.scale - speed.radius;
  result.state = ProgramState::discs_disjoint;
  return result;
}

// Returns the largest violation of the hard half-planes; if it is only a rounding error, all of
// them are in force.
double solve_hard(const Lens& lens, std::span<HalfPlane> keep, const Goal& goal, const Room& room,
                  PlanarSolution& solution) {
  if (keep.empty()) return 0.0;
  const std::size_t failed = solve_planar(lens, keep, goal, room.taken, solution);
  if (failed < keep.size()) {
    least_unsafe(lens, {}, keep, failed, goal.preferred, room, 0, solution);
    solution.moved = true;
    const double worst = largest_violation(keep, solution.point);
    if (worst > lens.tolerance) return worst;
    // The half-planes leave a set thinner than rounding: widen it by more.
    for (HalfPlane& plane : keep) plane.offset -= 1.5 * lens.tolerance;
    PlanarSolution wider = start_planar(lens, goal);
    if (solve_planar(lens, keep, goal, room.taken, wider) == keep.size()) solution = wider;
  }
  std::copy(keep.begin(), keep.end(), room.taken.begin());
  solution.taken = keep.size();
  return 0.0;
}

}  // namespace

ProgramResult nearest_point(std::span<const HalfPlane> hard, std::span<const HalfPlane> soft,
                            const Disc& acceleration, const Disc& speed, Vec2 preferred,
                            std::vector<HalfPlane>& scratch) {
  const Lens lens = make_lens(acceleration, speed);
  if (lens.empty) return nearest_to_speed_disc(lens, acceleration, speed);

  const Room room = room_for(hard.size() + soft.size(), scratch);
  std::size_t next = 0;
  for (const HalfPlane& plane : hard) room.planes[next++] = relative_plane(lens, plane);
  for (const HalfPlane& plane : soft) room.planes[next++] = relative_plane(lens, plane);
  const std::span<HalfPlane> keep = room.planes.first(hard.size());
  const std::span<HalfPlane> give = room.planes.subspan(hard.size());
  const Goal goal{relative_point(lens, preferred), {}};

  // Eq. (23), with the hard half-planes first
  ProgramResult result;
  PlanarSolution solution = start_planar(lens, goal);
  if (const double worst = solve_hard(lens, keep, goal, room, solution); worst > lens.tolerance) {
    result.point = absolute_point(lens, acceleration, speed, solution.point);
    result.violation = violation_at(hard, result.point, worst / lens.scale);
    result.state = ProgramState::hard_infeasible;
    return result;
  }
  const std::size_t failed = solve_planar(lens, give, goal, room.taken, solution);
  if (failed == give.size()) {
    result.point =
        solution.moved ? absolute_point(lens, acceleration, speed, solution.point) : preferred;
    return result;
  }
  least_unsafe(lens, keep, give, failed, goal.preferred, room, keep.size(), solution);
  result.point = absolute_point(lens, acceleration, speed, solution.point);
  const double worst = largest_violation(give, solution.point);
  if (worst > lens.tolerance) {
    result.violation = violation_at(soft, result.point, worst / lens.scale);
    result.state = ProgramState::least_unsafe;
  }
  return result;
}

}  // namespace avo::reference
