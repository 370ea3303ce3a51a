// SPDX-License-Identifier: Apache-2.0
// The scenes of 50 robots that have to share passages between walls. All start at rest.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// Two rooms of 16 x 16 m with a door of this width (m) between them, 25 robots each way.
Scene narrow_doorway(double width, std::uint64_t seed);

/// Two rooms of 14 x 16 m joined by a corridor of 10 m and this width (m), 25 robots each way.
Scene narrow_corridor(double width, std::uint64_t seed);

/// Ten rooms of 6 x 6 m on both sides of a corridor of 3 m, each with a door of this width (m).
/// Robots start anywhere and go to any room; no goal is near the corridor.
Scene office(double door, std::uint64_t seed);

/// 10 x 10 cells with ways of 3 m: a random spanning tree, and a tenth of its walls left out.
Scene maze(std::uint64_t seed);

}  // namespace avo::safety
