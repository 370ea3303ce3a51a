// SPDX-License-Identifier: Apache-2.0
#include "space/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::space {
namespace {

constexpr double kFarthestCell = 0x1p40;  // cells beyond it are merged
// Sides within a search radius. A search then reads at most 4 cells along each axis: with smaller
// cells it would read fewer robots, but more rows.
constexpr double kSides = 1.0;
constexpr std::size_t kFewestBits = 3;  // of cells along an axis: more than a search reads
constexpr std::size_t kSlotsPerRobot = 4;
// A part of a side: more than rounding moves a robot against the cells, at less than kFarthestCell.
constexpr double kRounding = 0x1p-10;

}  // namespace

SpaceCells::SpaceCells(double radius)
    : radius_(radius), side_(radius / kSides), per_meter_(kSides / radius) {}

// Rounding moves a place by less than kRounding against the cells.
std::int64_t SpaceCells::cell(double coordinate) const {
  constexpr double kPositive = 2.0 * kFarthestCell;  // from here on, truncation is rounding down
  const double sides = std::clamp(coordinate * per_meter_, -kFarthestCell, kFarthestCell);
  return static_cast<std::int64_t>(sides + kPositive) - static_cast<std::int64_t>(kPositive);
}

std::size_t SpaceCells::wrapped(std::int64_t its_cell, std::size_t axis) const {
  return static_cast<std::size_t>(its_cell) & ((std::size_t{1} << bits_[axis]) - 1);
}

std::size_t SpaceCells::row(std::int64_t y, std::int64_t z) const {
  return ((wrapped(z, 2) << bits_[1]) | wrapped(y, 1)) << bits_[0];
}

// m: how far a cell is at least from a coordinate.
double SpaceCells::away(double coordinate, std::int64_t its_cell) const {
  if (!(std::abs(coordinate) * per_meter_ < kFarthestCell)) return 0.0;
  const double low = static_cast<double>(its_cell) * side_, high = low + side_;
  return std::max(std::max(low - coordinate, coordinate - high) - kRounding * side_, 0.0);
}

// Each axis in turn gets twice as many cells, until it covers the robots or the table is large.
void SpaceCells::choose_sizes(std::span<const Robot> robots) {
  constexpr double kMost = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kMost, kMost, kMost}, high{-kMost, -kMost, -kMost};
  for (const Robot& robot : robots) {
    const std::array<double, 3> p{robot.position.x, robot.position.y, robot.position.z};
    for (std::size_t i = 0; i < 3; ++i)
      low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  }
  bits_ = {kFewestBits, kFewestBits, kFewestBits};
  std::size_t table = std::size_t{1} << (3 * kFewestBits);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < 3 && table < kSlotsPerRobot * robots.size(); ++i) {
      const auto cells = static_cast<double>(std::size_t{1} << bits_[i]);
      if (!((high[i] - low[i]) * per_meter_ >= cells)) continue;
      ++bits_[i], table *= 2, grows = true;
    }
  }
}

void SpaceCells::sort(std::span<const Robot> robots) {
  choose_sizes(robots);
  keys_.resize(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const Vec3 p = robots[k].position;
    keys_[k] = static_cast<std::uint32_t>(row(cell(p.y), cell(p.z)) + wrapped(cell(p.x), 0));
  }
  sorted_.resize(std::size_t{1} << (bits_[0] + bits_[1] + bits_[2]), robots.size());
  sort_part(keys_, 0, 1, sorted_);
}

std::size_t SpaceCells::around(Vec3 place, Runs& runs) const {
  std::size_t count = 0;
  const auto add = [&](std::size_t first_slot, std::size_t last_slot) {
    runs[count] = {sorted_.begin[first_slot], sorted_.begin[last_slot + 1]};
    count += runs[count].first < runs[count].last ? 1 : 0;
  };
  const double reach = radius_ + kRounding * side_, squared = reach * reach;
  const std::int64_t y_first = cell(place.y - reach), y_last = cell(place.y + reach);
  std::array<double, kMostSpan> away_y_squared{};
  for (std::int64_t y = y_first; y <= y_last; ++y) {
    const double away_y = away(place.y, y);
    away_y_squared[static_cast<std::size_t>(y - y_first)] = away_y * away_y;
  }
  const std::size_t end = wrapped(-1, 0);
  for (std::int64_t z = cell(place.z - reach), z_last = cell(place.z + reach); z <= z_last; ++z) {
    const double away_z = away(place.z, z), left = squared - away_z * away_z;
    for (std::int64_t y = y_first; y <= y_last; ++y) {
      const double half_squared = left - away_y_squared[static_cast<std::size_t>(y - y_first)];
      if (!(half_squared >= 0.0)) continue;
      const double half = std::sqrt(half_squared) + kRounding * side_;
      const std::size_t slots = row(y, z);
      const std::size_t first = wrapped(cell(place.x - half), 0);
      const std::size_t last = wrapped(cell(place.x + half), 0);
      if (first > last) add(slots, slots + last);
      add(slots + first, slots + (first > last ? end : last));
    }
  }
  return count;
}

}  // namespace avo::space
