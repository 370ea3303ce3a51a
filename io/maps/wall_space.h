// SPDX-License-Identifier: Apache-2.0
// The places where discs keep clear of static obstacles.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo_io {

/// Lists of numbers in one array.
struct Lists {
  std::vector<std::size_t> begin;  ///< begin of each list, and the end of the last
  std::vector<std::uint32_t> items;
};

/// Walls by square cells: each cell lists the walls that may be within reach of a center in it.
class NearWalls {
 public:
  /// `reach`: m, from a center to the surface of a wall.
  NearWalls(std::span<const avo::StaticObstacle> obstacles, double reach);
  [[nodiscard]] bool is_clear(avo::Vec2 center) const;

 private:
  [[nodiscard]] std::int64_t column(double x) const;
  [[nodiscard]] std::int64_t row(double y) const;
  template <class Visit>
  void visit_cells(const avo::Wall& wall, const Visit& visit) const;

  double reach_;
  std::vector<avo::Wall> walls_;
  avo::Vec2 min_, max_;  // m, of all centers that are not clear
  double side_ = 0.0;    // m
  std::int64_t columns_ = 0, rows_ = 0;
  Lists near_;
};

/// Solids and bounds, by the even-odd rule: edges by strips along x.
class Regions {
 public:
  explicit Regions(std::span<const avo::StaticObstacle> obstacles);
  /// Returns whether the point is outside all solids and inside all bounds.
  [[nodiscard]] bool allow(avo::Vec2 point) const;

 private:
  struct Edge {
    avo::Vec2 a, b;
    std::uint32_t region;
  };
  void add(const avo::StaticObstacle& obstacle);
  [[nodiscard]] double strip(double y) const;

  std::vector<avo::Fill> fills_;        // for each region
  std::size_t bounds_ = 0;              // number of regions that are bounds
  std::vector<Edge> edges_;             // by region
  double bottom_ = 0.0, height_ = 1.0;  // m, of the first strip
  std::size_t strips_ = 0;
  Lists across_;  // by strip: edges that reach into it, sorted by region
};

/// Centers at which a disc keeps clear of all walls, solids and bounds.
class WallSpace {
 public:
  WallSpace(std::span<const avo::StaticObstacle> obstacles, double reach)
      : walls_(obstacles, reach), regions_(obstacles) {}
  [[nodiscard]] bool is_clear(avo::Vec2 center) const {
    return walls_.is_clear(center) && regions_.allow(center);
  }

 private:
  NearWalls walls_;
  Regions regions_;
};

}  // namespace avo_io
