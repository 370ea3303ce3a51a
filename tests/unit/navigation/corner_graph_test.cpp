// SPDX-License-Identifier: Apache-2.0
// A graph that is made of an earlier one is the one that is made of nothing.
#include "navigation/corner_graph.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "support/walls.h"
#include "unit/navigation/mazes.h"

namespace avo {
namespace {

void expect_equal(const CornerGraph& a, const CornerGraph& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.room, b.room);
  EXPECT_EQ(a.first, b.first);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    ASSERT_EQ(a.edges[k].to, b.edges[k].to);
    ASSERT_EQ(a.edges[k].length, b.edges[k].length);
  }
}

Wall any_wall(test::Random& random, const std::vector<Wall>& walls, double side) {
  const Vec2 a = test::in_square(random, side);
  const Vec2 b = a + random.log_uniform(0.2, 8.0) * random.direction();
  if (walls.empty()) return {a, b};
  const auto k = static_cast<std::size_t>(random.below(static_cast<int>(walls.size())));
  switch (random.below(6)) {
    case 0:
      return {walls[k].b, b};  // joined
    case 1:
      return {walls[k].b, walls[k].a};  // the same once more
    case 2:
      return {a, a, 0.3};  // a disc
    case 3:
      return {a, walls[k].a, 0.1};  // thick
    case 4:
      return {walls[k].a, 2.0 * walls[k].b - walls[k].a};  // longer
    default:
      return {a, b};
  }
}

TEST(CornerGraph, isTheSameWhateverItWasMadeOf) {
  std::size_t most_edges = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const double radius = random.uniform(0.2, 0.6);
    std::vector<Wall> walls = seed % 3 == 0   ? test::maze(5, 3.0, seed)
                              : seed % 3 == 1 ? test::random_walls(30, 15.0, seed)
                                              : test::random_walls(random, 9.0, radius);
    CornerGraph graph = corner_graph(walls, radius);
    for (int edit = 0; edit < 25; ++edit) {
      const auto place = [&] {
        return walls.begin() + random.below(static_cast<int>(walls.size()) + 1);
      };
      for (int k = random.below(4); k > 0; --k) {
        const Wall wall = any_wall(random, walls, 15.0);
        walls.insert(random.below(2) == 0 ? walls.end() : place(), wall);
      }
      for (int k = random.below(4); k > 0 && !walls.empty(); --k) {
        const auto wall = place();
        if (wall != walls.end()) walls.erase(wall);
      }
      if (edit == 20) walls.clear();
      CornerGraph fresh = corner_graph(walls, radius);
      expect_equal(corner_graph(walls, radius, &graph), fresh);
      most_edges = std::max(most_edges, fresh.edges.size());
      if (HasFailure()) return;
      graph = std::move(fresh);
    }
  }
  EXPECT_GT(most_edges, 500u);
}

}  // namespace
}  // namespace avo
