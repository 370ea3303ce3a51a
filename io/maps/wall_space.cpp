// SPDX-License-Identifier: Apache-2.0
// Cells and strips are so large that all their lists together are only a few times as long as the
// list of walls.
#include "io/maps/wall_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo_io {

using avo::Fill;
using avo::Vec2;
using avo::Wall;

namespace {

// A center must keep off walls by this relative margin more than required, and cells list walls
// that are farther away by it.
constexpr double kWallMargin = 1e-9;

double distance(Vec2 p, const Wall& wall) {
  const Vec2 d = wall.b - wall.a;
  const double along = dot(p - wall.a, d), square = dot(d, d);
  if (!(along > 0.0)) return norm(p - wall.a);
  if (!(along < square)) return norm(p - wall.b);
  return norm(p - wall.a - (along / square) * d);
}

/// Collects the items that visit_all passes with their list, in its order within each of `count`
/// lists.
template <class VisitAll>
Lists sorted_into(std::size_t count, const VisitAll& visit_all) {
  Lists lists;
  lists.begin.resize(count + 1);
  visit_all([&](std::size_t list, std::uint32_t) { ++lists.begin[list + 1]; });
  for (std::size_t i = 0; i < count; ++i) lists.begin[i + 1] += lists.begin[i];
  lists.items.resize(lists.begin[count]);
  std::vector<std::size_t> next = lists.begin;
  visit_all([&](std::size_t list, std::uint32_t item) { lists.items[next[list]++] = item; });
  return lists;
}

std::span<const std::uint32_t> list_of(const Lists& lists, std::size_t i) {
  return std::span(lists.items).subspan(lists.begin[i], lists.begin[i + 1] - lists.begin[i]);
}

}  // namespace

NearWalls::NearWalls(std::span<const avo::StaticObstacle> obstacles, double reach)
    : reach_(reach * (1.0 + kWallMargin)), walls_(avo::walls_of(obstacles)) {
  if (walls_.empty()) return;
  const double infinity = std::numeric_limits<double>::infinity();
  min_ = {infinity, infinity};
  max_ = {-infinity, -infinity};
  double lengths = 0.0;  // m, of all walls with the margin around them
  for (const Wall& wall : walls_) {
    const double beyond = wall.radius + reach_;
    lengths += norm(wall.b - wall.a) + 2.0 * beyond;
    for (const Vec2 end : {wall.a, wall.b}) {
      min_ = {std::min(min_.x, end.x - beyond), std::min(min_.y, end.y - beyond)};
      max_ = {std::max(max_.x, end.x + beyond), std::max(max_.y, end.y + beyond)};
    }
  }
  const double most = 4.0 * static_cast<double>(walls_.size()) + 64.0;
  const Vec2 size = max_ - min_;
  constexpr double kSmallest = 1e-300;  // m
  side_ = std::max(
      {lengths / static_cast<double>(walls_.size()), std::max(size.x, size.y) / most, kSmallest});
  const auto along = [&](double length) { return std::floor(length / side_) + 1.0; };
  while (along(size.x) * along(size.y) > most) side_ *= 1.25;
  columns_ = static_cast<std::int64_t>(along(size.x));
  rows_ = static_cast<std::int64_t>(along(size.y));
  near_ = sorted_into(static_cast<std::size_t>(columns_ * rows_), [&](const auto& put) {
    for (std::uint32_t i = 0; i < walls_.size(); ++i)
      visit_cells(walls_[i], [&](std::size_t cell) { put(cell, i); });
  });
}

std::int64_t NearWalls::column(double x) const {
  return static_cast<std::int64_t>(
      std::clamp((x - min_.x) / side_, 0.0, static_cast<double>(columns_ - 1)));
}

std::int64_t NearWalls::row(double y) const {
  return static_cast<std::int64_t>(
      std::clamp((y - min_.y) / side_, 0.0, static_cast<double>(rows_ - 1)));
}

