// SPDX-License-Identifier: Apache-2.0
// The lanes of a search. Included into a namespace that has Pack, once per instruction set.

// Lanes are filled by so many places at a time: how many cells hold cannot be foreseen, and a
// processor that guesses wrong loses more than what it does for nothing.
template <typename Real>
constexpr std::size_t kTogether = Real::kLanes >= 4 ? 16 : Real::kLanes;

/// Appends those of the points at [first, first + kTogether) that lie before `last` and the limit
/// admits to the candidates, which end there then. kThinned: the limit is that of somebody found.
template <bool kThinned, typename Real>
AVO_KERNEL std::size_t append_candidates(const NeighborQuery& query, const PlacedPoints& points,
                                         const HitLimit& limit, std::size_t first, std::size_t last,
                                         std::size_t end, SearchScratch& scratch) {
  const Real x(query.position.x), y(query.position.y), self(query.self);
  const Real nearest(limit.distance_squared), lowest(limit.index);
  const Real beyond(static_cast<double>(last)), lane = Real::load(kLaneNumbers.data());
  for (std::size_t k = first; k < first + kTogether<Real>; k += Real::kLanes) {
    const Real dx = Real::load(points.x + k) - x, dy = Real::load(points.y + k) - y;
    const Real distance_squared = dx * dx + dy * dy, index = Real::load(points.index + k);
    const Real place = Real(static_cast<double>(k)) + lane;
    auto chosen = (distance_squared <= nearest) & (index != self) & (place < beyond);
    if constexpr (kThinned) chosen = chosen & ((distance_squared < nearest) | (index < lowest));
    store_chosen(chosen, distance_squared, scratch.distance_squared.data() + end);
    end += store_chosen(chosen, place, scratch.place.data() + end);
  }
  return end;
}

/// All candidates within the radius behind those of the others, in no order. Returns where they
/// end.
template <typename Real>
AVO_KERNEL std::size_t collect(const NeighborQuery& query, double radius,
                               const PlacedPoints& points, std::size_t begin,
                               SearchScratch& scratch) {
  const CellRange range = cells_within(query.position, radius, points.cells);
  HitLimit limit{radius * radius};
  std::size_t end = begin, many = more_than(query.most, kManyHits);
  bool thinned = false;
  const auto look = [&](std::size_t first_slot, std::size_t last_slot) {
    const std::size_t last = points.begin[last_slot];
    for (std::size_t place = points.begin[first_slot]; place < last; place += kTogether<Real>) {
      scratch.reserve(end + kTogether<Real>);
      end = thinned
                ? append_candidates<true, Real>(query, points, limit, place, last, end, scratch)
                : append_candidates<false, Real>(query, points, limit, place, last, end, scratch);
      if (end - begin < many) continue;
      end = keep_nearest(query, points, begin, end, limit, scratch);
      thinned = true;
      many = 2 * (end - begin) + kManyHits;
    }
  };
  for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
    const std::size_t first = points.cells.slot(range.first_column, row);
    const std::size_t last = first + range.columns;
    look(first, std::min(last, points.cells.table()));
    if (last > points.cells.table()) look(0, last - points.cells.table());
  }
  if (end - begin > more_than(query.most, kManyHits / 4)) {
    end = keep_nearest(query, points, begin, end, limit, scratch);
  }
  return end;
}

/// How many candidates are near.
template <typename Real>
AVO_KERNEL std::size_t count_near(double near, const Found& found, const SearchScratch& scratch) {
  if (near < 0.0) return 0;
  const Real near_squared(near * near);
  std::size_t count = 0;
  for (std::size_t k = 0; k < found.candidates; k += Real::kLanes) {
    const Real distance = Real::load(scratch.distance_squared.data() + found.first + k);
    count += static_cast<std::size_t>(std::popcount(bits(distance <= near_squared)));
  }
  return std::min(count, found.candidates);  // of those beyond, if near is infinite
}

/// The ranks of few candidates by distance, where single precision tells all of them apart; false
/// elsewhere. Columns end in infinite distances.
template <typename Real>
AVO_KERNEL bool rank_candidates(const Found& found, SearchScratch& scratch) {
  const float* const distances = scratch.narrow.data() + found.first;
  const std::size_t count = found.candidates;
  const Real one(1.0), zero(0.0);
  Real sum(0.0);
  std::size_t k = 0;
  alignas(64) float ranks[Real::kLanes] = {};
  for (; k < count; k += Real::kLanes) {
    const Real mine = Real::load(distances + k);
    const auto before = [&](std::size_t j) {
      return select(Real(static_cast<double>(distances[j])) < mine, one, zero);
    };
    Real rank(0.0);
    for (std::size_t j = 0; j < count; j += 4) {
      rank = rank + ((before(j) + before(j + 1)) + (before(j + 2) + before(j + 3)));
    }
    rank.store(ranks);
    for (std::size_t lane = 0; lane < Real::kLanes; ++lane) {
      scratch.rank[found.first + k + lane] =
          static_cast<std::uint32_t>(static_cast<std::int32_t>(ranks[lane]));
    }
    sum = sum + rank;
  }
  // all ranks there are, and `count` of each beyond
  const std::size_t all = (count * count - count) / 2 + count * (k - count);
  return sum_of(sum) == static_cast<float>(all);
}

/// Returns how many queries were answered. Each step is made for all of them before the next one:
/// none waits for what its own last step has put in memory.
template <typename Real, typename Narrow>
std::size_t find_candidates(const PlacedPoints& points, std::size_t enough,
                            SearchScratch& scratch) {
  std::size_t answered = 0;
  for (; answered < scratch.queries.size() && (answered == 0 || scratch.used < enough);
       ++answered) {
    const NeighborQuery& query = scratch.queries[answered];
    const std::size_t first = scratch.used;
    double radius = query.guess;
    std::size_t end = collect<Real>(query, radius, points, first, scratch);
    while (end - first < query.most && radius < query.far) {
      radius = std::min(2.0 * radius, query.far);
      end = collect<Real>(query, radius, points, first, scratch);
    }
    scratch.found[answered] = {first, end - first, 0};
    scratch.reserve(end);
    std::fill_n(scratch.distance_squared.data() + end, kSparePoints,
                std::numeric_limits<double>::infinity());
    scratch.used = end + kSparePoints;
  }
  for (std::size_t k = 0; k < scratch.used; ++k) {
    scratch.narrow[k] = static_cast<float>(scratch.distance_squared[k]);
  }
  for (std::size_t i = 0; i < answered; ++i) {
    const NeighborQuery& query = scratch.queries[i];
    Found& found = scratch.found[i];
    found.count = std::max(std::min(found.candidates, query.most),
                           count_near<Real>(query.near, found, scratch));
    if (found.candidates > kFewHits || !rank_candidates<Narrow>(found, scratch)) {
      rank_by_sorting(found, points, scratch);
    }
  }
  return answered;
}
