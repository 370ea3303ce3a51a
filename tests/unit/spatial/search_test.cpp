// SPDX-License-Identifier: Apache-2.0
// Searches of two ranges: all within the near one, and of the far one the nearest.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "spatial/point_grid.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

// Points under names that are not their indices.
struct Points {
  std::vector<Vec2> positions;
  std::vector<int> names;
  PointGrid grid;
};

void build(Points& points, double side, Random& random) {
  points.names.resize(points.positions.size());
  std::iota(points.names.begin(), points.names.end(), 0);
  for (std::size_t i = points.names.size(); i > 1; --i) {
    std::swap(points.names[i - 1],
              points.names[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  const Cells cells = make_cells(points.positions, side);
  std::vector<std::uint32_t> keys;
  for (const Vec2 p : points.positions) keys.push_back(cells.key(p));
  points.grid.prepare(cells, points.positions.size());
  const std::size_t parts = 1 + static_cast<std::size_t>(random.below(3));
  for (std::size_t part = 0; part < parts; ++part) {
    points.grid.build_part(keys, points.positions, points.names, part, parts);
  }
}

std::vector<NeighborHit> by_comparing_all(const Points& points, const NeighborQuery& query) {
  std::vector<NeighborHit> hits;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const double distance_squared = norm_squared(points.positions[i] - query.position);
    if (distance_squared > query.far * query.far || points.names[i] == query.self) continue;
    hits.push_back({distance_squared, points.names[i]});
  }
  std::sort(hits.begin(), hits.end());
  std::size_t kept = std::min(hits.size(), query.most);
  while (query.near >= 0.0 && kept < hits.size() &&
         hits[kept].distance_squared <= query.near * query.near) {
    ++kept;
  }
  hits.resize(kept);
  return hits;
}

// Several at a time, as many as there is room for.
void compare(const Points& points, std::span<const NeighborQuery> queries, std::size_t enough) {
  SearchScratch scratch;
  while (!queries.empty()) {
    const std::size_t answered = points.grid.find(queries, enough, scratch);
    ASSERT_GE(answered, 1u);
    for (std::size_t i = 0; i < answered; ++i) {
      const NeighborQuery& query = queries[i];
      const std::span<const NeighborHit> hits = points.grid.list(i, scratch);
      for (const NeighborHit& hit : hits) {  // the place is where it is
        EXPECT_EQ(norm_squared(points.grid.position(hit.place) - query.position),
                  hit.distance_squared);
      }
      EXPECT_EQ((std::vector<NeighborHit>{hits.begin(), hits.end()}),
                by_comparing_all(points, query))
          << "most " << query.most << " near " << query.near << " guess " << query.guess;
    }
    queries = queries.subspan(answered);
  }
}

void compare(const Points& points, double far, Random& random) {
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  constexpr std::size_t kMost[] = {0, 1, 3, 10, 40, kAll};
  std::vector<NeighborQuery> queries;
  for (int k = 0; k < 200; ++k) {
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(points.names.size())));
    NeighborQuery query{points.positions[i], points.names[i], kMost[random.below(6)], -1.0, far};
    if (random.below(4) == 0) {
      query.self = -1;
      query.position = query.position + far * random.direction();
    }
    if (random.below(2) == 0) query.near = far * random.uniform(0.0, 1.2);
    if (random.below(2) == 0) query.guess = far * random.log_uniform(1e-3, 2.0);
    if (random.below(8) == 0) query.near = std::numeric_limits<double>::infinity();
    queries.push_back(query);
  }
  compare(points, queries, static_cast<std::size_t>(1 + random.below(4000)));
}

TEST(NeighborSearch, finds_what_comparing_all_finds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    Points points;
    const int count = 1 + random.below(900);
    const double extent = random.log_uniform(1.0, 400.0);
    const bool lattice = seed % 4 == 0;  // ties
    for (int k = 0; k < count; ++k) {
      Vec2 p{random.uniform(-extent, extent), random.uniform(-extent, extent)};
      if (lattice) p = {std::floor(p.x), std::floor(p.y)};
      if (seed % 5 == 0 && k % 50 == 0) p = 1e6 * p;  // outliers scatter the rows
      points.positions.push_back(p);
    }
    const double far = 15.0;
    build(points, far / random.uniform(1.0, kMostSides), random);
    compare(points, far, random);
  }
}

// What single precision cannot tell apart, or cannot hold.
TEST(NeighborSearch, distances_of_any_size) {
  for (const double scale : {1e-160, 1e-25, 1e-9, 1e19, 1e150}) {
    Random random(3);
    Points points;
    for (int k = 0; k < 300; ++k) {
      const Vec2 p{random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)};
      const double nudge = k % 3 == 0 ? 1.0 + 1e-12 * k : 1.0;
      points.positions.push_back(scale * nudge * Vec2{std::floor(p.x), std::floor(p.y)});
    }
    build(points, 15.0 * scale, random);
    compare(points, 15.0 * scale, random);
  }
}

TEST(NeighborSearch, all_in_one_place) {
  Random random(8);
  Points points;
  points.positions.assign(3000, Vec2{1.0, 2.0});
  build(points, 15.0, random);
  compare(points, 15.0, random);
}

}  // namespace
}  // namespace avo
