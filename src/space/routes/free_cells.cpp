// SPDX-License-Identifier: Apache-2.0
#include "space/routes/free_cells.h"

#include <cmath>
#include <utility>

#include "space/routes/tubes.h"

namespace avo::space {
namespace {

// Part of the radius. No plate separates the free parts of a cell. The sides of a plate are two
// radii apart there, and the diagonal of a cell is shorter.
constexpr double kSide = 1.15;
constexpr std::size_t kMostCells = std::size_t{1} << 19U;
constexpr double kLacking = 1e-9;     // of the room, that a line between two places may lack
constexpr double kHalf = 0.5 + 1e-9;  // of the side
constexpr int kPushes = 16;
constexpr double kLessEachPush = 0.7;

// The grid with cells of that side, or larger ones where there would be too many.
CellGrid grid_of(const Bounds& within, double side) {
  const Vec3 size = within.high - within.low;
  CellGrid grid{.corner = within.low, .side = side};
  const auto cells = [&](double length) { return std::max(1.0, std::ceil(length / grid.side)); };
  while (cells(size.x) * cells(size.y) * cells(size.z) > static_cast<double>(kMostCells))
    grid.side *= 1.1;
  grid.count = {static_cast<int>(cells(size.x)), static_cast<int>(cells(size.y)),
                static_cast<int>(cells(size.z))};
  return grid;
}

/// A place and the distance of the nearest surface from it, m.
struct Placed {
  Vec3 place;
  double clearance = 0.0;
};

// The middle of a cell, pushed off boxes by ever shorter steps until it keeps the room; else the
// best place on the line.
Placed pushed(const Solids& solids, Vec3 middle, double side, double room, double sight) {
  const Vec3 half = 0.5 * side * Vec3{1.0, 1.0, 1.0};
  Away near = solids.away(middle, sight);
  Placed best{middle, near.distance};
  Vec3 place = middle;
  double step = 0.5 * side;
  for (int k = 0; k < kPushes && best.clearance < room; ++k, step *= kLessEachPush) {
    const Vec3 push = std::min(room - near.distance, step) * near.normal;
    place = least_of(most_of(place + push, middle - half), middle + half);
    near = solids.away(place, sight);
    if (near.distance > best.clearance) best = {place, near.distance};
  }
  return best;
}

/// Cells from one corner to another one.
struct CellBlock {
  std::array<int, 3> low, high;
};
CellBlock cells_of(const CellGrid& grid, const Bounds& bounds) {
  return {grid.of(bounds.low), grid.of(bounds.high)};
}

template <typename Visit>
void for_each_in(const CellBlock& range, const Visit& visit) {
  std::array<int, 3> at{};
  for (at[2] = range.low[2]; at[2] <= range.high[2]; ++at[2]) {
    for (at[1] = range.low[1]; at[1] <= range.high[1]; ++at[1]) {
      for (at[0] = range.low[0]; at[0] <= range.high[0]; ++at[0]) visit(at);
    }
  }
}

// What the plane of the slot is between, grown on all sides.
Bounds bounds_of(const Slot& slot, double beyond) {
  const bool is_far = std::isinf(slot.low_1) || std::isinf(slot.high_1) || std::isinf(slot.low_2) ||
                      std::isinf(slot.high_2);
  const Vec3 far{Bounds::kFar, Bounds::kFar, Bounds::kFar};
  if (is_far) return {-far, far};
  Bounds bounds;
  for (const double one : {slot.low_1, slot.high_1}) {
    for (const double two : {slot.low_2, slot.high_2})
      bounds.include(slot.middle + one * slot.along_1 + two * slot.along_2);
  }
  return bounds.grown(beyond);
}

double largest_of(Vec3 a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

}  // namespace

std::array<int, 3> CellGrid::at(std::uint32_t cell) const {
  const int row = static_cast<int>(cell) / count[0];
  return {static_cast<int>(cell) % count[0], row % count[1], row / count[1]};
}

std::array<int, 3> CellGrid::of(Vec3 place) const {
  const Vec3 in = (place - corner) / side;
  const auto number = [](double x, int cells) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(cells - 1)));
  };
  return {number(in.x, count[0]), number(in.y, count[1]), number(in.z, count[2])};
}

Vec3 CellGrid::middle(const std::array<int, 3>& at) const {
  return corner + side * Vec3{at[0] + 0.5, at[1] + 0.5, at[2] + 0.5};
}

bool CellGrid::contains(const std::array<int, 3>& at) const {
  return at[0] >= 0 && at[0] < count[0] && at[1] >= 0 && at[1] < count[1] && at[2] >= 0 &&
         at[2] < count[2];
}

const std::array<CellStep, 26>& cell_steps() {
  static const std::array<CellStep, 26> steps = [] {
    std::array<CellStep, 26> all{};
    std::size_t next = 0;
    for (int k = 0; k < 27; ++k) {
      if (k != 13) all[next++] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
    }
    return all;
  }();
  return steps;
}

