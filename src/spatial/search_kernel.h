// SPDX-License-Identifier: Apache-2.0
// The lanes of a search (ARCHITECTURE.md, "One step").
#ifndef AVO_SPATIAL_SEARCH_KERNEL_H
#define AVO_SPATIAL_SEARCH_KERNEL_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/scalar.h"
#include "spatial/search_steps.h"

AVO_BEGIN_KERNELS

// So many places are tested together. The number of points in a cell cannot be predicted, and a
// mispredicted branch costs more than a few unused tests.
template <typename Real>
constexpr std::size_t kTogether = Real::kLanes >= 4 ? 16 : Real::kLanes;

// So many candidates are ranked by comparing all pairs, which takes less time with more lanes.
template <typename Narrow>
constexpr std::size_t kFewHits = std::max<std::size_t>(48, 11 * Narrow::kLanes);

/// Candidates during the collection, and the number of near ones.
struct Collected {
  std::size_t end, near;
};

/// The values that the points are compared with, in all lanes.
template <typename Real>
struct SearchBounds {
  Real x, y, self;       // m, m, index
  Real nearest, lowest;  // HitLimit
  Real near;             // m²

  AVO_KERNEL SearchBounds(const NeighborQuery& query, const HitLimit& limit)
      : x(query.position.x),
        y(query.position.y),
        self(query.self),
        nearest(limit.distance_squared),
        lowest(limit.index),
        near(squared(query.near)) {}
};

/// Appends the points at [first, first + kTogether) that come before `last` and are within the
/// bounds.
template <typename Real>
AVO_KERNEL void append_candidates(const SearchBounds<Real>& bounds, const PlacedPoints& points,
                                  std::size_t first, std::size_t last, SearchScratch& scratch,
                                  Collected& collected) {
  Real distances[kTogether<Real> / Real::kLanes];
  std::uint32_t chosen = 0, near_ones = 0;
  for (std::size_t i = 0; i < kTogether<Real>; i += Real::kLanes) {
    const std::size_t k = first + i;
    const Real dx = Real::load(points.x + k) - bounds.x, dy = Real::load(points.y + k) - bounds.y;
    const Real distance = dx * dx + dy * dy, index = Real::load(points.index + k);
    chosen |= bits((distance <= bounds.nearest) & (index != bounds.self) &
                   ((distance < bounds.nearest) | (index < bounds.lowest)))
              << i;
    near_ones |= bits(distance <= bounds.near) << i;
    distances[i / Real::kLanes] = distance;
  }
  if (last - first < kTogether<Real>) chosen &= (1U << (last - first)) - 1U;
  const std::size_t end = collected.end;
  collected.end += store_chosen(chosen, distances, static_cast<std::uint32_t>(first),
                                &scratch.distance_squared[end], &scratch.place[end]);
  collected.near += static_cast<std::size_t>(std::popcount(chosen & near_ones));
}

/// Appends all candidates within the radius after those of the others, in no order.
template <typename Real>
AVO_KERNEL Collected collect(const NeighborQuery& query, double radius, const PlacedPoints& points,
                             std::size_t begin, SearchScratch& scratch) {
  const CellRange range = cells_within(query.position, radius, points.cells);
  HitLimit limit{radius * radius};
  SearchBounds<Real> bounds(query, limit);
  Collected hits{begin, 0};
  const std::size_t many = many_beside(query.most);
  for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
    std::size_t slot = points.cells.slot(range.first_column, row), columns = range.columns;
    while (columns > 0) {  // twice where the row continues at the beginning of the table
      const std::size_t run = std::min(columns, points.cells.table() - slot);
      const std::size_t last = points.begin[slot + run];
      for (std::size_t place = points.begin[slot]; place < last; place += kTogether<Real>) {
        scratch.reserve(hits.end + kTogether<Real>);
        append_candidates(bounds, points, place, last, scratch, hits);
        if (hits.end - begin - hits.near < many) continue;
        hits.end = keep_nearest(query, points, begin, hits.end, limit, scratch);
        bounds = SearchBounds<Real>(query, limit);
      }
      columns -= run;
      slot = 0;
    }
  }
  return hits;
}

