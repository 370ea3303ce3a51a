// SPDX-License-Identifier: Apache-2.0
// Which places may be in view of another one. Directions around it are divided into sectors, and a
// wall that covers a sector hides everything behind it there. The rest must be tested exactly.
#pragma once
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "spatial/segment_grid.h"

namespace avo::inline navigation {

/// How far one sees from a place.
class Horizons {
 public:
  static constexpr std::size_t kSectors = 256;
  using Sectors = std::bitset<kSectors>;

  /// room: m, clearance from walls that the segment to a seen place needs, > 0.
  Horizons(Vec2 place, double room) : place_(place), room_(room) {
    far_.fill(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] static std::size_t sector_of(Vec2 direction);
  /// The unit directions in which the sectors begin.
  [[nodiscard]] static const std::array<Vec2, kSectors>& borders();

  [[nodiscard]] bool is_hidden(Vec2 q) const {
    return norm_squared(q - place_) > square(far_[sector_of(q - place_)]);
  }
  /// m: nothing farther off matters in that sector.
  void close(std::size_t sector, double distance) {
    if (distance < far_[sector]) far_[sector] = distance;
  }
  /// Closes the other sectors: nothing in them matters.
  void close_all_but(const Sectors& open) {
    for (std::size_t k = 0; k < kSectors; ++k)
      if (!open[k]) close(k, 0.0);
  }
  /// m: nothing farther off has been examined within each of these parts of the full turn.
  static constexpr std::size_t kParts = 32;
  [[nodiscard]] std::array<float, kParts> reach() const;
  /// Hides the places behind that wall; nothing if the wall is most likely hidden itself.
  void block_if_seen(const Wall& wall) {
    if (!is_hidden(wall.a) || !is_hidden(wall.b) || !is_hidden(0.5 * (wall.a + wall.b)))
      block(wall);
  }
  /// Returns whether no place of the square is in view.
  [[nodiscard]] bool hides(Vec2 low, Vec2 high) const;

 private:
  void block(const Wall& wall);
  static double square(double x) { return x * x; }
  Vec2 place_;   // m
  double room_;  // m
  std::array<double, kSectors> far_;
};

/// Returns whether a part of a disc is within that reach of a place.
bool reaches(const std::array<float, Horizons::kParts>& reach, Vec2 place, Vec2 center,
             double radius);

/// The sectors around a place that contain a part of a disc, and perhaps the next ones.
Horizons::Sectors sectors_of(Vec2 place, Vec2 center, double radius);

/// Walls and points by place.
class ViewIndex {
 public:
  ViewIndex() = default;
  ViewIndex(std::span<const Wall> walls, std::span<const Vec2> points);

  /// Calls visit(point, place) for the points that may be in view, and for some that the horizons
  /// hide, which come nearer meanwhile.
  template <typename Visit>
  void look(Vec2 place, Horizons& horizons, const Visit& visit) const;
  /// Calls visit(point) for the points near that place, and for others.
  template <typename Visit>
  void for_each_near(Vec2 place, const Visit& visit) const;

 private:
  using Cell = SegmentGrid::Cell;
  // The cells of the ring around the middle through which the view may go on. Around a place
  // outside these are all cells, and otherwise those beside cells in view.
  void next_ring(Cell middle, std::int64_t away, bool is_inside, const std::vector<Cell>& in_view,
                 std::vector<Cell>& ring, std::vector<char>& is_in_ring) const;
  template <typename Visit>
  bool look_into(Cell cell, Vec2 place, Horizons& horizons, const Visit& visit) const;

  SegmentGrid grid_;       // of the walls, and then of the points
  std::size_t walls_ = 0;  // number
};

// Returns whether a part of the cell may be in view.
template <typename Visit>
bool ViewIndex::look_into(Cell cell, Vec2 place, Horizons& horizons, const Visit& visit) const {
  const Vec2 low = grid_.corner(cell);
  if (horizons.hides(low, low + grid_.side() * Vec2{1.0, 1.0})) return false;
  for (const std::uint32_t k : grid_.list(cell)) {
    const Wall& item = grid_.walls()[k];
    if (k < walls_)
      horizons.block_if_seen(item);
    else if (!(item.a == place))
      visit(static_cast<std::uint32_t>(k - walls_), item.a);
  }
  return true;
}

template <typename Visit>
void ViewIndex::look(Vec2 place, Horizons& horizons, const Visit& visit) const {
  if (walls_ == 0) return;
  const Cell middle = grid_.cell_of(place);
  const bool is_inside = grid_.covers(place);
  std::vector<Cell> in_view, ring{middle};
  std::vector<char> is_in_ring;
  for (std::int64_t away = 1; !ring.empty(); ++away) {
    in_view.clear();
    for (const Cell cell : ring)
      if (look_into(cell, place, horizons, visit)) in_view.push_back(cell);
    next_ring(middle, away, is_inside, in_view, ring, is_in_ring);
  }
}

template <typename Visit>
void ViewIndex::for_each_near(Vec2 place, const Visit& visit) const {
  grid_.all_near(place, place, [&](std::size_t k) {
    if (k >= walls_) visit(static_cast<std::uint32_t>(k - walls_));
    return true;
  });
}

}  // namespace avo::inline navigation