double FreeCells::widest_slot(double radius) {
  return 2.0 * (radius + kRouteRoom) + kSide * radius;
}

FreeCells::FreeCells(const Solids& solids, const Bounds& within, double radius)
    : grid_(grid_of(within, kSide * radius)), most_room_(radius + kRouteRoom) {
  for (std::size_t k = 0; k < jump_.size(); ++k) {
    const CellStep& step = cell_steps()[k];
    jump_[k] =
        (static_cast<std::int64_t>(step[2]) * grid_.count[1] + step[1]) * grid_.count[0] + step[0];
  }
  std::vector<double> clearance;
  place_all(solids, radius, clearance);
  place_in_slots(solids, radius, clearance);
  join_all(solids, clearance);
  find_parts();
}

void FreeCells::place_all(const Solids& solids, double radius, std::vector<double>& clearance) {
  const std::size_t count = grid_.size();
  place_.resize(count), room_.resize(count), clearance.resize(count);
  const double sight = most_room_ + 2.0 * grid_.side;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 middle = grid_.middle(grid_.at(static_cast<std::uint32_t>(k)));
    const Placed placed = pushed(solids, middle, grid_.side, most_room_, sight);
    place_[k] = placed.place, clearance[k] = placed.clearance;
    if (placed.clearance >= kLeastRoom * radius) room_[k] = std::min(most_room_, placed.clearance);
  }
}

// A cell that the middle plane of a narrow slot cuts has its place in that plane. Where two planes
// meet, it is on the axis of a tube. A place beside it sees too little of what is beyond.
void FreeCells::place_in_slots(const Solids& solids, double radius,
                               std::vector<double>& clearance) {
  const double sight = most_room_ + 2.0 * grid_.side, beyond = most_room_ + grid_.side;
  std::vector<std::pair<std::uint32_t, Vec3>> moved;  // by cell, from its middle
  for (const Slot& slot : find_slots(solids, 2.0 * kLeastRoom * radius, widest_slot(radius))) {
    const CellBlock range = cells_of(grid_, bounds_of(slot, beyond));
    for_each_in(range, [&](const std::array<int, 3>& at) {
      const Vec3 middle = grid_.middle(at);
      const Vec3 off = dot(slot.middle - middle, slot.normal) * slot.normal;
      const Vec3 in = middle + off - slot.middle;
      const double one = dot(in, slot.along_1), two = dot(in, slot.along_2);
      if (one < slot.low_1 - beyond || one > slot.high_1 + beyond || two < slot.low_2 - beyond ||
          two > slot.high_2 + beyond || largest_of(off) > kHalf * grid_.side)
        return;
      moved.emplace_back(grid_.number(at), off);
    });
  }
  std::stable_sort(moved.begin(), moved.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < moved.size();) {
    const std::uint32_t cell = moved[k].first;
    Vec3 place = grid_.middle(grid_.at(cell));
    Vec3 last;
    for (; k < moved.size() && moved[k].first == cell; ++k) {
      const Vec3 off = moved[k].second;
      if (dot(off, last) == 0.0) place = place + off;
      last = off;
    }
    const double free = solids.away(place, sight).distance;
    if (free < kLeastRoom * radius) continue;
    place_[cell] = place, clearance[cell] = free, room_[cell] = std::min(most_room_, free);
  }
}

// The second half of the steps is the first half turned round.
void FreeCells::join_all(const Solids& solids, const std::vector<double>& clearance) {
  joined_.assign(grid_.size(), 0);
  for (std::uint32_t a = 0; a < joined_.size(); ++a) {
    if (room_[a] == 0.0) continue;
    const std::array<int, 3> at = grid_.at(a);
    for (std::size_t k = 13; k < 26; ++k) {
      const CellStep& step = cell_steps()[k];
      if (!grid_.contains({at[0] + step[0], at[1] + step[1], at[2] + step[2]})) continue;
      const auto b = static_cast<std::uint32_t>(a + jump_[k]);
      if (room_[b] == 0.0) continue;
      const double room = (1.0 - kLacking) * std::min(room_[a], room_[b]);
      if (clearance[a] < room + norm(place_[b] - place_[a]) &&
          !solids.is_clear(place_[a], place_[b], room))
        continue;
      joined_[a] |= 1U << k, joined_[b] |= 1U << (25 - k);
    }
  }
}

void FreeCells::find_parts() {
  part_.assign(grid_.size(), kNoPart);
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < part_.size(); ++first) {
    if (room_[first] == 0.0 || part_[first] != kNoPart) continue;
    part_[first] = first;
    open.assign(1, first);
    while (!open.empty()) {
      const std::uint32_t cell = open.back();
      open.pop_back();
      for_each_joined(cell, [&](std::uint32_t next) {
        if (part_[next] != kNoPart) return;
        part_[next] = first;
        open.push_back(next);
      });
    }
  }
}

}  // namespace avo::space
