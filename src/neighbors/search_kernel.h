// SPDX-License-Identifier: Apache-2.0
// The lanes of a search. Included into a namespace that has Pack, once per instruction set.

/// Appends the points at [first, last) that the limit admits; returns how many there are then.
template <typename Real>
std::size_t append_candidates(const Search& search, const PlacedPoints& points,
                              const HitLimit& limit, std::size_t first, std::size_t last,
                              std::size_t count, SearchScratch& scratch) {
  static constexpr double kLane[kMostSearchLanes] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Real x(search.position.x), y(search.position.y), self(search.self);
  const Real nearest(limit.distance_squared), lowest(limit.index);
  const Real end(static_cast<double>(last)), lane = Real::load(kLane);
  for (std::size_t k = first; k < last; k += Real::kLanes) {
    const Real dx = Real::load(points.x + k) - x, dy = Real::load(points.y + k) - y;
    const Real distance_squared = dx * dx + dy * dy, index = Real::load(points.index + k);
    const Real place = Real(static_cast<double>(k)) + lane;
    const auto chosen =
        ((distance_squared < nearest) | ((distance_squared <= nearest) & (index < lowest))) &
        ((index < self) | (index > self)) & (place < end);
    store_chosen(chosen, distance_squared, scratch.distance_squared.data() + count);
    count += store_chosen(chosen, place, scratch.place.data() + count);
  }
  return count;
}

/// The rank of each candidate by distance, those equally far by where they are.
template <typename Real>
void rank_candidates(std::size_t count, SearchScratch& scratch) {
  static constexpr double kLane[kMostSearchLanes] = {0, 1, 2, 3, 4, 5, 6, 7};
  const double* const distances = scratch.distance_squared.data();
  const Real one(1.0), zero(0.0), lane = Real::load(kLane);
  for (std::size_t k = 0; k < count; k += Real::kLanes) {
    const Real mine = Real::load(distances + k), number = Real(static_cast<double>(k)) + lane;
    const std::size_t end = std::min(k + Real::kLanes, count);
    Real rank(0.0);
    for (std::size_t j = 0; j < k; ++j) {
      rank = rank + select(Real(distances[j]) <= mine, one, zero);
    }
    for (std::size_t j = k; j < end; ++j) {
      const Real other(distances[j]);
      const auto before = (other <= mine) & (Real(static_cast<double>(j)) < number);
      rank = rank + select((other < mine) | before, one, zero);
    }
    for (std::size_t j = end; j < count; ++j) {
      rank = rank + select(Real(distances[j]) < mine, one, zero);
    }
    rank.store(scratch.rank.data() + k);
  }
}

/// All candidates of a search, in no order.
template <typename Real>
std::size_t collect(const Search& search, const PlacedPoints& points, SearchScratch& scratch) {
  const CellRange range = cells_within(search, points.cells);
  HitLimit limit{search.radius * search.radius};
  std::size_t count = 0, many = more_than(search.most, kManyHits);
  const auto look = [&](std::size_t first_slot, std::size_t last_slot) {
    const std::size_t end = points.begin[last_slot];
    for (std::size_t place = points.begin[first_slot]; place < end; place += kBlock) {
      const std::size_t last = std::min(place + kBlock, end);
      scratch.reserve(count + (last - place));
      count = append_candidates<Real>(search, points, limit, place, last, count, scratch);
      if (count < many) continue;
      count = keep_nearest(search, points, count, limit, scratch);
      many = 2 * count + kManyHits;
    }
  };
  for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
    const std::size_t first = points.cells.slot(range.first_column, row);
    const std::size_t last = first + range.columns;
    look(first, std::min(last, points.cells.table()));
    if (last > points.cells.table()) look(0, last - points.cells.table());
  }
  if (count > more_than(search.most, kManyHits / 4)) {
    count = keep_nearest(search, points, count, limit, scratch);
  }
  if (count <= kFewHits) rank_candidates<Real>(count, scratch);
  return count;
}
