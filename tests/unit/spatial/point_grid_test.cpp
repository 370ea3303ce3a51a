// SPDX-License-Identifier: Apache-2.0
// P14: the grid finds what comparing all pairs finds, in canonical order, whatever the positions.
#include "spatial/point_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double a, double b) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return a + (b - a) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }
  int below(int n) { return static_cast<int>(uniform(0.0, n)); }

 private:
  std::uint64_t state_;
};

std::vector<NeighborHit> all_pairs(const std::vector<Vec2>& positions, double radius, Vec2 position,
                                   int self, std::size_t most) {
  std::vector<NeighborHit> hits;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (static_cast<int>(i) == self || !is_finite(positions[i]) || !is_finite(position)) continue;
    const double dx = positions[i].x - position.x, dy = positions[i].y - position.y;
    if (dx * dx + dy * dy <= radius * radius) {
      hits.push_back({dx * dx + dy * dy, static_cast<int>(i)});
    }
  }
  std::stable_sort(hits.begin(), hits.end(), [](const NeighborHit& a, const NeighborHit& b) {
    return a.distance_squared < b.distance_squared;
  });
  if (hits.size() > most) hits.resize(most);
  return hits;
}

std::vector<NeighborHit> gather(const PointGrid& grid, Vec2 position, int self,
                                std::size_t most = kAll) {
  SearchScratch scratch;
  const std::span<const NeighborHit> hits = grid.gather(position, self, most, scratch);
  return {hits.begin(), hits.end()};
}

// Compares from every position and from places around; returns the number of hits.
std::size_t compare(const std::vector<Vec2>& positions, double radius, std::uint64_t seed) {
  PointGrid grid;
  grid.build(positions, radius);
  Random random(seed);
  std::size_t found = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto self = static_cast<int>(i);
    const std::size_t most = random.below(2) ? kAll : static_cast<std::size_t>(random.below(12));
    const auto hits = gather(grid, positions[i], self, most);
    EXPECT_EQ(hits, all_pairs(positions, radius, positions[i], self, most)) << "around " << i;
    found += hits.size();
    const double shift = std::isfinite(radius) ? radius : 1.0;
    const Vec2 place =
        positions[i] + Vec2{shift * random.uniform(-2, 2), shift * random.uniform(-2, 2)};
    EXPECT_EQ(gather(grid, place, -1), all_pairs(positions, radius, place, -1, kAll));
    if (testing::Test::HasFailure()) break;
  }
  return found;
}

struct World {
  const char* name;
  std::function<Vec2(Random&, int)> place;
  double radius;
};

std::ostream& operator<<(std::ostream& out, const World& world) {
  return out << world.name;
}

const World kWorlds[] = {
    {"dense",
     [](Random& r, int) {
       return Vec2{r.uniform(-20, 20), r.uniform(-20, 20)};
     },
     5.0},
    {"sparse",
     [](Random& r, int) {
       return Vec2{r.uniform(-1e4, 1e4), r.uniform(-1e4, 1e4)};
     },
     300.0},
    {"line_x",
     [](Random& r, int) {
       return Vec2{r.uniform(-500, 500), 0.25};
     },
     2.0},
    {"line_y",
     [](Random& r, int) {
       return Vec2{-3.0, r.uniform(-500, 500)};
     },
     2.0},
    {"circle",
     [](Random&, int i) {
       return Vec2{400 * std::cos(0.01 * i), 400 * std::sin(0.01 * i)};
     },
     15.0},
    // distances equal to the radius, points on the edges of cells, ties
    {"lattice",
     [](Random& r, int) {
       return Vec2{static_cast<double>(r.below(20) - 10), static_cast<double>(r.below(20) - 10)};
     },
     2.0},
    {"lattice_off",
     [](Random& r, int) {
       return Vec2{0.1 * r.below(30), 1e7 + 0.1 * r.below(30)};
     },
     0.3},
    {"two_clusters",
     [](Random& r, int i) {
       return Vec2{r.uniform(0, 9) + (i % 2) * 1e12, r.uniform(0, 9) - (i % 2) * 1e12};
     },
     3.0},
    {"tiny",
     [](Random& r, int) {
       return Vec2{r.uniform(-1e-6, 1e-6), r.uniform(-1e-6, 1e-6)};
     },
     2e-7},
    {"huge",
     [](Random& r, int) {
       return Vec2{r.uniform(-1e153, 1e153), r.uniform(-1, 1)};
     },
     1e151},
    {"squares_overflow",
     [](Random& r, int) {
       return Vec2{r.uniform(-1e300, 1e300), 0.0};
     },
     1e200},
    {"squares_underflow",
     [](Random& r, int) {
       return Vec2{r.uniform(-1e-161, 1e-161), 0.0};
     },
     2e-162},
    {"radius_0",
     [](Random& r, int) {
       return Vec2{1.0 * r.below(9), 1e5 * r.below(9)};
     },
     0.0},
    {"radius_infinite",
     [](Random& r, int) {
       return Vec2{r.uniform(-9, 9), r.uniform(-9, 9)};
     },
     kInfinity},
    {"radius_denormal",
     [](Random& r, int) {
       return Vec2{5e-324 * r.below(4), 0.0};
     },
     5e-324},
};

