// SPDX-License-Identifier: Apache-2.0
// Pairs that overlap already: outside the paper, which guarantees safety from a free pair on. Lemma
// 10 of docs/half_plane.md.
#ifndef AVO_OBSTACLES_CONTACT_KERNEL_H
#define AVO_OBSTACLES_CONTACT_KERNEL_H

#include "avo/horizon.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// [m/s] The demand on n . w for a pair `depth` > 0 deep, n . v = along, over the shortest window T
/// in [Δt, τ] after which the pair can be apart. A window needs d(T) = (depth - T along)/g(T),
/// which falls as long as it is positive. The window is Δt if d(Δt) is within reach R, and else the
/// window with d = R. A result above R means that even τ is too short.
template <typename Real>
AVO_KERNEL Real separating(Real depth, Real along, Real R, const Horizon& horizon) {
  const auto demand = [&](const ResponseAt& window) {
    return (depth - Real(window.time) * along) * Real(1.0 / window.gain);
  };
  return min(demand(horizon.step()), max(demand(horizon.end()), R));
}

AVO_END_KERNELS

#endif  // once per pass
