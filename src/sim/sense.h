// SPDX-License-Identifier: Apache-2.0
// Whom the robots of a tile sense.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "neighbors/search.h"

namespace avo::inline sim {

struct World;
struct Worker;

/// m, m/s: who is nearer to one that is no farther out is within the limits of all numbers.
inline constexpr double kFarthestTrusted = 1e11;

/// Whom the robot in that slot looks for.
NeighborQuery sought_by(const World& world, std::size_t slot);

/// Fills the tile's neighbors: all that can matter within the sensing radius. Returns how many
/// robots there was room for.
std::size_t sense(World& world, std::span<const std::uint32_t> slots, Worker& worker);

}  // namespace avo::inline sim