class Worlds : public testing::TestWithParam<World> {};
INSTANTIATE_TEST_SUITE_P(All, Worlds, testing::ValuesIn(kWorlds),
                         [](const auto& world) { return std::string(world.param.name); });

TEST_P(Worlds, P14_agrees_with_all_pairs) {
  for (const int n : {1, 2, 3, 10, 100, 1000}) {
    Random random(static_cast<std::uint64_t>(n));
    std::vector<Vec2> positions;
    positions.reserve(1000);
    for (int i = 0; i < n; ++i) positions.push_back(GetParam().place(random, i));
    const std::size_t found = compare(positions, GetParam().radius, 17);
    if (n == 1000) {
      EXPECT_GT(found, 100u);
    }
    if (HasFailure()) FAIL() << n;
  }
}

TEST(PointGrid, empty_world) {
  PointGrid grid;
  EXPECT_TRUE(gather(grid, {0, 0}, -1).empty());
  grid.build({}, 15.0);
  EXPECT_TRUE(gather(grid, {0, 0}, -1).empty());
}

TEST(PointGrid, the_radius_is_closed) {
  PointGrid grid;
  const std::vector<Vec2> positions{{0, 0}, {3, 4}, {-5, 0}, {0, std::nextafter(5.0, 6.0)}};
  grid.build(positions, 5.0);
  EXPECT_EQ(gather(grid, {0, 0}, 0), (std::vector<NeighborHit>{{25.0, 1}, {25.0, 2}}));
}

// 1 + 2^-53.5 is 1 as computed, but -2^-53.5 + 1 lies below 1, in the cell before.
TEST(PointGrid, a_distance_rounded_to_the_radius_is_within_it) {
  PointGrid grid;
  const std::vector<Vec2> positions{{-0x1.6ap-54, 0}, {1, 0}};
  ASSERT_EQ(positions[1].x - positions[0].x, 1.0);
  ASSERT_LT(positions[0].x + 1.0, 1.0);
  grid.build(positions, 1.0);
  EXPECT_EQ(gather(grid, positions[0], 0), (std::vector<NeighborHit>{{1.0, 1}}));
}

// Rounding doubles the reach of a search there: more rows and columns, none read twice.
TEST(PointGrid, positions_with_an_ulp_as_large_as_the_radius) {
  Random random(6);
  std::vector<Vec2> positions;
  positions.reserve(100);
  for (int i = 0; i < 100; ++i) {
    positions.push_back({1e16 + 2.0 * random.below(9), -1e16 - 2.0 * random.below(9)});
  }
  for (const double radius : {0.5, 1.0, 1.000001, 1.5, 2.0, 2.9, 3.1, 4.0}) {
    EXPECT_GT(compare(positions, radius, 5), 0u);
  }
}