// Visits, column by column, the rows near the part of the wall that is near the column.
template <class Visit>
void NearWalls::visit_cells(const Wall& wall, const Visit& visit) const {
  const Vec2 a = wall.a.x <= wall.b.x ? wall.a : wall.b;
  const Vec2 b = wall.a.x <= wall.b.x ? wall.b : wall.a;
  const double beyond = (wall.radius + reach_) * (1.0 + kWallMargin) + kWallMargin * side_;
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0.0;
  const std::int64_t last = column(b.x + beyond);
  for (std::int64_t x = column(a.x - beyond); x <= last; ++x) {
    const double left = min_.x + static_cast<double>(x) * side_ - beyond;
    const double right = left + side_ + 2.0 * beyond;
    const bool flat = b.x > a.x;
    const double from = flat && left > a.x ? a.y + (std::min(left, b.x) - a.x) * slope : a.y;
    const double to = flat && right < b.x ? a.y + (std::max(right, a.x) - a.x) * slope : b.y;
    const std::int64_t top = row(std::max(from, to) + beyond);
    for (std::int64_t y = row(std::min(from, to) - beyond); y <= top; ++y)
      visit(static_cast<std::size_t>(y * columns_ + x));
  }
}

bool NearWalls::is_clear(Vec2 center) const {
  const bool near = !walls_.empty() && center.x >= min_.x && center.x <= max_.x &&
                    center.y >= min_.y && center.y <= max_.y;
  if (!near) return true;
  const auto cell = static_cast<std::size_t>(row(center.y) * columns_ + column(center.x));
  const auto candidates = list_of(near_, cell);
  return std::none_of(candidates.begin(), candidates.end(), [&](std::uint32_t i) {
    return distance(center, walls_[i]) < reach_ + walls_[i].radius;
  });
}

Regions::Regions(std::span<const avo::StaticObstacle> obstacles) {
  for (const avo::StaticObstacle& obstacle : obstacles)
    if (obstacle.fill != Fill::none) add(obstacle);
  if (edges_.empty()) return;
  double top = edges_[0].a.y, heights = 0.0;
  bottom_ = top;
  for (const Edge& edge : edges_) {
    bottom_ = std::min({bottom_, edge.a.y, edge.b.y});
    top = std::max({top, edge.a.y, edge.b.y});
    heights += std::abs(edge.b.y - edge.a.y);
  }
  if (!(top > bottom_)) {
    edges_.clear();  // no point is inside
    return;
  }
  // edges lie in four strips each, on the average
  const auto count = static_cast<double>(edges_.size());
  const double strips = std::clamp(4.0 * count * (top - bottom_) / heights, 1.0, count);
  strips_ = static_cast<std::size_t>(strips);
  height_ = (top - bottom_) / static_cast<double>(strips_);
  across_ = sorted_into(strips_, [&](const auto& put) {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const auto [low, high] = std::minmax(edges_[i].a.y, edges_[i].b.y);
      const auto last = static_cast<std::size_t>(strip(high));
      for (auto k = static_cast<std::size_t>(strip(low)); k <= last; ++k) put(k, i);
    }
  });
}

void Regions::add(const avo::StaticObstacle& obstacle) {
  const auto region = static_cast<std::uint32_t>(fills_.size());
  fills_.push_back(obstacle.fill);
  bounds_ += obstacle.fill == Fill::bounds ? 1 : 0;
  for (const avo::Chain& chain : obstacle.chains) {
    const std::vector<Vec2>& points = chain.points;
    for (std::size_t k = 0; chain.closed && k < points.size(); ++k)
      edges_.push_back({points[k], points[(k + 1) % points.size()], region});
  }
}

double Regions::strip(double y) const {
  return std::clamp((y - bottom_) / height_, 0.0, static_cast<double>(strips_ - 1));
}

bool Regions::allow(Vec2 point) const {
  std::size_t inside_bounds = 0;
  if (!edges_.empty()) {
    const auto edges = list_of(across_, static_cast<std::size_t>(strip(point.y)));
    for (std::size_t i = 0; i < edges.size();) {
      const std::uint32_t region = edges_[edges[i]].region;
      bool inside = false;
      for (; i < edges.size() && edges_[edges[i]].region == region; ++i) {
        const auto& [a, b, same] = edges_[edges[i]];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        const double side = cross(b - a, point - a);  // > 0: to the left of the edge
        if ((b.y > a.y) == (side > 0.0)) inside = !inside;
      }
      if (inside && fills_[region] == Fill::solid) return false;
      inside_bounds += inside ? 1 : 0;
    }
  }
  return inside_bounds == bounds_;
}

}  // namespace avo_io
