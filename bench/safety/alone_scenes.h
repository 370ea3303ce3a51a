// SPDX-License-Identifier: Apache-2.0
// One robot among movers that keep to what is known of them, and a few robots among such movers.
// Time steps are 0.02 to 0.25 s by turns; radii and limits of the robot are drawn.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// 1 to 10 movers by turns cross its way of 20 m, slower than the robot or faster, by turns.
Scene alone_crossing(std::uint64_t seed);

/// It rests at its goal, and 1 to 10 movers by turns pass over it.
Scene alone_at_goal(std::uint64_t seed);

/// It crosses a road of 1 to 3 lanes, with traffic in both directions.
Scene alone_over_road(std::uint64_t seed);

/// It comes to see one mover 0.7 to 3 s before contact, in motion. All can be evaded: see
/// is_evadable().
Scene alone_surprised(std::uint64_t seed);

/// 1 to 4 movers go to and fro across its way of 20 m, on paths that it knows.
Scene alone_among_paths(std::uint64_t seed);

/// Eight robots exchange places on a circle of 10 m that six movers cross.
Scene eight_among_movers(std::uint64_t seed);

}  // namespace avo::safety
