// SPDX-License-Identifier: Apache-2.0
// Which places a disc can reach from which others, decided at its exact radius
// (docs/navigation.md).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "navigation/clearance_grid.h"

namespace avo::inline navigation {

/// The places where the center of a disc may be without overlapping a wall; contact is allowed.
class FreeSpace {
 public:
  FreeSpace(std::span<const Wall> walls, double radius);

  [[nodiscard]] double radius() const { return radius_; }
  /// Finds walls within two radii plus the width of the widest wall.
  [[nodiscard]] const ClearanceGrid& grid() const { return grid_; }
  /// Returns whether the center may be there.
  [[nodiscard]] bool is_free(Vec2 p) const;

  /// Two places of the free space have equal windings exactly if the disc can move from one to the
  /// other. A winding counts how often a ring of walls runs around the place; only rings that do
  /// are listed.
  struct Winding {
    std::uint32_t ring = 0;
    std::int32_t times = 0;
    friend bool operator==(Winding, Winding) = default;
  };
  [[nodiscard]] std::vector<Winding> windings(Vec2 p) const;
  [[nodiscard]] bool are_connected(Vec2 p, Vec2 q) const { return windings(p) == windings(q); }

 private:
  // The line from the first end of wall `from` to the first end of wall `to`, along both and
  // straight across.
  struct Link {
    std::uint32_t from, to;
    Vec2 leaves, meets;
  };
  [[nodiscard]] std::int32_t crossings(const Link& link, Vec2 p) const;

  double radius_ = 0.0;
  ClearanceGrid grid_;
  std::vector<Link> tree_;   // each `to` comes once, and no earlier link has it as `from`
  std::vector<Link> rings_;  // each closes one ring with the tree
};

}  // namespace avo::inline navigation
