// SPDX-License-Identifier: Apache-2.0
// The neighbors that the robots of a tile sense.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace avo::inline sim {

struct World;
struct Worker;

/// m, m/s: a robot no farther from the origin, with neighbors no farther from it, keeps the limits
/// of all numbers.
inline constexpr double kFarthestTrusted = 1e11;

/// Gives the tile the neighbors of the robot in that slot alone. They are all that the robot senses
/// within the sensing radius, also those that its decision does not need. look_at_present() comes
/// first.
void sense_everyone(const World& world, std::uint32_t slot, Worker& worker);

/// Fills the tile's neighbors: all that can matter within the sensing radius. Returns the number of
/// robots for which there was room.
std::size_t sense(World& world, std::span<const std::uint32_t> slots, Worker& worker);

}  // namespace avo::inline sim
