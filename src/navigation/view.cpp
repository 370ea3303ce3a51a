// SPDX-License-Identifier: Apache-2.0
#include "navigation/view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace avo::inline navigation {
namespace {

constexpr std::size_t kInQuadrant = Horizons::kSectors / 4;
constexpr double kSlackOfSight = 1e-9;  // of a length, more than its rounding
constexpr double kSureRoom = 0.99;      // of the room: a place nearer to a wall is certainly hidden
constexpr double kItemsInCell = 16.0;

// From 0 along the first axis to 4, growing with the angle.
double turn_of(Vec2 d) {
  const double x = std::abs(d.x), y = std::abs(d.y);
  if (!(x + y > 0.0)) return 0.0;
  if (d.y >= 0.0) return d.x >= 0.0 ? y / (x + y) : 1.0 + x / (x + y);
  return d.x < 0.0 ? 2.0 + y / (x + y) : 3.0 + x / (x + y);
}

std::array<Vec2, Horizons::kSectors> all_borders() {
  std::array<Vec2, Horizons::kSectors> borders;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    const double part = static_cast<double>(k % kInQuadrant) / kInQuadrant;
    Vec2 d{1.0 - part, part};
    for (std::size_t turns = k / kInQuadrant; turns > 0; --turns) d = perpendicular(d);
    borders[k] = d / norm(d);
  }
  return borders;
}

// The side of the disc around an end, where it is widest as seen from the place; on the left or the
// right.
Vec2 side_of(Vec2 end, double reach, double side) {
  return end + (side * reach / norm(end)) * perpendicular(end);
}

}  // namespace

std::size_t Horizons::sector_of(Vec2 direction) {
  const auto sector = static_cast<std::size_t>(turn_of(direction) * kInQuadrant);
  return sector < kSectors ? sector : 0;
}

const std::array<Vec2, Horizons::kSectors>& Horizons::borders() {
  static const std::array<Vec2, kSectors> units = all_borders();
  return units;
}

std::array<float, Horizons::kParts> Horizons::reach() const {
  constexpr std::size_t kEach = kSectors / kParts;
  std::array<float, kParts> reach;
  for (std::size_t k = 0; k < kParts; ++k) {
    const double farthest = *std::max_element(&far_[k * kEach], &far_[k * kEach] + kEach);
    reach[k] = std::nextafter(static_cast<float>(farthest), std::numeric_limits<float>::infinity());
  }
  return reach;
}

bool reaches(const std::array<float, Horizons::kParts>& reach, Vec2 place, Vec2 center,
             double radius) {
  constexpr std::size_t kEach = Horizons::kSectors / Horizons::kParts;
  const Vec2 to = center - place;
  const double distance = norm(to);
  if (!(distance > radius)) return true;
  const double side = radius * distance / std::sqrt(distance * distance - radius * radius);
  const std::size_t first = Horizons::sector_of(side_of(to, side, -1.0)) / kEach;
  std::size_t last = Horizons::sector_of(side_of(to, side, 1.0)) / kEach;
  if (last < first) last += Horizons::kParts;
  for (std::size_t k = first; k <= last; ++k)
    if (static_cast<double>(reach[k % Horizons::kParts]) >= distance - radius) return true;
  return false;
}

Horizons::Sectors sectors_of(Vec2 place, Vec2 center, double radius) {
  constexpr std::size_t kSectors = Horizons::kSectors;
  Horizons::Sectors sectors;
  const Vec2 to = center - place;
  const double distance = norm(to);
  if (!(distance > radius)) return sectors.set();
  const double side = radius * distance / std::sqrt(distance * distance - radius * radius);
  const std::size_t first = Horizons::sector_of(side_of(to, side, -1.0)) + kSectors - 1;
  std::size_t last = Horizons::sector_of(side_of(to, side, 1.0)) + kSectors + 1;
  if (last < first) last += kSectors;
  for (std::size_t k = first; k <= last; ++k) sectors.set(k % kSectors);
  return sectors;
}

