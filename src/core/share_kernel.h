// SPDX-License-Identifier: Apache-2.0
// room_share() of avo/half_plane.h, as many pairs at once as Pack has lanes.
#ifndef AVO_CORE_SHARE_KERNEL_H
#define AVO_CORE_SHARE_KERNEL_H

#include "avo/half_plane.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

template <typename Real>
AVO_KERNEL Real room_share(Real a_A, Real a_B, Real priority_A, Real priority_B) {
  const auto alike = (priority_A <= priority_B) & (priority_A >= priority_B);
  const Real a = select(alike, a_A, a_A * priority_A), b = select(alike, a_B, a_B * priority_B);
  const Real share = a / (a + b);
  return select(alike, share, min(max(share, Real(kLeastShare)), Real(1.0 - kLeastShare)));
}

AVO_END_KERNELS

#endif  // once per pass
