// SPDX-License-Identifier: Apache-2.0
// Scenes of 50 robots that have to share passages between walls. All robots start at rest.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// Returns two rooms of 16 x 16 m with a door of this width (m) between them, and 25 robots in each
/// direction.
Scene narrow_doorway(double width, std::uint64_t seed);

/// Returns two rooms of 14 x 16 m joined by a corridor of 10 m and this width (m), and 25 robots in
/// each direction.
Scene narrow_corridor(double width, std::uint64_t seed);

/// Returns ten rooms of 6 x 6 m on both sides of a corridor of 3 m, each with a door of this width
/// (m). Robots start at random places and go to random rooms; no goal is near the corridor.
Scene office(double door, std::uint64_t seed);

/// Returns 10 x 10 cells with passages of 3 m: a random spanning tree, and a tenth of its walls
/// removed.
Scene maze(std::uint64_t seed);

}  // namespace avo::safety
