// SPDX-License-Identifier: Apache-2.0
// Scenes in which other robots stand where robots have to pass, or close to where they have to
// rest.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// Returns one robot whose goal is inside a ring of 8 robots at their goals, with gaps of 5 cm.
Scene closed_ring(std::uint64_t seed);

/// Returns one robot whose goal is in the middle of 36 robots at their goals, 1.1 m apart.
Scene deep_among(std::uint64_t seed);

/// Returns one robot of 3 m radius that crosses 200 robots of 0.3 m at their goals, on 11 % of the
/// area.
Scene large_among(std::uint64_t seed);

/// Returns n robots around a block of goals that touch; n is a square number. Rows form a square,
/// or every second row is shifted by half a robot, which is the densest packing.
Scene touching_goals(int n, bool hexagonal, std::uint64_t seed);

/// Returns 8 x 8 robots, 1.2 m apart, that exchange places in pairs.
Scene neighbors_swap(std::uint64_t seed);

/// Returns n robots with random starts and goals in a square of which they cover a quarter.
Scene clump(int n, std::uint64_t seed);

}  // namespace avo::safety
