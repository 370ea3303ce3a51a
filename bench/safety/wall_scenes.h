// SPDX-License-Identifier: Apache-2.0
// The scenes in which moving robots are held to walls for long: unequal ones that get new goals
// again and again. With held and with exponential motion by turns.
#pragma once
#include <cstdint>

#include "scenes.h"

namespace avo::safety {

/// 30 robots among random segments and discs, one for every 4 m².
Scene random_walls(double robot_steps, std::uint64_t seed);

/// The same, every other one a car. Held motion.
Scene walls_and_cars(double robot_steps, std::uint64_t seed);

/// 20 robots among random segments that 8 obstacles cross. One minute.
Scene walls_and_movers(std::uint64_t seed);

/// 30 robots sent straight into the corners of a star, of 10° to 150°, all about at once.
Scene wall_corners(double robot_steps, std::uint64_t seed);

/// 30 robots sent from both sides through gaps that are 1e-6 m wider than they are: between the
/// ends of walls, and between parallel walls. With ways around walls and straight ahead by turns.
Scene wall_gaps(double robot_steps, std::uint64_t seed);

}  // namespace avo::safety
