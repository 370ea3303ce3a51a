// SPDX-License-Identifier: Apache-2.0
// The half-plane of one pair: the scalar instance of the kernels, which the batch of
// half_planes.cpp equals bit for bit, and the rare cases that kernels leave to it.
#include "avo/half_plane.h"

#include "obstacles/contact.h"
#include "obstacles/horn.h"

namespace avo {
namespace {

using Real = scalar::Pack<double>;

struct Found {
  scalar::Plane<Real> plane;
  bool free = false;
};

Found horn(const scalar::Local<Real>& local, const Horizon& horizon) {
  const ResponseTable table = horizon.table();
  scalar::HornPlane<Real> solved = scalar::horn<Look::once>(local, horizon.end(), table);
  if (!solved.settled.bit) solved = scalar::horn<Look::often>(local, horizon.end(), table);
  if (!solved.settled.bit) solved = searched_horn(local, horizon);
  return {solved.plane, solved.free.bit};
}

Found local_half_plane(const scalar::Frame<Real>& frame, const Horizon& horizon) {
  const scalar::Tip<Real> tip = scalar::tip(frame.local, horizon.end());
  if (tip.nearest.bit) return {tip.plane, tip.plane.h.value <= -frame.local.R.value};
  if (!frame.on_collision_course.bit) return horn(frame.local, horizon);
  return {scalar::convex(frame.local, horizon.table())};
}

scalar::Frame<Real> frame_of(const Pair& pair, double reach, const Horizon& horizon) {
  const Vec2 p = pair.position, v = pair.velocity;
  return scalar::frame_of<Real>({p.x, p.y}, {v.x, v.y}, pair.radius, reach, horizon.end());
}

RelativeHalfPlane turned_back(const Found& solved, const scalar::Frame<Real>& frame, double reach) {
  if (solved.free) return {};
  const scalar::Vec<Real> n = frame.turned_back(solved.plane.n);
  const Vec2 normal{n.x.value, n.y.value};
  const double h = solved.plane.h.value;
  if (h > reach) return {PairState::unavoidable, {normal, reach}, h - reach};
  return {PairState::constrained, {normal, h}};
}

}  // namespace

RelativeHalfPlane half_plane(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  const scalar::Frame<Real> frame = frame_of(pair, reach, horizon);
  if (frame.in_contact.bit) return separate(pair, reach, horizon);
  if (frame.too_far.bit) return {};
  return turned_back(local_half_plane(frame, horizon), frame, reach);
}

RelativeHalfPlane searched_half_plane(const Pair& pair, double reach,
                                      const Horizon& horizon) noexcept {
  const scalar::Frame<Real> frame = frame_of(pair, reach, horizon);
  const scalar::HornPlane<Real> solved = searched_horn(frame.local, horizon);
  return turned_back({solved.plane, solved.free.bit}, frame, reach);
}

}  // namespace avo