// The segment between the outer sides of its ends lies within the wall and the room around it.
void Horizons::block(const Wall& wall) {
  Vec2 a = wall.a - place_, b = wall.b - place_;
  const double reach = wall.radius + kSureRoom * room_;
  if (!(norm_squared(a) > reach * reach) || !(norm_squared(b) > reach * reach)) return;
  if (cross(a, b) < 0.0) std::swap(a, b);
  a = side_of(a, reach, -1.0), b = side_of(b, reach, 1.0);
  const Vec2 along = b - a;
  const double twice_area = cross(a, along);
  if (!(twice_area > 0.0)) return;
  const double from = turn_of(a) * kInQuadrant;
  double to = turn_of(b) * kInQuadrant;
  if (to < from) to += kSectors;
  const auto first = static_cast<std::size_t>(std::ceil(from));
  const auto last = static_cast<std::size_t>(to);
  const std::array<Vec2, kSectors>& units = borders();
  double before = std::numeric_limits<double>::infinity();
  for (std::size_t k = first; k <= last; ++k) {
    const double sine = cross(units[k % kSectors], along);
    const double here = sine > 0.0 ? twice_area / sine : std::numeric_limits<double>::infinity();
    if (k > first) close((k - 1) % kSectors, (1.0 + kSlackOfSight) * std::max(before, here));
    before = here;
  }
}

bool Horizons::hides(Vec2 low, Vec2 high) const {
  const Vec2 nearest{std::clamp(place_.x, low.x, high.x), std::clamp(place_.y, low.y, high.y)};
  const double distance_squared = norm_squared(nearest - place_);
  if (!(distance_squared > 0.0)) return false;
  // the two corners between which it is seen
  const bool left = place_.x<low.x, right = place_.x> high.x;
  const bool below = place_.y<low.y, above = place_.y> high.y;
  const Vec2 from{above || (left && !below) ? low.x : high.x,
                  left || (below && !right) ? low.y : high.y};
  const Vec2 to{below || (left && !above) ? low.x : high.x,
                right || (below && !left) ? low.y : high.y};
  const Vec2 one = from - place_, other = to - place_;
  std::size_t first = sector_of(one), last = sector_of(other);
  if (cross(one, other) < 0.0) std::swap(first, last);
  if (last < first) last += kSectors;
  for (std::size_t k = first; k <= last; ++k) {
    if (square(far_[k % kSectors]) >= distance_squared) return false;
  }
  return true;
}

ViewIndex::ViewIndex(std::span<const Wall> walls, std::span<const Vec2> points)
    : walls_(walls.size()) {
  if (walls.empty()) return;
  std::vector<Wall> items(walls.begin(), walls.end());
  for (const Vec2 point : points) items.push_back({point, point});
  const std::vector<double> none(items.size(), 0.0);  // m, of their reach
  const double cells = static_cast<double>(items.size()) / kItemsInCell + 1.0;
  grid_ = SegmentGrid(items, none, {0.0, cells});
}

void ViewIndex::next_ring(Cell middle, std::int64_t away, bool is_inside,
                          const std::vector<Cell>& in_view, std::vector<Cell>& ring,
                          std::vector<char>& is_in_ring) const {
  ring.clear();
  is_in_ring.assign(static_cast<std::size_t>(8 * away), 0);
  const auto add = [&](std::int64_t column, std::int64_t row) {
    if (column < 0 || column >= grid_.columns() || row < 0 || row >= grid_.rows()) return;
    const std::int64_t right = column - middle.column, up = row - middle.row;
    std::int64_t place = right + away;  // around the ring: below, above, and else on both sides
    if (std::abs(up) == away)
      place += up > 0 ? 2 * away + 1 : 0;
    else if (std::abs(right) == away)
      place = 4 * away + 2 + 2 * (up + away - 1) + (right > 0 ? 1 : 0);
    else
      return;
    if (place < 0 || place >= 8 * away || is_in_ring[static_cast<std::size_t>(place)] != 0) return;
    is_in_ring[static_cast<std::size_t>(place)] = 1;
    ring.push_back({column, row});
  };
  if (is_inside) {
    for (const Cell cell : in_view)
      for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row)
        for (std::int64_t column = cell.column - 1; column <= cell.column + 1; ++column)
          add(column, row);
    return;
  }
  for (std::int64_t row = middle.row - away; row <= middle.row + away; ++row) {
    const bool is_edge = row == middle.row - away || row == middle.row + away;
    for (std::int64_t column = middle.column - away; column <= middle.column + away;
         column += is_edge ? 1 : 2 * away)
      add(column, row);
  }
}

}  // namespace avo::inline navigation
