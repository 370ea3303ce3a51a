// SPDX-License-Identifier: Apache-2.0
// Scenes in which others stand where robots have to pass, or close to where they have to rest.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// One robot, its goal inside a ring of 8 that are at their goals, with gaps of 5 cm.
Scene closed_ring(std::uint64_t seed);

/// One robot, its goal in the middle of 36 that are at their goals, 1.1 m apart.
Scene deep_among(std::uint64_t seed);

/// One robot of 3 m radius across 200 of 0.3 m that are at their goals, on 11 % of the area.
Scene large_among(std::uint64_t seed);

/// n robots from around a block of goals that touch, n a square number; rows in a square or, in
/// rows by turns half a robot further, as dense as can be.
Scene touching_goals(int n, bool hexagonal, std::uint64_t seed);

/// 8 x 8 robots, 1.2 m apart; two by two they exchange places.
Scene neighbors_swap(std::uint64_t seed);

/// n robots from and to anywhere in a square of which they cover a quarter.
Scene clump(int n, std::uint64_t seed);

}  // namespace avo::safety
