// SPDX-License-Identifier: Apache-2.0
// How dense a crowd is.
#pragma once
#include "avo/simulation.h"

namespace avo::safety {

/// The densest packing of equal discs covers this part of the plane, π/√12.
inline constexpr double kDensestPacking = 0.9068996821171089;

/// Largest part of a disc about the robots' centroid that robots cover, parts of robots included,
/// over all such discs that reach a quarter of the robots or more.
double densest_disc(const FleetView& fleet);

}  // namespace avo::safety
