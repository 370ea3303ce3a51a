// SPDX-License-Identifier: Apache-2.0
// The grid tells all segments that a test of each one finds.
#include "spatial/segment_grid.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <vector>

#include "support/generators.h"
#include "walls/segment.h"

namespace avo {
namespace {

using test::Random;

// Segments of any direction and length, some of them points, and a reach for each.
struct Segments {
  double side = 1.0;
  std::vector<Wall> walls;
  std::vector<double> reach;

  explicit Segments(std::uint64_t seed) {
    Random random(seed);
    side = random.log_uniform(1e-3, 1e6);
    for (int k = 0; k < 60; ++k) {
      const Vec2 a = place(random);
      const double length = random.below(4) == 0 ? 0.0 : random.log_uniform(1e-3, 2.0) * side;
      const Vec2 along = random.below(3) == 0 ? Vec2{0.0, 1.0} : random.direction();
      walls.push_back({a, a + length * along});
      reach.push_back(random.below(3) == 0 ? 0.0 : random.log_uniform(1e-3, 0.3) * side);
    }
  }
  // Beside them as well.
  [[nodiscard]] Vec2 place(Random& random) const {
    return {random.uniform(-0.5, 1.5) * side, random.uniform(-0.5, 1.5) * side};
  }
};

// For any size of the cells.
CellSize any_size(Random& random, double side) {
  return {random.below(2) == 0 ? 0.0 : random.log_uniform(1e-2, 1.0) * side,
          random.log_uniform(1.0, 1e4)};
}

template <typename Visit>
std::set<std::size_t> told(const Visit& visit) {
  std::set<std::size_t> numbers;
  visit([&numbers](std::size_t k) { return numbers.insert(k), true; });
  return numbers;
}

TEST(SegmentGrid, tells_all_that_reach_a_segment) {
  std::size_t near = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Segments segments(seed);
    Random random(seed + 100);
    const SegmentGrid grid(segments.walls, segments.reach, any_size(random, segments.side));
    for (int k = 0; k < 100; ++k) {
      const Vec2 p = segments.place(random), other = segments.place(random);
      const Vec2 q = k % 4 == 0 ? p : k % 4 == 1 ? Vec2{p.x, other.y} : other;
      const auto numbers = told([&](const auto& take) { grid.all_near(p, q, take); });
      near += numbers.size(), all += segments.walls.size();
      for (std::size_t i = 0; i < segments.walls.size(); ++i) {
        const Wall& wall = segments.walls[i];
        if (distance({p, q}, {wall.a, wall.b}) <= segments.reach[i]) {
          EXPECT_TRUE(numbers.contains(i)) << i;
        }
      }
      if (p == q) {
        EXPECT_GE(grid.count_near(p), numbers.size());
      }
    }
  }
  EXPECT_LT(near, all / 2) << "the cells are of no use";
}

TEST(SegmentGrid, tells_all_that_reach_a_box) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Segments segments(seed);
    Random random(seed + 200);
    const SegmentGrid grid(segments.walls, segments.reach, any_size(random, segments.side));
    for (int k = 0; k < 100; ++k) {
      const Vec2 one = segments.place(random), other = segments.place(random);
      const Vec2 low{std::min(one.x, other.x), std::min(one.y, other.y)};
      const Vec2 high{std::max(one.x, other.x), std::max(one.y, other.y)};
      const auto numbers = told([&](const auto& take) { grid.all_in(low, high, take); });
      for (std::size_t i = 0; i < segments.walls.size(); ++i) {
        const Wall& wall = segments.walls[i];
        const Vec2 end{std::clamp(wall.a.x, low.x, high.x), std::clamp(wall.a.y, low.y, high.y)};
        if (distance(end, {wall.a, wall.b}) <= segments.reach[i]) {
          EXPECT_TRUE(numbers.contains(i)) << i;
        }
      }
    }
  }
}

