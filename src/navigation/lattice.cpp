// SPDX-License-Identifier: Apache-2.0
#include "navigation/lattice.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

// In radii. Below √2, no wall separates two free places in one cell.
constexpr double kSpacing = 1.4;
constexpr double kMostCells = 1 << 20;
constexpr double kHalfDiagonal = 0.7072;  // of a cell
constexpr int kMostPushes = 6;

struct NearestWall {
  double clearance;  // m
  Vec2 away;         // unit
};

NearestWall nearest_wall(const ClearanceGrid& grid, Vec2 p) {
  NearestWall nearest{grid.reach(), {}};
  grid.all_near(p, p, [&](std::size_t k) {
    const Wall& wall = grid.walls()[k];
    const Vec2 from = p - nearest_on({wall.a, wall.b}, p);
    const double distance = norm(from);
    if (!(distance - wall.radius < nearest.clearance)) return true;
    const Vec2 along = wall.b - wall.a;
    const Vec2 aside = along == Vec2{} ? Vec2{1.0, 0.0} : perpendicular(along) / norm(along);
    nearest = {distance - wall.radius, distance > 0.0 ? from / distance : aside};
    return true;
  });
  return nearest;
}

struct WallExtent {
  Vec2 low, high;
};

WallExtent box_of(std::span<const Wall> walls, double around) {
  WallExtent box{walls[0].a, walls[0].a};
  for (const Wall& wall : walls) {
    const double margin = wall.radius + around;
    box.low.x = std::min({box.low.x, wall.a.x - margin, wall.b.x - margin});
    box.low.y = std::min({box.low.y, wall.a.y - margin, wall.b.y - margin});
    box.high.x = std::max({box.high.x, wall.a.x + margin, wall.b.x + margin});
    box.high.y = std::max({box.high.y, wall.a.y + margin, wall.b.y + margin});
  }
  return box;
}

}  // namespace

bool Lattice::covers(Vec2 p) const {
  const auto is_within = [this](double x, std::int64_t begin, std::int64_t count) {
    return x >= spacing * static_cast<double>(begin) &&
           x <= spacing * static_cast<double>(begin + count);
  };
  return is_within(p.x, first_column, columns) && is_within(p.y, first_row, rows);
}

Lattice::LatticeCell Lattice::place_of(Vec2 p) const {
  const auto cell = [this](double x, std::int64_t begin, std::int64_t count) {
    const double number = std::floor(x / spacing) - static_cast<double>(begin);
    return static_cast<std::int64_t>(std::clamp(number, 0.0, static_cast<double>(count - 1)));
  };
  return {cell(p.x, first_column, columns), cell(p.y, first_row, rows)};
}

Vec2 Lattice::middle_of(std::size_t cell) const {
  const auto number = static_cast<std::int64_t>(cell);
  const std::int64_t column = first_column + number % columns, row = first_row + number / columns;
  return spacing * Vec2{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
}

namespace {

double spacing_over(Vec2 extent, double radius) {
  return std::max({kSpacing * radius, std::sqrt(extent.x * extent.y / kMostCells),
                   std::max(extent.x, extent.y) / kMostCells});
}

}  // namespace

double lattice_cells(const ClearanceGrid& grid, double radius) {
  const WallExtent walls = box_of(grid.walls(), radius + 2.0 * kSpareRoom);
  const Vec2 extent = walls.high - walls.low;
  const double spacing = spacing_over(extent, radius);
  return extent.x / spacing * (extent.y / spacing);
}

Lattice make_lattice(const ClearanceGrid& grid, std::span<const Vec2> corners, double radius) {
  const WallExtent walls = box_of(grid.walls(), radius + 2.0 * kSpareRoom);
  const Vec2 extent = walls.high - walls.low;
  Lattice lattice;
  lattice.spacing = spacing_over(extent, radius);
  const auto lay = [&](double low, double high, std::int64_t& begin, std::int64_t& count) {
    begin = static_cast<std::int64_t>(std::floor(low / lattice.spacing)) - 1;
    count = static_cast<std::int64_t>(std::floor(high / lattice.spacing)) + 2 - begin;
  };
  lay(walls.low.x, walls.high.x, lattice.first_column, lattice.columns);
  lay(walls.low.y, walls.high.y, lattice.first_row, lattice.rows);
  std::vector<std::uint32_t> cells;
  for (const Vec2 corner : corners)
    cells.push_back(static_cast<std::uint32_t>(lattice.cell_of(corner)));
  lattice.corners.resize(lattice.cells(), corners.size());
  sort_part(cells, 0, 1, lattice.corners);
  return lattice;
}

std::optional<Sample> sample_in(const Lattice& lattice, std::size_t cell, const ClearanceGrid& grid,
                                double radius) {
  const double half = 0.5 * lattice.spacing;
  const Vec2 middle = lattice.middle_of(cell);
  const double clearance = grid.clearance(middle);
  if (clearance < radius - kHalfDiagonal * lattice.spacing) return {};
  for (const double part : kSpareParts) {
    const double room = radius + part * kSpareRoom;
    Vec2 p = middle;
    for (int push = 0; push <= kMostPushes; ++push) {
      const NearestWall nearest = nearest_wall(grid, p);
      if (nearest.clearance >= room) return Sample{p, room - kLengthRounding * radius};
      p = p + (room * (1.0 + kLengthRounding) - nearest.clearance) * nearest.away;
      p.x = std::clamp(p.x, middle.x - half, middle.x + half);
      p.y = std::clamp(p.y, middle.y - half, middle.y + half);
    }
  }
  return {};
}

}  // namespace avo::inline navigation
