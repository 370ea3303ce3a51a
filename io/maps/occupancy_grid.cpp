// SPDX-License-Identifier: Apache-2.0
// Walks along the borders of free cells, each border once.
#include "io/maps/occupancy_grid.h"

#include <utility>

#include "core/elementary.h"

namespace avo_io {
namespace {

struct Direction {
  std::int64_t x = 0, y = 0;  // one of them 1 or -1
};

/// Follows a border with free space on the left.
class Walk {
 public:
  Walk(const OccupancyGrid& grid, Corner start) : grid_(grid), at_(start) {}

  [[nodiscard]] Corner at() const { return at_; }
  [[nodiscard]] bool is_eastward() const { return direction_.x == 1; }
  void advance() { at_ = {at_.x + direction_.x, at_.y + direction_.y}; }
  /// Turns into the border's next edge; returns false if the border goes straight on.
  bool turn() {
    const Direction left{-direction_.y, direction_.x};
    const bool free_left = is_free_ahead(left),
               free_right = is_free_ahead({direction_.y, -direction_.x});
    if (free_left && !free_right) return false;
    direction_ = free_left ? Direction{direction_.y, -direction_.x} : left;
    return true;
  }

 private:
  /// Returns whether the cell on that side, which touches the corner ahead, is free.
  [[nodiscard]] bool is_free_ahead(Direction side) const {
    const std::int64_t x = at_.x + (direction_.x + side.x > 0 ? 0 : -1);
    const std::int64_t y = at_.y + (direction_.y + side.y > 0 ? 0 : -1);
    return grid_.is_free(x, grid_.height - 1 - y);
  }

  const OccupancyGrid& grid_;
  Corner at_;
  Direction direction_{1, 0};
};

}  // namespace

avo::Vec2 OccupancyGrid::point(double right, double up) const {
  const avo::Vec2 offset{right * cell, up * cell};
  if (yaw == 0.0) return origin + offset;
  const avo::Vec2 along = avo::elementary::direction(yaw);
  return origin + offset.x * along + offset.y * perpendicular(along);
}

std::optional<std::vector<Contour>> contours(const OccupancyGrid& grid, std::size_t most) {
  std::vector<bool> walked(grid.free.size());  // for each cell: its lower border
  std::vector<Contour> found;
  std::size_t corners = 0;
  const auto index = [&](Corner corner) {
    return static_cast<std::size_t>((grid.height - 1 - corner.y) * grid.width + corner.x);
  };
  for (std::int64_t y = 0; y < grid.height; ++y) {
    for (std::int64_t x = 0; x < grid.width; ++x) {
      // the first eastward edge of a border, from the left, begins at a corner
      const std::int64_t row = grid.height - 1 - y;
      if (!grid.is_free(x, row) || grid.is_free(x, row + 1) || walked[index({x, y})]) continue;
      Contour contour;
      Walk walk(grid, {x, y});
      do {
        if (++corners > most) return std::nullopt;
        contour.push_back(walk.at());
        do {
          if (walk.is_eastward()) walked[index(walk.at())] = true;
          walk.advance();
        } while (!walk.turn());
      } while (!(walk.at() == Corner{x, y} && walk.is_eastward()));
      found.push_back(std::move(contour));
    }
  }
  return found;
}

std::vector<avo::Chain> chains_of(const OccupancyGrid& grid, const std::vector<Contour>& contours) {
  std::vector<avo::Chain> chains;
  for (const Contour& contour : contours) {
    avo::Chain& chain = chains.emplace_back(avo::Chain{{}, true});
    for (const Corner corner : contour)
      chain.points.push_back(
          grid.point(static_cast<double>(corner.x), static_cast<double>(corner.y)));
  }
  return chains;
}

}  // namespace avo_io
