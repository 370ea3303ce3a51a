// SPDX-License-Identifier: Apache-2.0
// The places that a disc gets to from where it is, and of them the nearest one to where it would go
// (docs/navigation.md).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "navigation/free_space.h"

namespace avo::inline navigation {

/// Remembers what it has found, so that whoever asks next is answered sooner.
class ReachablePlaces {
 public:
  ReachablePlaces(std::span<const Wall> walls, double radius);

  /// Whether the center may be there.
  [[nodiscard]] bool is_free(Vec2 p) const { return space_.is_free(p); }
  /// Whether the disc gets from one to the other.
  [[nodiscard]] bool are_connected(Vec2 p, Vec2 q);
  /// The goal where it gets there, and else the nearest place to it; of equally near ones the
  /// nearest to where it is. A disc in a wall first leaves it for the nearest free place on its own
  /// side. Its own place where it gets nowhere.
  [[nodiscard]] Vec2 nearest_reached(Vec2 from, Vec2 goal);

 private:
  struct Place {
    Vec2 point;
    std::uint32_t region;
  };
  // What is known of the boundary of the places that one wall leaves free.
  struct Boundary {
    bool is_known = false;
    std::vector<Place> places;  // where it bends, and where that of another wall crosses it
    std::vector<std::uint32_t> regions;  // that it has a part in, ascending
  };
  std::uint32_t region_of(Vec2 p);  // of a free place; equal for those that are connected
  const Boundary& boundary_of(std::uint32_t wall);
  std::optional<Vec2> way_out(Vec2 from);
  template <typename Accepts>
  std::optional<Vec2> nearest_accepted(Vec2 from, Vec2 goal, std::optional<std::uint32_t> region,
                                       const Accepts& accepts);

  FreeSpace space_;
  std::vector<Boundary> boundaries_;  // by wall
  std::vector<std::vector<FreeSpace::Winding>> regions_;
  std::unordered_map<std::uint64_t, std::vector<Place>> known_;  // by cell
};

}  // namespace avo::inline navigation
