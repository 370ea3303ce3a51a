// SPDX-License-Identifier: Apache-2.0
// The places in a rectangle where one more disc of a group has room.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/geometry.h"

namespace avo_io {

/// Square cells over a rectangle, row by row. A point outside belongs to the nearest cell.
struct Cells {
  double side = 0.0;       // m
  double per_meter = 0.0;  // 1/m
  int columns = 0, rows = 0;

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] int column(double x) const { return at(x, columns); }
  [[nodiscard]] int row(double y) const { return at(y, rows); }

 private:
  [[nodiscard]] int at(double offset, int most) const {
    const double cell = std::clamp(offset * per_meter, 0.0, most - 1.0);
    return static_cast<int>(cell);
  }
};

/// Centers in a rectangle at which a disc of one radius keeps clear of all added discs.
class FreeSpace {
 public:
  /// `radius` > 0: of the discs in queries. `count`: about the number of discs that will be added;
  /// it sets the size of the cells.
  FreeSpace(avo::Vec2 min, avo::Vec2 max, double radius, double clearance, std::size_t count);

  void add(const avo::Disc& disc);
  /// `center` must lie within the rectangle.
  [[nodiscard]] bool is_clear(avo::Vec2 center) const;
  /// Announces that is_clear(center) will be called soon.
  void prefetch(avo::Vec2 center) const { __builtin_prefetch(&covered_[fine_index(center) / 64]); }

 private:
  struct Entry {
    avo::Disc disc;
    int before;  // the disc before it in the same cell, or kNone
  };
  /// Discs of up to one radius, each in the cell of its center. Cells are so wide that a disc that
  /// blocks a center stands in the cell of that center or next to it.
  struct Layer {
    double largest_radius;
    Cells cells;
    std::vector<int> last;  // for each cell: an index of entries, or kNone
    std::vector<Entry> entries;
  };
  static constexpr int kNone = -1;

  [[nodiscard]] std::size_t fine_index(avo::Vec2 center) const {
    return fine_.index(fine_.column(center.x - min_.x), fine_.row(center.y - min_.y));
  }
  [[nodiscard]] Cells cells_of(double side) const;
  Layer& layer_of(double radius);
  [[nodiscard]] bool is_clear_of(const Layer& layer, avo::Vec2 center) const;
  void cover(avo::Vec2 offset, double reach);

  avo::Vec2 min_, size_;
  double radius_, clearance_, most_cells_;
  std::vector<Layer> layers_;  // each for twice the radius of the layer before, if it has discs
  Cells fine_;
  // a bit for each fine cell: one disc leaves no point of it free
  std::vector<std::uint64_t> covered_;
};

}  // namespace avo_io