/// The ranks of few candidates, from distances padded with infinite ones. False where some are
/// equal.
template <typename Real>
AVO_KERNEL bool rank_candidates(const typename Real::Number* distances, std::size_t count,
                                std::uint32_t* ranks) {
  using Number = typename Real::Number;
  const Real one(1.0), zero(0.0);
  Real sum(0.0);
  std::size_t k = 0;
  alignas(64) Number lanes[Real::kLanes] = {};
  for (; k < count; k += Real::kLanes) {
    const Real mine = Real::load(distances + k);
    const auto before = [&](std::size_t j) {
      return select(Real(static_cast<double>(distances[j])) < mine, one, zero);
    };
    Real rank(0.0);
    for (std::size_t j = 0; j < count; j += 4) {
      rank = rank + ((before(j) + before(j + 1)) + (before(j + 2) + before(j + 3)));
    }
    rank.store(lanes);
    for (std::size_t lane = 0; lane < Real::kLanes; ++lane) {
      ranks[k + lane] = static_cast<std::uint32_t>(static_cast<std::int32_t>(lanes[lane]));
    }
    sum = sum + rank;
  }
  // all existing ranks, and `count` for each entry beyond
  const std::size_t all = (count * count - count) / 2 + count * (k - count);
  return sum_of(sum) == static_cast<Number>(all);
}

/// Puts the candidates in order: by distances in single precision where these distinguish all, in
/// double precision where those do, and by sorting otherwise.
template <typename Real, typename Narrow>
AVO_KERNEL void put_in_order(const NeighborQuery& query, const Found& hits,
                             const PlacedPoints& points, SearchScratch& scratch) {
  constexpr std::size_t kFew = kFewHits<Narrow>;
  const std::size_t count = hits.candidates;
  if (count > kFew) return sort_candidates(query, hits, points, scratch);
  std::uint32_t ranks[kFew + kSparePoints];
  if (!rank_candidates<Narrow>(scratch.distance_squared.data() + hits.first, count, ranks)) {
    alignas(64) double exact[kFew + kSparePoints];
    for (std::size_t k = 0; k < count; ++k) {
      exact[k] = exact_distance_squared(query, points, scratch, hits.first + k);
    }
    std::fill_n(exact + count, kSparePoints, std::numeric_limits<double>::infinity());
    if (!rank_candidates<Real>(exact, count, ranks)) {
      return sort_candidates(query, hits, points, scratch);
    }
  }
  const std::uint32_t* const place = scratch.place.data() + hits.first;
  std::uint32_t* const order = scratch.order.data() + hits.first;
  for (std::size_t k = 0; k < count; ++k) order[ranks[k]] = place[k];
}

/// Returns the number of answered queries. Each step is made for all of them before the next step:
/// none waits for the memory writes of its own last step.
template <typename Real, typename Narrow>
std::size_t find_candidates(const PlacedPoints& points, std::size_t enough,
                            SearchScratch& scratch) {
  std::size_t answered = 0;
  for (; answered < scratch.queries.size() && (answered == 0 || scratch.used < enough);
       ++answered) {
    const NeighborQuery& query = scratch.queries[answered];
    const std::size_t first = scratch.used;
    double radius = query.guess;
    Collected collected = collect<Real>(query, radius, points, first, scratch);
    while (collected.end - first < query.most && radius < query.far) {
      radius = std::min(2.0 * radius, query.far);
      collected = collect<Real>(query, radius, points, first, scratch);
    }
    const std::size_t candidates = collected.end - first;
    scratch.results[answered] = {first, candidates,
                                 std::max(std::min(candidates, query.most), collected.near)};
    scratch.reserve(collected.end);
    std::fill_n(scratch.distance_squared.data() + collected.end, kSparePoints,
                std::numeric_limits<float>::infinity());
    scratch.used = collected.end + kSparePoints;
  }
  for (std::size_t i = 0; i < answered; ++i) {
    put_in_order<Real, Narrow>(scratch.queries[i], scratch.results[i], points, scratch);
  }
  return answered;
}

AVO_END_KERNELS

#endif  // once per pass
