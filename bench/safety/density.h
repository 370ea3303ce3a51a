// SPDX-License-Identifier: Apache-2.0
// The density of a crowd.
#pragma once
#include "avo/simulation.h"

namespace avo::safety {

/// The part of the plane that the densest packing of equal discs covers, π/√12.
inline constexpr double kDensestPacking = 0.9068996821171089;

/// Returns the largest part of a disc about the robots' centroid that robots cover, parts of robots
/// included. It is the maximum over all such discs that reach a quarter of the robots or more.
double densest_disc(const FleetView& fleet);

}  // namespace avo::safety
