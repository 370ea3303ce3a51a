// SPDX-License-Identifier: Apache-2.0
// Pairs that overlap already: outside the paper, whose guarantee starts from a free pair.
#pragma once
#include "avo/half_plane.h"

namespace avo {

/// Requires |p| < r. The line n = p/|p| over the shortest window in [Δt, τ] at whose end the pair
/// can be apart, see contact_kernel.h. If even τ is too short, h = reach, and excess says by how
/// much more. Equal centers separate along the relative velocity; at rest they have no direction
/// (coincident).
RelativeHalfPlane separate(const Pair& pair, double reach, const Horizon& horizon) noexcept;

}  // namespace avo
