// SPDX-License-Identifier: Apache-2.0
// The grid tells what looking at every wall tells.
#include "navigation/clearance_grid.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "unit/navigation/mazes.h"
#include "walls/segment.h"

namespace avo {
namespace {

TEST(ClearanceGrid, TellsWhatEveryWallTells) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Wall> walls = test::random_walls(40, 20.0, seed);
    const ClearanceGrid grid(walls, 1.0);
    test::Random random(seed + 100);
    int clear = 0;
    for (int k = 0; k < 2000; ++k) {
      const auto point = [&] {
        return Vec2{random.uniform(-5.0, 25.0), random.uniform(-5.0, 25.0)};
      };
      const Vec2 p = point(), q = k % 4 == 0 ? Vec2{p.x, point().y} : point();
      double nearest = 1.0, room = 1e9;
      for (const Wall& wall : walls) {
        nearest = std::min(nearest, distance(p, {wall.a, wall.b}) - wall.radius);
        room = std::min(room, distance({p, q}, {wall.a, wall.b}) - wall.radius);
      }
      EXPECT_EQ(grid.clearance(p), nearest);
      for (const double wanted : {0.0, 0.3, 1.0}) {
        if (std::abs(room - wanted) < 1e-12) continue;
        EXPECT_EQ(grid.is_clear(p, q, wanted), room >= wanted);
        clear += room >= wanted ? 1 : 0;
      }
    }
    EXPECT_GT(clear, 100);
    EXPECT_LT(clear, 5900);
  }
}

TEST(ClearanceGrid, HasNoWallsWhereThereAreNone) {
  const ClearanceGrid grid({}, 1.0);
  EXPECT_EQ(grid.clearance({3, 4}), 1.0);
  EXPECT_TRUE(grid.is_clear({0, 0}, {100, 100}, 1.0));
}

}  // namespace
}  // namespace avo
