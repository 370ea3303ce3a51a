// SPDX-License-Identifier: Apache-2.0
// The general search for the half-plane in the horn case, and where half_planes() asks for it.
#pragma once
#include "avo/half_plane.h"
#include "obstacles/half_planes_kernel.h"

namespace avo {

/// The horn case: v does not lead into a collision (p . v >= 0 or a miss distance >= r, and
/// d >= r), and the disc of τ alone is not nearest. Settled always.
scalar::HornPlane<scalar::Pack<double>> searched_horn(
    const scalar::Local<scalar::Pack<double>>& pair, const Horizon& horizon);

/// half_plane() of a pair in the horn case that no kernel settles.
RelativeHalfPlane searched_half_plane(const Pair& pair, double reach,
                                      const Horizon& horizon) noexcept;

}  // namespace avo
