// SPDX-License-Identifier: Apache-2.0
// The half-plane of one pair: the scalar instance of the kernels, and the rare cases that the
// kernels do not handle. The batch of half_planes.cpp equals it bit for bit.
#include "avo/half_plane.h"

#include <algorithm>

#include "obstacles/half_planes.h"
#include "obstacles/horn.h"

namespace avo {
namespace {

using Real = scalar::Pack<double>;

// The line that separates an overlapping pair: outside the paper, which guarantees safety from a
// free pair on. n = p/|p| over the shortest window in [Δt, τ] after which the pair can be apart,
// see contact_kernel.h. If even τ is too short, h = reach, and excess says by how much more. Equal
// centers separate along the relative velocity; at rest they have no direction (coincident).
RelativeHalfPlane separate(const Pair& pair, double reach, const Horizon& horizon) {
  const double d = norm(pair.position);
  const bool equal_centers = !(d > kTiniest);
  const Vec2 along = equal_centers ? pair.velocity : pair.position;
  const double length = norm(along);
  if (!(length > kTiniest)) return {PairState::coincident, {}};
  const double per_length = 1.0 / length;
  const double depth = pair.radius - (equal_centers ? 0.0 : d);
  const double h =
      scalar::separating<Real>(depth, dot(along, pair.velocity) * per_length, reach, horizon).value;
  return {
      PairState::overlapping, {per_length * along, std::min(h, reach)}, std::max(0.0, h - reach)};
}

using Solved = scalar::HornPlane<Real>;

Solved solve_horn(const scalar::Local<Real>& local, const Horizon& horizon) {
  const ResponseTable table = horizon.table();
  Solved solved = scalar::horn<Crossed::once>(local, horizon.end(), table);
  if (!solved.settled.bit) solved = scalar::horn<Crossed::often>(local, horizon.end(), table);
  return solved.settled.bit ? solved : searched_horn(local, horizon);
}

Solved local_half_plane(const scalar::LocalFrame<Real>& frame, const Horizon& horizon) {
  const scalar::Tip<Real> tip = scalar::tip(frame.local, horizon.end());
  if (tip.nearest.bit) return {tip.plane, {true}, tip.plane.h <= -frame.local.R};
  if (!frame.on_collision_course.bit) return solve_horn(frame.local, horizon);
  return {scalar::convex(frame.local, horizon.table()), {true}, {false}};
}

scalar::LocalFrame<Real> frame_of(const Pair& pair, double reach, const Horizon& horizon) {
  const Vec2 p = pair.position, v = pair.velocity;
  return scalar::frame_of<Real>({p.x, p.y}, {v.x, v.y}, pair.radius, reach, horizon.end());
}

RelativeHalfPlane turned_back(const Solved& solved, const scalar::LocalFrame<Real>& frame,
                              double reach) {
  if (solved.free.bit) return {};
  const Vec2 normal = plain(frame.turned_back(solved.plane.n));
  const double h = solved.plane.h.value;
  if (h > reach) return {PairState::unavoidable, {normal, reach}, h - reach};
  return {PairState::constrained, {normal, h}};
}

}  // namespace

RelativeHalfPlane half_plane(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  const scalar::LocalFrame<Real> frame = frame_of(pair, reach, horizon);
  if (frame.in_contact.bit) return separate(pair, reach, horizon);
  if (frame.too_far.bit) return {};
  return turned_back(local_half_plane(frame, horizon), frame, reach);
}

}  // namespace avo

namespace avo::inline obstacles {

RelativeHalfPlane parting_half_plane(double radius, Vec2 direction, double reach,
                                     const Horizon& horizon) noexcept {
  const double h = scalar::separating<Real>(radius, 0.0, reach, horizon).value;
  return {PairState::overlapping,
          {direction / norm(direction), std::min(h, reach)},
          std::max(0.0, h - reach)};
}

RelativeHalfPlane searched_half_plane(const Pair& pair, double reach,
                                      const Horizon& horizon) noexcept {
  const scalar::LocalFrame<Real> frame = frame_of(pair, reach, horizon);
  return turned_back(searched_horn(frame.local, horizon), frame, reach);
}

}  // namespace avo::inline obstacles
