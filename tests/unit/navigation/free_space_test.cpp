// SPDX-License-Identifier: Apache-2.0
// Reachability at the exact radius, beside a flood over a fine grid.
#include "navigation/free_space.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "unit/navigation/mazes.h"
#include "walls/segment.h"

namespace avo {
namespace {

double clearance(const std::vector<Wall>& walls, Vec2 p) {
  double least = 1e9;
  for (const Wall& wall : walls)
    least = std::min(least, distance(p, {wall.a, wall.b}) - wall.radius);
  return least;
}

/// The places of a grid, and which of them steps between neighbors join, where every place of a
/// step keeps `room`.
struct Flood {
  int side;
  double step;
  Vec2 origin;
  std::vector<int> label;  // 0: not free

  Flood(const std::vector<Wall>& walls, double room, double extent, double cell)
      : side(static_cast<int>(extent / cell)), step(cell), origin{-2.0, -2.0} {
    label.assign(static_cast<std::size_t>(side * side), 0);
    std::vector<char> is_free(label.size());
    for (int k = 0; k < side * side; ++k) {
      is_free[static_cast<std::size_t>(k)] = clearance(walls, place(k)) >= room;
    }
    int labels = 0;
    std::vector<int> open;
    for (int k = 0; k < side * side; ++k) {
      if (is_free[static_cast<std::size_t>(k)] == 0 || label[static_cast<std::size_t>(k)] != 0)
        continue;
      label[static_cast<std::size_t>(k)] = ++labels;
      open.push_back(k);
      while (!open.empty()) {
        const int here = open.back(), x = here % side, y = here / side;
        open.pop_back();
        const auto visit = [&](int to_x, int to_y) {
          if (to_x < 0 || to_y < 0 || to_x >= side || to_y >= side) return;
          const auto there = static_cast<std::size_t>(to_y * side + to_x);
          if (is_free[there] == 0 || label[there] != 0) return;
          label[there] = labels;
          open.push_back(static_cast<int>(there));
        };
        visit(x + 1, y), visit(x - 1, y), visit(x, y + 1), visit(x, y - 1);
      }
    }
  }
  Vec2 place(int k) const { return origin + step * Vec2{1.0 * (k % side), 1.0 * (k / side)}; }
};

// Steps of a grid of places that keep half a step more than r never leave the free space. Steps of
// a grid of places that keep half a step less miss no route of the free space.
TEST(FreeSpace, IsConnectedWhereAFloodSaysSo) {
  constexpr double kRadius = 0.4, kStep = 0.1, kExtent = 14.0;
  int together = 0, apart = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Wall> walls = test::random_walls(45, 10.0, seed);
    const FreeSpace space(walls, kRadius);
    const Flood surely(walls, kRadius + 0.5 * kStep, kExtent, kStep);
    const Flood maybe(walls, kRadius - 0.75 * kStep, kExtent, kStep);
    test::Random random(seed);
    std::vector<int> places;
    while (places.size() < 60) {
      const int k = static_cast<int>(random.uniform(0.0, 0.999999) * surely.side * surely.side);
      if (surely.label[static_cast<std::size_t>(k)] != 0) places.push_back(k);
    }
    for (const int a : places) {
      for (const int b : places) {
        const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
        const bool connected = space.are_connected(surely.place(a), surely.place(b));
        if (surely.label[i] == surely.label[k]) {
          EXPECT_TRUE(connected) << seed;
          ++together;
        } else if (maybe.label[i] != maybe.label[k]) {
          EXPECT_FALSE(connected) << seed;
          ++apart;
        }
      }
    }
  }
  EXPECT_GT(together, 1000);
  EXPECT_GT(apart, 400);
}

TEST(FreeSpace, PassesDoorsThatAreWideEnough) {
  constexpr double kRadius = 0.5;
  for (const double more : {1e-3, 1e-6, 1e-9, 0.0}) {
    const FreeSpace space(test::two_rooms(2.0 * kRadius + more), kRadius);
    EXPECT_TRUE(space.are_connected({3, 3}, {17, 8})) << more;
    if (more > 0.0) {
      const FreeSpace tight(test::two_rooms(2.0 * kRadius - more), kRadius);
      EXPECT_FALSE(tight.are_connected({3, 3}, {17, 8})) << more;
      EXPECT_TRUE(tight.are_connected({3, 3}, {8, 8}));
    }
  }
}

TEST(FreeSpace, ThickWallsAndDiscsCloseDoorsSooner) {
  std::vector<Wall> walls = test::two_rooms(1.5);
  EXPECT_TRUE(FreeSpace(walls, 0.5).are_connected({3, 3}, {17, 8}));
  walls.push_back({{10.0, 5.0}, {10.0, 5.0}, 0.1});
  EXPECT_FALSE(FreeSpace(walls, 0.5).are_connected({3, 3}, {17, 8}));
  EXPECT_TRUE(FreeSpace(walls, 0.3).are_connected({3, 3}, {17, 8}));
}

TEST(FreeSpace, EveryPlaceOfAMazeIsReached) {
  const std::vector<Wall> walls = test::maze(10, 3.0, 5);
  const FreeSpace space(walls, 0.5);
  for (int k = 1; k < 100; ++k) {
    EXPECT_TRUE(space.are_connected({1.5, 1.5}, {1.5 + 3.0 * (k % 10), 1.5 + 3.0 * (k / 10)}));
  }
  EXPECT_FALSE(space.are_connected({1.5, 1.5}, {-3.0, 4.0}));
  EXPECT_FALSE(FreeSpace(walls, 1.501).are_connected({1.5, 1.5}, {28.5, 28.5}));
}

}  // namespace
}  // namespace avo
