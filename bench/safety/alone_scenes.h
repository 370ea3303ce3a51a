// SPDX-License-Identifier: Apache-2.0
// One robot among moving obstacles that behave as they are known, and a few robots among such
// obstacles. Time steps are 0.02 to 0.25 s in turns; radii and limits of the robot are random.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// Returns a scene in which 1 to 10 moving obstacles (in turns) cross the robot's line of 20 m.
/// They are slower than the robot or faster, in turns.
Scene alone_crossing(std::uint64_t seed);

/// Returns a scene in which the robot rests at its goal, and 1 to 10 moving obstacles (in turns)
/// pass over it.
Scene alone_at_goal(std::uint64_t seed);

/// Returns a scene in which the robot crosses a road of 1 to 3 lanes, with traffic in both
/// directions.
Scene alone_over_road(std::uint64_t seed);

/// Returns a scene in which the robot, in motion, first sees one moving obstacle 0.7 to 3 s before
/// contact. Every such obstacle can be evaded: see is_evadable().
Scene alone_surprised(std::uint64_t seed);

/// Returns a scene in which 1 to 4 moving obstacles cross the robot's line of 20 m to and fro, on
/// paths that it knows.
Scene alone_among_paths(std::uint64_t seed);

/// Returns a scene in which eight robots exchange places on a circle of 10 m that six moving
/// obstacles cross.
Scene eight_among_movers(std::uint64_t seed);

}  // namespace avo::safety
