// SPDX-License-Identifier: Apache-2.0
// Where walls leave so little room that robots pass one behind the other, or in two lanes
// (docs/navigation.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "navigation/clearance_grid.h"
#include "navigation/wall_changes.h"

namespace avo::inline navigation {

/// The straight line across the free space where it is narrowest, between the surfaces of two
/// walls.
struct Gap {
  Vec2 a = {}, b = {};     // m
  double radius = 0.0;     // m, of the largest robots that fit
  bool two_lanes = false;  // it has room for two robots of that radius side by side
  [[nodiscard]] double width() const { return norm(b - a); }
  [[nodiscard]] Vec2 middle() const { return 0.5 * (a + b); }
  /// Unit, to the left of the line from a to b.
  [[nodiscard]] Vec2 ahead() const { return perpendicular(b - a) / norm(b - a); }
};

/// The gaps at ends of walls.
struct ToldGaps {
  enum class Kind : std::uint8_t {
    open,
    pocket,    ///< behind it there is room for a robot, and no route on
    left_out,  ///< it was found twice, or a gap that is no wider crosses it
  };
  std::vector<Gap> all;
  std::vector<Kind> kind;  // of each
  // of each wall's two ends, index into all; and the number of gaps at the end
  std::vector<std::uint32_t> first;
  std::size_t examined = 0;  // number of gaps with a newly found kind

  /// Indices into `all`.
  [[nodiscard]] std::vector<std::uint32_t> numbers_of(Kind which) const;
};
/// radii: of all robots, ascending, each > 0. The grid must find walls within gap_reach().
ToldGaps tell_gaps(const ClearanceGrid& grid, std::span<const double> radii);
/// The same result, sooner, from the gaps of the same radii before the walls changed. number: the
/// present number of each earlier gap; kNoGap: it was searched for anew.
ToldGaps tell_gaps(const ClearanceGrid& grid, std::span<const double> radii, const ToldGaps& before,
                   const WallChanges& changes, std::vector<std::uint32_t>& number);
inline constexpr std::uint32_t kNoGap = 0xffffffff;

/// All gaps that lead somewhere, and pockets.
std::vector<Gap> find_gaps(const ClearanceGrid& grid, std::span<const double> radii);
double gap_reach(std::span<const double> radii, double widest_wall);

/// m: free space with more clearance than this is wider than the gap.
double most_clearance(const Gap& gap);

}  // namespace avo::inline navigation
