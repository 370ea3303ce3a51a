// SPDX-License-Identifier: Apache-2.0
// Bodies that pass so far away that their half-spaces, or their weight as traffic, are known
// without a search (docs/space.md, "Cost").
#ifndef AVO_SPACE_PASSING_KERNEL_H
#define AVO_SPACE_PASSING_KERNEL_H

#include "space/seen_kernel.h"

AVO_BEGIN_KERNELS

// The part of squared lengths that is more than rounding makes of them.
constexpr double kFarSlack = 0x1p-40;

/// Returns whether the relative course surely stays farther away than a distance, where both keep
/// their velocities for ever. It asks for squares, without roots and divisions.
template <typename Real>
AVO_KERNEL auto stays_beyond(const PackSeen<Real>& seen, Real distance_squared) {
  const Real least = distance_squared + Real(kFarSlack) * seen.squared;
  const Real approach = -dot(seen.p, seen.v), speed_squared = dot(seen.v, seen.v);
  return ((approach <= Real(0.0)) & (seen.squared > least)) |
         (seen.squared * speed_squared - square(approach) > speed_squared * least);
}

/// Returns whether the half-space surely contains v_A and all velocities that differ from v_A by no
/// more than `change`, m/s. With m, the point of the relative course within the horizon that is
/// nearest to contact, no disc reaches farther along m than that of the end (docs/space.md,
/// "Cost").
template <typename Real>
AVO_KERNEL auto is_passed_by(const PackLook<Real>& a, const PackSeen<Real>& seen,
                             const PackBody<Real>& body, Real change) {
  const Real beyond(1e-6);  // m/s, more than half-planes err
  const Real least =
      square(Real(kFarther) * body.contact + body.per_share * a.gain * (change + beyond));
  const Real speed_squared = dot(seen.v, seen.v);
  const Vec<Real, 3> end = seen.p + a.end_time * seen.v;
  const auto approaches = -dot(seen.p, seen.v) >= Real(kFarther) * a.end_time * speed_squared;
  const Real lengths = seen.squared + square(a.end_time) * speed_squared;
  return stays_beyond(seen, least) |
         (approaches & (dot(end, end) > least + Real(kFarSlack) * lengths));
}

/// What a half-space surely contains. It is known where the half-space touches the obstacle at the
/// end of the horizon (docs/half_plane.md, lemma 2).
template <typename Real>
struct PackContained {
  decltype(Real() < Real()) everything;  // that A can choose
  decltype(Real() < Real()) velocity;    // v_A + change
};
template <typename Real>
AVO_KERNEL PackContained<Real> contained(const PackLook<Real>& a, const PackSeen<Real>& seen,
                                         const PackBody<Real>& body, const Vec<Real, 3>& change) {
  const Real rounding(kFarther), beyond(1e-9);  // m/s, more than what programs tolerate
  const Vec<Real, 3> x = seen.p + a.end_time * seen.v, y = seen.p + a.end_lag * seen.v;
  const Real length = norm(x), least = rounding * body.contact * length;
  const auto touches_at_end = (seen.squared > square(rounding * body.contact)) &
                              (dot(seen.p, x) > least) & (dot(x, y) > least);
  const Real lift = body.share * (body.contact - length);  // [α h g] m
  const auto keeps_change = lift < -(a.gain * (rounding * a.change + beyond));
  const auto keeps_speed = dot(x, a.velocity) * a.gain + lift * length <
                           -(length * a.gain * (rounding * a.speed + beyond));
  const auto keeps = lift * length < a.gain * (dot(x, change) - beyond * length);
  return {touches_at_end & (keeps_change | keeps_speed), touches_at_end & keeps};
}

AVO_END_KERNELS

#endif  // once per pass
