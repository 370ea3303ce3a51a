// SPDX-License-Identifier: Apache-2.0
// Scenes in which moving robots are near walls for a long time: unequal robots that get new goals
// again and again. Motion is held or exponential, in turns.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// Returns 30 robots among random segments and discs, one for every 4 m².
Scene random_walls(double robot_steps, std::uint64_t seed);

/// Returns the same, but every second robot is a car. Motion is held.
Scene walls_and_cars(double robot_steps, std::uint64_t seed);

/// Returns 20 robots among random segments, which 8 obstacles cross. It lasts one minute.
Scene walls_and_movers(std::uint64_t seed);

/// Returns 30 robots that are sent straight into the corners of a star, of 10° to 150°, all at
/// about the same time.
Scene wall_corners(double robot_steps, std::uint64_t seed);

/// Returns 30 robots that are sent from both sides through gaps that are 1e-6 m wider than the
/// robots. The gaps are between the ends of walls, and between parallel walls. Robots navigate on
/// routes around walls, or straight ahead, in turns.
Scene wall_gaps(double robot_steps, std::uint64_t seed);

}  // namespace avo::safety
