// SPDX-License-Identifier: Apache-2.0
// The paper's own half-plane, as a reference for the exact one.
#pragma once
#include "avo/half_plane.h"

namespace avo::test {

/// The half-plane from the paper's boundary of `samples` points a side, joined by chords (§VI-A).
/// It is optimistic, because chords cut through the obstacle.
RelativeHalfPlane sampled_half_plane(const Pair& pair, double reach, const Horizon& horizon,
                                     int samples);

}  // namespace avo::test
