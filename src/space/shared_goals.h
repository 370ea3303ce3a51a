// SPDX-License-Identifier: Apache-2.0
// Goals that leave no room for all robots that have them (docs/arrival.md, rule 4).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/robot.h"

namespace avo::space {

/// What a robot has in common with another one, where both may not be in one place.
enum class SpaceShares : std::uint8_t {
  nothing,
  room,  ///< their goals are so close that they cannot both be there
  goal,  ///< the same goal, bit for bit
};

/// What each robot shares, by its number; empty where none shares anything. goals: m.
std::vector<SpaceShares> shared_goals(std::span<const Robot> robots, std::span<const Vec3> goals);

}  // namespace avo::space
