// SPDX-License-Identifier: Apache-2.0
#include "space/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace avo::space {
namespace {

constexpr double kFarthestCell = 0x1p40;  // cells beyond it are merged

}  // namespace

std::int64_t SpaceCells::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::floor(std::clamp(coordinate * per_meter_, -kFarthestCell, kFarthestCell)));
}

// Cells may share a slot: robots of other cells fail the test of distance.
std::uint32_t SpaceCells::slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
  const auto part = [](std::int64_t a, std::uint64_t odd) {
    return static_cast<std::uint64_t>(a) * odd;
  };
  const std::uint64_t hash =
      part(x, 0x9E3779B97F4A7C15U) ^ part(y, 0xC2B2AE3D27D4EB4FU) ^ part(z, 0x165667B19E3779F9U);
  return static_cast<std::uint32_t>(hash >> 32U) & mask_;
}

void SpaceCells::sort(std::span<const Robot> robots) {
  const std::size_t table = std::bit_ceil(std::max<std::size_t>(2 * robots.size(), 64));
  mask_ = static_cast<std::uint32_t>(table - 1);
  keys_.resize(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const Vec3 p = robots[k].position;
    keys_[k] = slot(cell(p.x), cell(p.y), cell(p.z));
  }
  sorted_.resize(table, robots.size());
  sort_part(keys_, 0, 1, sorted_);
}

void SpaceCells::collect(Vec3 place, std::vector<std::uint32_t>& found) const {
  const std::int64_t x = cell(place.x), y = cell(place.y), z = cell(place.z);
  std::array<std::uint32_t, 27> slots{};
  std::size_t count = 0;
  for (std::int64_t i = -1; i <= 1; ++i) {
    for (std::int64_t j = -1; j <= 1; ++j) {
      for (std::int64_t k = -1; k <= 1; ++k) slots[count++] = slot(x + i, y + j, z + k);
    }
  }
  std::sort(slots.begin(), slots.end());
  const auto last = std::unique(slots.begin(), slots.end());  // two cells may share a slot
  for (auto s = slots.begin(); s != last; ++s) {
    for (std::uint32_t at = sorted_.begin[*s]; at < sorted_.begin[*s + 1]; ++at)
      found.push_back(sorted_.order[at]);
  }
}

}  // namespace avo::space
