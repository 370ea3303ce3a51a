// SPDX-License-Identifier: Apache-2.0
// The nearest place to a goal that cannot be reached, beside all places of a fine grid.
#include "navigation/reachable_places.h"

#include <gtest/gtest.h>

#include "avo/error.h"
#include "avo/reachability.h"
#include "unit/navigation/mazes.h"

namespace avo {
namespace {

// None of a grid that the disc gets to is nearer, and the place itself can be reached.
TEST(ReachablePlaces, none_that_the_disc_gets_to_is_nearer_to_the_goal) {
  constexpr double kRadius = 0.4, kStep = 0.1;
  int in_walls = 0, elsewhere = 0, out_of_walls = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::vector<Wall> walls = test::random_walls(60, 10.0, seed);
    for (const Wall& side : test::two_rooms(0.7)) walls.push_back(side);
    ReachablePlaces places(walls, kRadius);
    test::Random random(seed);
    const auto anywhere = [&] { return Vec2{random.uniform(-2, 22), random.uniform(-2, 12)}; };
    for (int k = 0; k < 30; ++k) {
      const Vec2 from = anywhere(), goal = anywhere();
      const Vec2 nearest = places.nearest_reached(from, goal);
      if (!places.is_free(from)) {
        ++out_of_walls;
        EXPECT_TRUE(nearest == from || places.is_free(nearest)) << seed << ' ' << k;
        continue;
      }
      ASSERT_TRUE(places.is_free(nearest) && places.are_connected(from, nearest)) << seed;
      if (nearest == goal) continue;
      ++(places.is_free(goal) ? elsewhere : in_walls);
      const FreeSpace space(walls, kRadius);
      for (double x = -3.0; x < 23.0; x += kStep) {
        for (double y = -3.0; y < 13.0; y += kStep) {
          const bool is_nearer = norm(Vec2{x, y} - goal) < norm(nearest - goal) - 1e-5;
          if (!is_nearer || !space.is_free({x, y})) continue;
          ASSERT_FALSE(space.are_connected(from, {x, y})) << seed << ' ' << k;
        }
      }
    }
  }
  EXPECT_GT(in_walls, 50);
  EXPECT_GT(elsewhere, 15);
  EXPECT_GT(out_of_walls, 50);
}

void expect_near(Vec2 p, Vec2 q) {
  EXPECT_NEAR(p.x, q.x, 1e-5);
  EXPECT_NEAR(p.y, q.y, 1e-5);
}

TEST(ReachablePlaces, is_beside_a_wall_in_a_corner_or_on_the_near_side_of_a_disc) {
  const std::vector<Wall> corner{{{0, 0}, {10, 0}, 0}, {{0, 0}, {0, 10}, 0.1}};
  ReachablePlaces beside(corner, 0.5);
  expect_near(beside.nearest_reached({5, 5}, {4, 0.4999}), {4, 0.5});
  expect_near(beside.nearest_reached({5, 5}, {4, -0.2}), {4, -0.5});
  expect_near(beside.nearest_reached({5, 5}, {0.2, 0.1}), {0.6, 0.5});
  expect_near(beside.nearest_reached({5, 5}, {-0.2, 3}), {-0.6, 3});
  ReachablePlaces around(std::vector<Wall>{{{0, 0}, {0, 0}, 1.0}}, 0.5);
  expect_near(around.nearest_reached({5, 0}, {0, 0}), {1.5, 0});
  expect_near(around.nearest_reached({-3, -3}, {0, 0}), {-1.06066017, -1.06066017});
  expect_near(around.nearest_reached({5, 0}, {0, 0.1}), {0, 1.5});
}

TEST(ReachablePlaces, of_who_stands_in_a_wall_are_on_its_own_side) {
  const std::vector<Wall> walls = test::two_rooms(0.7);  // a wall at x = 10
  ReachablePlaces places(walls, 0.4);
  expect_near(places.nearest_reached({9.8, 8}, {17, 8}), {9.6, 8});
  expect_near(places.nearest_reached({10.2, 8}, {3, 8}), {10.4, 8});
  // nowhere to go
  const std::vector<Wall> box{
      {{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}};
  EXPECT_EQ(ReachablePlaces(box, 0.6).nearest_reached({0.5, 0.5}, {9, 9}), (Vec2{0.5, 0.5}));
}

TEST(Reachability, tells_where_a_robot_gets_to) {
  Reachability reachability(test::two_rooms(1.2), 0.5);
  EXPECT_TRUE(reachability.connects({3, 3}, {17, 8}));
  EXPECT_EQ(reachability.nearest({3, 3}, {17, 8}), (Vec2{17, 8}));
  EXPECT_FALSE(reachability.connects({3, 3}, {9.6, 8}));
  EXPECT_FALSE(reachability.connects({3, 3}, {-5, 2}));
  expect_near(reachability.nearest({3, 3}, {-5, 2}), {0.5, 2});
  for (const double radius : {0.0, -1.0, 1e300})
    EXPECT_THROW(Reachability({}, radius), Error) << radius;
}

}  // namespace
}  // namespace avo
