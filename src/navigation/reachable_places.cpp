// SPDX-License-Identifier: Apache-2.0
#include "navigation/reachable_places.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/hash.h"
#include "navigation/wall_boundary.h"

namespace avo::inline navigation {
namespace {

constexpr double kOff = 1e-6;   // of the radius: additional distance from walls
constexpr double kTie = 1e-7;   // of the radius: places with this difference count as equally near
constexpr double kEdge = 1e-7;  // of a reach: a point nearer to a wall is no place of its boundary
constexpr double kCell = 4.0;   // radii: around a place, other places in its sight are known
// from the origin: the outermost cells contain everything beyond
constexpr double kMostCellsAway = 0x1p62;
constexpr std::size_t kMostKnown = 8;  // places in a cell

std::uint64_t cell_key(std::int64_t column, std::int64_t row) {
  return mixed(mixed(0, static_cast<std::uint64_t>(column)), static_cast<std::uint64_t>(row));
}

}  // namespace

ReachablePlaces::ReachablePlaces(std::span<const Wall> walls, double radius)
    : space_(walls, radius), boundaries_(walls.size()) {}

bool ReachablePlaces::are_connected(Vec2 p, Vec2 q) {
  if (!is_free(p) || !is_free(q)) return space_.are_connected(p, q);
  return region_of(p) == region_of(q);
}

// The region of a place in view near by, and otherwise the region with the same windings.
std::uint32_t ReachablePlaces::region_of(Vec2 p) {
  const double radius = space_.radius();
  const auto number = [radius](double x) {
    return static_cast<std::int64_t>(
        std::clamp(std::floor(x / (kCell * radius)), -kMostCellsAway, kMostCellsAway));
  };
  const std::int64_t column = number(p.x), row = number(p.y);
  for (std::int64_t x = column - 1; x <= column + 1; ++x) {
    for (std::int64_t y = row - 1; y <= row + 1; ++y) {
      const auto cell = known_.find(cell_key(x, y));
      if (cell == known_.end()) continue;
      for (const FreePlace& place : cell->second)
        if (space_.grid().is_clear(p, place.point, radius)) return place.region;
    }
  }
  std::vector<FreeSpace::Winding> windings = space_.windings(p);
  const auto known = std::find(regions_.begin(), regions_.end(), windings);
  const auto region = static_cast<std::uint32_t>(known - regions_.begin());
  if (known == regions_.end()) regions_.push_back(std::move(windings));
  std::vector<FreePlace>& own = known_[cell_key(column, row)];
  if (own.size() < kMostKnown) own.push_back({p, region});
  return region;
}

const ReachablePlaces::FreeBoundary& ReachablePlaces::boundary_of(std::uint32_t wall) {
  FreeBoundary& boundary = boundaries_[wall];
  if (boundary.is_known) return boundary;
  boundary.is_known = true;
  const double radius = (1.0 + kOff) * space_.radius();
  const std::span<const Wall> walls = space_.grid().walls();
  const WallBoundary own = boundary_around(walls[wall], radius);
  const auto add = [&](Vec2 point) {
    if (is_free(point)) boundary.places.push_back({point, region_of(point)});
  };
  visit_bends(own, add);
  std::vector<std::uint32_t> near;
  space_.grid().all_near(walls[wall].a, walls[wall].b, [&](std::size_t k) {
    if (k != wall) near.push_back(static_cast<std::uint32_t>(k));
    return true;
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::uint32_t k : near) {
    const WallBoundary other = boundary_around(walls[k], radius);
    visit_crossings(own, other, [&](Vec2 point) {
      const double reach = distance(point, own.wall);
      if (std::abs(reach - own.reach) <= kEdge * own.reach &&
          distance(point, other.wall) >= (1.0 - kEdge) * other.reach)
        add(point);
    });
  }
  for (const FreePlace& place : boundary.places) boundary.regions.push_back(place.region);
  std::sort(boundary.regions.begin(), boundary.regions.end());
  boundary.regions.erase(std::unique(boundary.regions.begin(), boundary.regions.end()),
                         boundary.regions.end());
  return boundary;
}

// Tests wall by wall, beginning with walls that may have the nearest place. Only places of the
// region count, if one is given.
template <typename Accepts>
std::optional<Vec2> ReachablePlaces::nearest_accepted(Vec2 from, Vec2 goal,
                                                      std::optional<std::uint32_t> region,
                                                      const Accepts& accepts) {
  const double radius = (1.0 + kOff) * space_.radius(), tie = kTie * space_.radius();
  const std::span<const Wall> walls = space_.grid().walls();
  // m, a lower bound of the distance to its boundary
  std::vector<std::pair<double, std::uint32_t>> open;
  open.reserve(walls.size());
  for (std::uint32_t k = 0; k < walls.size(); ++k) {
    const double reach = radius + walls[k].radius;
    open.emplace_back(std::abs(distance(goal, {walls[k].a, walls[k].b}) - reach), k);
  }
  std::make_heap(open.begin(), open.end(), std::greater<>());
  std::optional<Vec2> best;
  // m, to the goal; m, from the disc
  double least = std::numeric_limits<double>::infinity(), least_far = least;
  const auto consider = [&](Vec2 point, const auto& is_accepted) {
    const double away = norm(goal - point), far = norm(point - from);
    const bool is_nearer = away < least - tie || (away <= least + tie && far < least_far);
    if (is_nearer && is_accepted()) best = point, least = std::min(least, away), least_far = far;
  };
  while (!open.empty() && open.front().first <= least + tie) {
    const std::uint32_t wall = open.front().second;
    std::pop_heap(open.begin(), open.end(), std::greater<>());
    open.pop_back();
    const FreeBoundary& boundary = boundary_of(wall);
    const std::vector<std::uint32_t>& regions = boundary.regions;
    if (region && !std::binary_search(regions.begin(), regions.end(), *region)) continue;
    for (const FreePlace& place : boundary.places) {
      const bool is_there = !region || place.region == *region;
      consider(place.point, [&] { return is_there && accepts(place.point); });
    }
    visit_feet(boundary_around(walls[wall], radius), goal, from, [&](Vec2 point) {
      consider(point, [&] {
        return is_free(point) && (!region || region_of(point) == *region) && accepts(point);
      });
    });
  }
  return best;
}

// The nearest free place, with no middle line of a wall between.
std::optional<Vec2> ReachablePlaces::nearest_free(Vec2 from) {
  return nearest_accepted(from, from, std::nullopt, [&](Vec2 point) {
    return space_.grid().all_near(from, point, [&](std::size_t k) {
      const Wall& wall = space_.grid().walls()[k];
      return distance(Segment{wall.a, wall.b}, Segment{from, point}) > 0.0;
    });
  });
}

Vec2 ReachablePlaces::nearest_reached(Vec2 from, Vec2 goal) {
  if (is_free(goal) && are_connected(from, goal)) return goal;
  const std::optional<Vec2> start = is_free(from) ? from : nearest_free(from);
  if (!start) return from;
  const std::uint32_t region = region_of(*start);
  if (is_free(goal) && region_of(goal) == region) return goal;
  return nearest_accepted(*start, goal, region, [](Vec2) { return true; }).value_or(from);
}

}  // namespace avo::inline navigation
