// SPDX-License-Identifier: Apache-2.0
#include "planner/alone.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "planner/scratch.h"
#include "planner/stages/neighbor_order.h"
#include "planner/validity.h"

namespace avo::inline planner {
namespace {

// Prefetches a neighbor. Lists are in the caller's memory, far from the caches if the caller plans
// many robots in turn.
void prefetch([[maybe_unused]] const Neighbor* neighbor) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64;  // bytes
  for (std::size_t at = 0; at < sizeof(Neighbor); at += kLine)
    __builtin_prefetch(reinterpret_cast<const char*>(neighbor) + at);
#endif
}

// Takes the neighbors as the only ones of the tile, nearest first; none if one is invalid. It takes
// one pass if they come in that order.
std::optional<Neighbors> take_neighbors(const Robot& robot, std::span<const Neighbor> given,
                                        PlanWorkspace::Scratch& scratch) {
  NeighborColumns& columns = scratch.alone.neighbors;
  columns.reserve(given.size());
  constexpr std::size_t kAhead = 8;
  double last = 0.0;  // m²
  bool in_order = true;
  for (const Neighbor& neighbor : given) {
    prefetch(&neighbor + kAhead);
    if (!is_valid(neighbor)) return std::nullopt;
    const double squared = distance_squared(robot, neighbor);
    in_order = in_order && squared >= last;
    last = squared;
    columns.add(neighbor);
  }
  if (!in_order) return in_columns(nearest_first(robot, given, scratch), columns);
  return Neighbors{&columns, 0, given.size()};
}

}  // namespace

bool take_alone(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, PlanWorkspace::Scratch& scratch) {
  Tile& tile = scratch.alone;
  tile.clear();
  const bool walls_valid =
      std::all_of(walls.begin(), walls.end(), [](const Wall& wall) { return is_valid(wall); });
  if (!walls_valid || !is_valid(robot) || !follows_heading(robot)) return false;
  const auto listed = take_neighbors(robot, neighbors, scratch);
  if (!listed) return false;
  tile.robots.reserve(1);
  tile.robots.add(robot, *listed);
  tile.slot.push_back(0);
  if (!walls.empty()) tile.walls.push_back(walls);
  return true;
}

}  // namespace avo::inline planner
