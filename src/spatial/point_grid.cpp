// SPDX-License-Identifier: Apache-2.0
// The grid search: contiguous runs of cells, exact distances (paper §VI-A).
#include "spatial/point_grid.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/plane.h"

namespace avo::inline spatial {
namespace {
// Part of the far radius: no search begins with less.
constexpr double kLeastGuess = 0.0625;

// A radius counts as infinite if its square overflows.
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

}  // namespace

void PointGrid::build(std::span<const Vec2> positions, double radius) {
  // as many slots as make_cells() may ever choose: points that spread out allocate nothing
  constexpr std::size_t kMostSlotsOfFew = 1024;
  sort_.begin.reserve(std::bit_ceil(std::max(2 * positions.size(), kMostSlotsOfFew)) + 2);
  radius_ = searchable(radius);
  prepare(make_cells(positions, radius > 0.0 ? radius_ : side_without_radius(positions)),
          positions.size());
  keys_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) keys_[i] = cells_.key(positions[i]);
  indices_.resize(positions.size());
  std::iota(indices_.begin(), indices_.end(), 0);
  build_part(keys_, positions, indices_, 0, 1);
}

void PointGrid::prepare(const Cells& cells, std::size_t count) {
  cells_ = cells;
  sort_.resize(cells.table(), count);
  for (std::vector<double>* column : {&x_, &y_, &index_}) column->resize(count + kSparePoints);
}

SortedPart PointGrid::build_part(std::span<const std::uint32_t> keys,
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

void PointGrid::take(std::span<const std::uint32_t> points, std::span<const Vec2> positions,
                     std::span<const int> indices) {
  cells_ = {.per_meter = 0.0};
  sort_.begin.assign({0U, static_cast<std::uint32_t>(points.size())});
  sort_.order.assign(points.begin(), points.end());
  for (std::vector<double>* column : {&x_, &y_, &index_})
    column->resize(points.size() + kSparePoints);
  for (std::size_t place = 0; place < points.size(); ++place) {
    x_[place] = positions[place].x;
    y_[place] = positions[place].y;
    index_[place] = indices[place];
  }
}

void PointGrid::list_within(Vec2 center, double radius, std::vector<std::uint32_t>& places) const {
  std::size_t count = 0;
  const auto take = [&](std::size_t first, std::size_t last) {
    places.resize(count + last - first);
    for (std::size_t place = first; place < last; ++place) {
      places[count] =
          static_cast<std::uint32_t>(place);  // counts if it is near: no branch to predict
      count += norm_squared(position(place) - center) <= radius * radius ? 1 : 0;
    }
  };
  places.clear();
  const CellRange range = cells_within(center, radius, cells_);
  for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
    const std::size_t first = cells_.slot(range.first_column, row);
    const std::size_t end = std::min(first + range.columns, cells_.table());
    take(sort_.begin[first], sort_.begin[end]);
    take(sort_.begin[0], sort_.begin[first + range.columns - end]);  // around the table's end
  }
  places.resize(count);
}

void PointGrid::forget_order() {
  std::iota(sort_.order.begin(), sort_.order.end(), 0U);
}

std::size_t PointGrid::find(std::span<const NeighborQuery> queries, std::size_t enough,
                            SearchScratch& scratch) const {
  scratch.queries.assign(queries.begin(), queries.end());
  if (sort_.order.empty()) {
    scratch.results.assign(queries.size(), {});
    return queries.size();
  }
  for (NeighborQuery& query : scratch.queries) {
    if (!is_finite(query.position)) query = {{}, -1, 0};
    query.far = searchable(query.far);
    query.near = std::min(query.near, query.far);
    query.guess = std::min(std::max({query.near, query.guess, kLeastGuess * query.far}), query.far);
  }
  const PlacedPoints points{cells_, sort_.begin, x_.data(), y_.data(), index_.data()};
  return search_within(points, enough, scratch);
}

std::span<const NeighborHit> PointGrid::gather(Vec2 position, int self, std::size_t most,
                                               SearchScratch& scratch) const {
  const NeighborQuery query{position, self, most, -1.0, radius_, radius_};
  find({&query, 1}, 1, scratch);
  return list(0, scratch);
}

std::span<const NeighborHit> PointGrid::list(std::size_t query, SearchScratch& scratch) const {
  const Found& hits = scratch.results[query];
  scratch.hits.clear();
  for (std::size_t k = hits.first; k < hits.first + hits.count; ++k) {
    const std::uint32_t place = scratch.order[k];
    const Vec2 p = position(place) - scratch.queries[query].position;
    scratch.hits.push_back({norm_squared(p), index(place), place});
  }
  return scratch.hits;
}

}  // namespace avo::inline spatial
