// SPDX-License-Identifier: Apache-2.0
// The places that a disc can reach from its place, and among them the one nearest to its goal
// (docs/navigation.md).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "navigation/free_space.h"

namespace avo::inline navigation {

/// Remembers its results, so that later requests are answered sooner.
class ReachablePlaces {
 public:
  ReachablePlaces(std::span<const Wall> walls, double radius);

  /// Returns whether the center may be there.
  [[nodiscard]] bool is_free(Vec2 p) const { return space_.is_free(p); }
  /// Returns whether the disc can move from one to the other.
  [[nodiscard]] bool are_connected(Vec2 p, Vec2 q);
  /// The goal where the disc can reach it, and otherwise the reachable place nearest to it. Among
  /// equally near ones it is the one nearest to the disc. A disc in a wall first leaves it for the
  /// nearest free place on its own side. The result is its own place where it can reach no other.
  [[nodiscard]] Vec2 nearest_reached(Vec2 from, Vec2 goal);

 private:
  struct FreePlace {
    Vec2 point;
    std::uint32_t region;
  };
  // The known facts about the boundary of the places that one wall leaves free.
  struct FreeBoundary {
    bool is_known = false;
    std::vector<FreePlace>
        places;  // where it bends, and where the boundary of another wall crosses it
    std::vector<std::uint32_t> regions;  // regions that contain a part of it, ascending
  };
  std::uint32_t region_of(Vec2 p);  // of a free place; equal for connected places
  const FreeBoundary& boundary_of(std::uint32_t wall);
  std::optional<Vec2> nearest_free(Vec2 from);
  template <typename Accepts>
  std::optional<Vec2> nearest_accepted(Vec2 from, Vec2 goal, std::optional<std::uint32_t> region,
                                       const Accepts& accepts);

  FreeSpace space_;
  std::vector<FreeBoundary> boundaries_;  // by wall
  std::vector<std::vector<FreeSpace::Winding>> regions_;
  std::unordered_map<std::uint64_t, std::vector<FreePlace>> known_;  // by cell
};

}  // namespace avo::inline navigation
