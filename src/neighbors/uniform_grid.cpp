// SPDX-License-Identifier: Apache-2.0
// The grid search: contiguous runs of cells, exact distances (paper §VI-A).
#include "neighbors/uniform_grid.h"

#include <algorithm>
#include <numeric>

#include "neighbors/nearest.h"

namespace avo {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTiniest = 0x1p-511;  // squares of smaller distances underflow

// Hits are thinned out when there are so many beyond those kept last.
constexpr std::size_t kManyHits = 64;
// Of the far radius: no search begins with less.
constexpr double kLeastGuess = 0.0625;
// Places that are looked at between two times of asking that.
constexpr std::size_t kBlock = 256;

// A radius whose square overflows is infinite.
double searchable(double radius) {
  return radius * radius < kInfinity ? radius : kInfinity;
}

// A cell side for radius 0, where any side is right: about one cell per point of a line.
double side_without_radius(std::span<const Vec2> positions) {
  double farthest = 0.0;
  for (Vec2 p : positions) {
    if (is_finite(p)) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  }
  return farthest > 0.0 ? farthest / static_cast<double>(positions.size()) : 1.0;
}

std::size_t more_than(std::size_t count, std::size_t more) {
  return count + std::min(more, std::numeric_limits<std::size_t>::max() - count);
}

double squared(double radius) {
  return radius < 0.0 ? -1.0 : radius * radius;
}

}  // namespace

void UniformGrid::build(std::span<const Vec2> positions, double radius) {
  radius_ = searchable(radius);
  prepare(make_cells(positions, radius > 0.0 ? radius_ : side_without_radius(positions)),
          positions.size());
  keys_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) keys_[i] = cells_.key(positions[i]);
  indices_.resize(positions.size());
  std::iota(indices_.begin(), indices_.end(), 0);
  build_part(keys_, positions, indices_, 0, 1);
}

void UniformGrid::prepare(const Cells& cells, std::size_t count) {
  cells_ = cells;
  sort_.resize(cells.table(), count);
  x_.resize(count);
  y_.resize(count);
  index_.resize(count);
}

SortedPart UniformGrid::build_part(std::span<const std::uint32_t> keys,
                                   std::span<const Vec2> positions, std::span<const int> indices,
                                   std::size_t part, std::size_t parts) {
  const SortedPart sorted = sort_part(keys, part, parts, sort_);
  for (std::size_t place = sorted.first; place < sorted.last; ++place) {
    const std::uint32_t i = sort_.order[place];
    x_[place] = positions[i].x;
    y_[place] = positions[i].y;
    index_[place] = indices[i];
  }
  return sorted;
}

void UniformGrid::forget_order() {
  std::iota(sort_.order.begin(), sort_.order.end(), 0U);
}

std::size_t UniformGrid::collect(const NeighborQuery& query, double radius,
                                 std::vector<NeighborHit>& buffer) const {
  // a distance within the radius as computed exceeds it by less than 4 ulp, or underflows
  const double reach = radius * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()) + kTiniest;
  const Vec2 p = query.position;
  const std::int64_t first_column = cells_.cell(p.x - reach), last_row = cells_.cell(p.y + reach);
  const auto columns = static_cast<std::size_t>(cells_.cell(p.x + reach) - first_column) + 1;
  const double near_squared = squared(query.near);
  HitLimit limit{radius * radius};
  std::size_t count = 0, many = more_than(query.most, kManyHits);

  const auto look = [&](std::size_t first, std::size_t last) {
    if (buffer.size() < count + (last - first)) buffer.resize(count + (last - first));
    NeighborHit* const hits = buffer.data();
    for (std::size_t place = first; place < last; ++place) {
      const double dx = x_[place] - p.x, dy = y_[place] - p.y;
      const double distance_squared = dx * dx + dy * dy;
      const int index = index_[place];
      hits[count] = {distance_squared, index, static_cast<std::uint32_t>(place)};
      const bool nearer = distance_squared < limit.distance_squared;
      const bool as_near = distance_squared == limit.distance_squared && index < limit.index;
      count += (nearer || as_near) && index != query.self ? 1 : 0;
    }
    if (count < many) return;
    count = keep_nearest(std::span(hits, count), query.most, near_squared, limit);
    many = 2 * count + kManyHits;
  };
  const auto look_at_slots = [&](std::size_t first, std::size_t last) {
    const std::size_t end = sort_.begin[last];
    for (std::size_t place = sort_.begin[first]; place < end; place += kBlock) {
      look(place, std::min(place + kBlock, end));
    }
  };
  for (std::int64_t row = cells_.cell(p.y - reach); row <= last_row; ++row) {
    const std::size_t first = cells_.slot(first_column, row), last = first + columns;
    look_at_slots(first, std::min(last, cells_.table()));
    if (last > cells_.table()) look_at_slots(0, last - cells_.table());
  }
  return count;
}

std::span<const NeighborHit> UniformGrid::find(const NeighborQuery& query,
                                               std::vector<NeighborHit>& buffer) const {
  if (!is_finite(query.position) || sort_.begin.empty()) return {};
  NeighborQuery asked = query;
  asked.far = searchable(query.far);
  asked.near = std::min(query.near, asked.far);
  double radius = std::min(std::max({asked.near, query.guess, kLeastGuess * asked.far}), asked.far);
  std::size_t count = collect(asked, radius, buffer);
  while (count < query.most && radius < asked.far) {
    radius = std::min(2.0 * radius, asked.far);
    count = collect(asked, radius, buffer);
  }
  const double near_squared = squared(asked.near);
  HitLimit limit;
  if (count > more_than(query.most, kManyHits / 4)) {
    count = keep_nearest(std::span(buffer.data(), count), query.most, near_squared, limit);
  }
  const std::span<NeighborHit> hits(buffer.data(), count);
  sort_hits(hits);
  std::size_t kept = std::min(count, query.most);
  while (kept < count && hits[kept].distance_squared <= near_squared) ++kept;
  return hits.first(kept);
}

void UniformGrid::gather(Vec2 position, int self, std::size_t most,
                         std::vector<NeighborHit>& out) const {
  out.resize(find({position, self, most, -1.0, radius_, radius_}, out).size());
}

}  // namespace avo