TEST(SegmentGrid, lists_each_number_once_in_ascending_order) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Segments segments(seed);
    Random random(seed + 300);
    const SegmentGrid grid(segments.walls, segments.reach, any_size(random, segments.side));
    std::size_t longest = 0, together = 0;
    for (std::int64_t row = 0; row < grid.rows(); ++row) {
      for (std::int64_t column = 0; column < grid.columns(); ++column) {
        const auto list = grid.list({column, row});
        EXPECT_EQ(std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()), list.end());
        longest = std::max(longest, list.size()), together += list.size();
      }
    }
    EXPECT_EQ(longest, grid.most_listed());
    EXPECT_EQ(together, grid.lists().size());
    for (int k = 0; k < 100; ++k) {
      const Vec2 p = segments.place(random);
      const auto list = grid.list_at(p);
      for (std::size_t i = 0; i < segments.walls.size(); ++i) {
        const Wall& wall = segments.walls[i];
        if (distance(p, {wall.a, wall.b}) <= segments.reach[i]) {
          EXPECT_TRUE(std::binary_search(list.begin(), list.end(), i)) << i;
        }
      }
      if (!grid.covers(p)) {
        EXPECT_TRUE(list.empty());
      }
      const SegmentGrid::Cell cell = grid.cell_of(p);
      const Vec2 low = grid.corner(cell), high = low + grid.side() * Vec2{1.0, 1.0};
      if (grid.covers(p) && !list.empty()) {
        EXPECT_EQ(list.data(), grid.list(cell).data());
        EXPECT_LE(norm(p - Vec2{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)}),
                  1e-9 * segments.side);
      }
    }
  }
}

// On borders of cells, and on the outermost one.
TEST(SegmentGrid, lists_a_point_without_reach_once) {
  std::vector<Wall> walls{{{0.0, 0.0}, {8.0, 8.0}}};
  for (double x = 0.0; x <= 8.0; x += 0.5)
    for (double y = 0.0; y <= 8.0; y += 0.5) walls.push_back({{x, y}, {x, y}});
  const std::vector<double> reach(walls.size(), 0.0);
  for (const double side : {1.0, 2.0, 8.0}) {
    const SegmentGrid grid(walls, reach, {side, 1e4});
    std::size_t points = 0;
    for (const std::uint32_t k : grid.lists()) points += k > 0 ? 1 : 0;
    EXPECT_EQ(points, walls.size() - 1);
    for (std::size_t k = 1; k < walls.size(); ++k) {
      const auto list = grid.list_at(walls[k].a);
      EXPECT_TRUE(std::binary_search(list.begin(), list.end(), k)) << k;
    }
  }
}

// However many cells are asked for.
TEST(SegmentGrid, takes_memory_in_proportion_to_the_segments) {
  std::vector<Wall> walls;
  for (int k = 0; k < 200; ++k) walls.push_back({{0.0, 0.1 * k}, {20.0, 20.0 - 0.1 * k}});
  const std::vector<double> reach(walls.size(), 30.0);
  const SegmentGrid grid(walls, reach, {0.0, 1e6});
  EXPECT_LE(grid.lists().size(), (std::size_t{1} << 22) + 64 * walls.size());
  EXPECT_EQ(grid.list_at({10.0, 10.0}).size(), walls.size());
}

TEST(SegmentGrid, has_nothing_where_there_is_nothing) {
  const auto none = [](const SegmentGrid& grid, Vec2 p) {
    return grid.list_at(p).empty() && grid.count_near(p) == 0 &&
           grid.all_near(p, {5.0, 6.0}, [](std::size_t) { return false; }) &&
           grid.all_in({5.0, 6.0}, {7.0, 8.0}, [](std::size_t) { return false; });
  };
  EXPECT_TRUE(none({}, {3.0, 4.0}));
  EXPECT_TRUE(none({{}, {}, {1.0, 10.0}}, {3.0, 4.0}));
  const std::vector<Wall> walls{{{0.0, 0.0}, {1.0, 0.0}}};
  const std::vector<double> reach{0.5};
  const SegmentGrid grid(walls, reach, {0.0, 10.0});
  EXPECT_TRUE(none(grid, {3.0, 4.0}));
  EXPECT_TRUE(grid.list_at({std::numeric_limits<double>::quiet_NaN(), 0.0}).empty());
  EXPECT_FALSE(grid.list_at({0.5, 0.0}).empty());
  EXPECT_FALSE(grid.all_near({-1e12, 0.0}, {1e12, 0.0}, [](std::size_t) { return false; }));
}

}  // namespace
}  // namespace avo
