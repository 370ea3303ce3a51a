// SPDX-License-Identifier: Apache-2.0
// Goals on which other robots rest. A robot whose goal leaves no room may come to rest on the goal
// of a robot that shared nothing. That robot has no room either, as long as the first one rests
// there (docs/arrival.md, rule 4).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "avo/vec.h"
#include "spatial/point_grid.h"

namespace avo::inline sim {

struct World;

/// It depends on the state between two steps alone, so that a saved state does not list it.
struct TakenGoals {
  PointGrid goals;                           // of robots that share nothing
  std::vector<std::uint32_t> ranks;          // of these robots, by the index of the goal
  double largest_radius = 0.0;               // m, of these robots
  std::vector<std::uint32_t> takers;         // by rank: how many robots rest on its goal
  std::vector<std::optional<Vec2>> resting;  // m, by rank: where it has come to rest near its goal
  std::vector<std::uint32_t> found;          // scratch memory

  [[nodiscard]] bool is_taken(std::size_t rank) const {
    return !takers.empty() && takers[rank] > 0;
  }
};

/// Computes it anew, where shared goals are known. Call it where goals are new.
void find_taken_goals(World& world);
/// Notes which of the robots that decided have come to rest, or rest no more. Allocates nothing.
void note_resting(World& world);

}  // namespace avo::inline sim
