// SPDX-License-Identifier: Apache-2.0
// What a neighbor can refuse on all intervals at once: docs/certificate/left_out.md.
#ifndef AVO_CERTIFICATE_CLEARANCE_KERNEL_H
#define AVO_CERTIFICATE_CLEARANCE_KERNEL_H

#include <limits>

#include "certificate/pair_kernel.h"

AVO_BEGIN_KERNELS

/// What B can refuse: B refuses no path that deviates from A's braking path by less than the gap
/// (docs/certificate/left_out.md).
template <typename Real>
struct PackClearance {
  Real gap;      // m, A's share of the gap that joint braking leaves; -∞ where it is not known
  Real against;  // in [0, 1], the largest part of any of the normals against A's direction
};

template <typename Real, int D>
AVO_KERNEL PackClearance<Real> clearance_of(const PackRobot<Real, D>& self,
                                            const PackPair<Real, D>& pair,
                                            const PackRobot<Real, D>& other, const StepLaw& law) {
  const Real zero(0.0), one(1.0), d = pair.distance, length_A = self.braking.length;
  const Vec<Real, D> d_A = self.braking.direction, d_B = pair.b.direction;
  const auto apart = d > zero;
  // along p, whenever each of them stops
  const Real towards =
      min(zero, length_A * dot(pair.p, d_A)) - max(zero, pair.b.length * dot(pair.p, d_B));
  const Real alone = d + towards / select(apart, d, one);
  // the relative velocity of robots with equal braking never grows
  const Real steps = one + max(self.braking.profile.full_steps, pair.b.profile.full_steps);
  const Real drift = Real(law.time_step) * steps * norm(self.velocity - other.velocity);
  const auto brake_alike =
      (other.max_braking <= self.max_braking) & (other.max_braking >= self.max_braking);
  const Real together = select(brake_alike, d - drift, alone);
  // by equal braking both keep within `off_line` of the line from p to where both rest
  const Vec<Real, D> motion = length_A * d_A - pair.b.length * d_B;
  const Real squared = dot(motion, motion), lengths = length_A + pair.b.length;
  const Real part =
      min(max(-dot(pair.p, motion), zero) / select(squared > zero, squared, one), one);
  const Real off_line = abs(length_A - pair.b.length) + Real(0x1p-40) * (d + lengths);
  const Real beside = norm(pair.p + part * motion) - off_line;
  const Real nearest = max(max(alone, together), select(brake_alike, beside, alone));
  const Real passes = pair.b.length * max(zero, dot(d_A, d_B));
  const Real shift = select(brake_alike, min(passes, drift), passes);
  const auto clear = apart & (nearest > zero);
  // with the part that rounding of p . d may hide
  const Real towards_B = max(zero, shift - dot(pair.p, d_A)) + Real(0x1p-40) * d;
  const Real against = towards_B / select(clear, nearest, one);
  const Real unknown(-std::numeric_limits<double>::infinity());
  return {select(clear, pair.share * (nearest - pair.inflated), unknown), min(against, one)};
}

AVO_END_KERNELS

#endif  // once per pass