TEST(PointGrid, squares_may_overflow_and_underflow) {
  const double edge = 0x1p-511;  // of two cells
  PointGrid grid;
  const std::vector<Vec2> close{{edge, 0}, {edge - 1.5e-162, 0}};
  grid.build(close, 2e-163);
  EXPECT_EQ(gather(grid, close[1], 1), (std::vector<NeighborHit>{{0.0, 0}}));
  const std::vector<Vec2> far{{0, 0}, {3.7e161, 0}};
  grid.build(far, 1e160);
  EXPECT_EQ(gather(grid, far[1], 1), (std::vector<NeighborHit>{{kInfinity, 0}}));
}

TEST(PointGrid, ties_are_settled_by_index) {
  PointGrid grid;
  const std::vector<Vec2> positions{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}};
  grid.build(positions, 1.5);
  EXPECT_EQ(gather(grid, {0, 0}, 4, 3), (std::vector<NeighborHit>{{1, 0}, {1, 1}, {1, 2}}));
}

TEST(PointGrid, positions_that_are_not_finite_are_nowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PointGrid grid;
  const std::vector<Vec2> positions{{nan, 0}, {0, 0}, {0, kInfinity}, {-kInfinity, nan}, {1, 0}};
  for (const double radius : {2.0, 0.0, kInfinity}) {
    grid.build(positions, radius);
    EXPECT_EQ(gather(grid, {0, 0}, 1).size(), radius > 0.0 ? 1u : 0u);
    EXPECT_TRUE(gather(grid, {nan, 0}, -1).empty());
    EXPECT_TRUE(gather(grid, {0, -kInfinity}, -1).empty());
  }
}

TEST(PointGrid, twenty_thousand_coincident_points) {
  const std::vector<Vec2> positions(20000, Vec2{0.1, -7.3});
  PointGrid grid;
  grid.build(positions, 1.0);
  const auto nearest = gather(grid, positions[0], 5, 10);
  ASSERT_EQ(nearest.size(), 10u);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(nearest[static_cast<std::size_t>(k)], (NeighborHit{0.0, k < 5 ? k : k + 1}));
  }
  EXPECT_EQ(gather(grid, positions[0], 5).size(), 19999u);
}

TEST(PointGrid, an_outlier_changes_nothing_for_the_others) {
  Random random(3);
  std::vector<Vec2> positions;
  positions.reserve(2001);
  for (int i = 0; i < 2000; ++i)
    positions.push_back({random.uniform(0, 99), random.uniform(0, 99)});
  PointGrid without, with;
  without.build(positions, 5.0);
  positions.push_back({1e7, -1e7});
  with.build(positions, 5.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 place = positions[static_cast<std::size_t>(i)];
    ASSERT_EQ(gather(with, place, i), gather(without, place, i));
  }
  EXPECT_EQ(gather(with, {1e7, -1e7}, -1), (std::vector<NeighborHit>{{0.0, 2000}}));
}

// P13, as far as it lies here: the same points are found whatever their order.
TEST(PointGrid, P13_insertion_order_renames_and_nothing_else) {
  Random random(4);
  std::vector<Vec2> positions;
  positions.reserve(500);
  for (int i = 0; i < 500; ++i) positions.push_back({random.uniform(0, 40), random.uniform(0, 40)});
  std::vector<Vec2> reversed(positions.rbegin(), positions.rend());
  PointGrid grid, mirror;
  grid.build(positions, 4.0);
  mirror.build(reversed, 4.0);
  for (int i = 0; i < 500; ++i) {
    const Vec2 place = positions[static_cast<std::size_t>(i)];
    const auto hits = gather(grid, place, i, 10);
    auto renamed = gather(mirror, place, 499 - i, 10);
    for (NeighborHit& hit : renamed) hit.index = 499 - hit.index;
    ASSERT_EQ(hits, renamed);
  }
}

TEST(PointGrid, building_again_forgets) {
  PointGrid grid;
  grid.build(std::vector<Vec2>(1000, Vec2{1, 1}), 3.0);
  grid.build(std::vector<Vec2>{{1, 1}, {2, 1}}, 0.5);
  EXPECT_EQ(gather(grid, {1, 1}, -1), (std::vector<NeighborHit>{{0.0, 0}}));
}

}  // namespace
}  // namespace avo
