// SPDX-License-Identifier: Apache-2.0
// Walls by place: clearances of points and of line segments, for any walls.
#pragma once
#include <span>

#include "avo/wall.h"
#include "spatial/segment_grid.h"

namespace avo::inline navigation {

inline constexpr double kLengthRounding = 1e-9;  // of a length, more than its rounding

/// m, the radius of the widest wall.
double widest_of(std::span<const Wall> walls);

/// Returns whether the wall's surface is nearer than `room` to the segment from p to q.
bool blocks(const Wall& wall, Vec2 p, Vec2 q, double room);

/// Walls that are found within `reach` of their surfaces.
class ClearanceGrid : public SegmentGrid {
 public:
  ClearanceGrid() = default;
  ClearanceGrid(std::span<const Wall> walls, double reach);

  /// m, the range in which walls are found.
  [[nodiscard]] double reach() const { return reach_; }
  /// m, from p to the nearest wall's surface, negative inside it; reach() where none is nearer.
  [[nodiscard]] double clearance(Vec2 p) const;
  /// Returns whether clearance(p) >= room, which is at most reach(); it takes less time.
  [[nodiscard]] bool has_room(Vec2 p, double room) const;
  /// Returns whether no wall's surface is nearer than `room` <= reach() to the segment from p to q.
  [[nodiscard]] bool is_clear(Vec2 p, Vec2 q, double room) const;
  /// A wall with a surface nearer than `room`; nothing if the segment is clear.
  [[nodiscard]] const Wall* blocker(Vec2 p, Vec2 q, double room) const;

 private:
  double reach_ = 0.0;
};

}  // namespace avo::inline navigation
