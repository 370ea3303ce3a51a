// SPDX-License-Identifier: Apache-2.0
// Fields over a lattice beside graphs of all pairs of corners.
#include "navigation/field.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "navigation/free_space.h"
#include "navigation/leg.h"
#include "support/walls.h"
#include "unit/navigation/mazes.h"
#include "walls/segment.h"

namespace avo {
namespace {

using test::room_of;
using test::turned;

CornerGraph lattice_graph(const std::vector<Wall>& walls, double radius) {
  return corner_graph(walls, radius, Joining::lattice);
}

Leg leg_from(const CornerGraph& graph, const PathMap& map, Vec2 p) {
  LegScratch scratch;
  return next_leg(graph, map, p, graph.radius, PathMap::kNothing, false, scratch);
}

std::vector<Wall> any_walls(std::uint64_t seed) {
  switch (seed % 4) {
    case 0:
      return test::maze(6, 1.7 + 0.1 * static_cast<double>(seed % 5), seed);
    case 1:
      return test::random_walls(60, 20.0, seed);
    case 2:
      return test::noise_map(16, 0.05 * static_cast<double>(seed % 6), seed);
    default:
      return test::two_rooms(1.3);
  }
}

TEST(Field, all_that_a_point_aims_at_is_seen_from_there_and_nearer_to_the_goal) {
  int bends = 0, samples = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const std::vector<Wall> walls = any_walls(seed);
    test::Random random(seed);
    const double radius = random.uniform(0.2, 0.55);
    const CornerGraph graph = lattice_graph(walls, radius);
    const PathMap map = path_map(graph, test::in_square(random, 12.0));
    for (std::uint32_t k = 0; k < graph.points.size(); ++k) {
      if (map.next[k] == PathMap::kNothing) continue;
      ASSERT_GE(room_of(walls, graph.points[k], point_of(graph, map, map.next[k])),
                radius * (1.0 - 1e-8))
          << seed;
      const double length = length_from(graph, map, k);
      ASSERT_GE(length, norm(graph.points[k] - map.goal) * (1.0 - 1e-12)) << seed;
      if (map.next[k] == PathMap::kGoal) continue;
      ASSERT_LT(length_from(graph, map, map.next[k]), length) << seed;
      ++bends, samples += graph.is_corner(map.next[k]) ? 0 : 1;
    }
  }
  EXPECT_GT(bends, 3000);
  EXPECT_LT(samples, bends / 20);  // routes bend at corners, but where these are hard to find
}

TEST(Field, ways_are_hardly_longer_than_by_all_pairs_of_corners_and_as_many) {
  double most = 0.0, sum = 0.0;
  int ways = 0, none = 0;
  for (const auto& [share, radius] :
       {std::pair(0.03, 0.45), std::pair(0.12, 0.45), std::pair(0.12, 0.3), std::pair(0.3, 0.3)}) {
    const std::vector<Wall> walls = test::noise_map(32, share, 5);
    const CornerGraph pairs = corner_graph(walls, radius, Joining::all);
    const CornerGraph lattice = lattice_graph(walls, radius);
    const FreeSpace space(walls, radius);
    test::Random random(9);
    const auto place = [&] {
      for (;;) {
        const Vec2 p{random.uniform(-3.0, 35.0), random.uniform(-3.0, 35.0)};
        if (room_of(walls, p, p) >= radius) return p;
      }
    };
    for (int goal = 0; goal < 5; ++goal) {
      const Vec2 to = place();
      const PathMap graph = path_map(pairs, to), field = path_map(lattice, to);
      for (int k = 0; k < 60; ++k) {
        const Vec2 from = place();
        const Leg exact = leg_from(pairs, graph, from), leg = leg_from(lattice, field, from);
        ASSERT_EQ(leg.target != PathMap::kNothing, space.are_connected(from, to));
        if (leg.target == PathMap::kNothing) ++none;
        if (exact.target == PathMap::kNothing || leg.target == PathMap::kNothing) continue;
        const double ratio = leg.length / exact.length;
        most = std::max(most, ratio), sum += ratio, ++ways;
      }
    }
  }
  EXPECT_GT(ways, 500);
  EXPECT_GT(none, 20);
  EXPECT_LT(most, 1.03);
  EXPECT_LT(sum / ways, 1.001);
  RecordProperty("longest", std::to_string(most));
  RecordProperty("mean", std::to_string(sum / ways));
}

// However the lattice lies, and farther than its cells.
TEST(Field, leads_through_long_ways_that_are_hardly_wider_than_the_robot) {
  constexpr double kRadius = 0.5;
  for (const double more : {0.1, 1e-2, 1e-4, 1e-6}) {
    for (int k = 0; k < 12; ++k) {
      const double angle = 0.13 + 0.26 * k, half = kRadius + 0.5 * more;
      std::vector<Wall> walls{{{-15, half}, {15, half}, 0},
                              {{-15, -half}, {15, -half}, 0},
                              {{0, half}, {0, 60}, 0},
                              {{0, -half}, {0, -60}, 0}};
      for (Wall& wall : walls) wall.a = turned(wall.a, angle), wall.b = turned(wall.b, angle);
      const CornerGraph graph = lattice_graph(walls, kRadius);
      const Leg leg =
          leg_from(graph, path_map(graph, turned({20, 3}, angle)), turned({-20, -3}, angle));
      ASSERT_NE(leg.target, PathMap::kNothing) << more << ' ' << k;
      EXPECT_LT(leg.length, 30.0 + 2.0 * std::hypot(5.0, 3.0) + 0.5) << more << ' ' << k;
    }
  }
}

TEST(Field, holds_for_places_far_outside_of_all_walls) {
  const std::vector<Wall> walls = test::noise_map(12, 0.25, 3);
  const CornerGraph pairs = corner_graph(walls, 0.4), lattice = lattice_graph(walls, 0.4);
  test::Random random(4);
  for (int k = 0; k < 40; ++k) {
    const Vec2 to = Vec2{6, 6} + random.uniform(9.0, 300.0) * random.direction();
    const Vec2 from = Vec2{6, 6} + random.uniform(9.0, 300.0) * random.direction();
    const Leg exact = leg_from(pairs, path_map(pairs, to), from);
    const Leg leg = leg_from(lattice, path_map(lattice, to), from);
    ASSERT_NE(leg.target, PathMap::kNothing);
    EXPECT_LT(leg.length, 1.02 * exact.length) << from.x << ' ' << from.y;
    EXPECT_GE(room_of(walls, from, leg.aim), 0.4 * (1.0 - 1e-8));
  }
}

TEST(Lattice, samples_lie_in_their_cells_and_are_found_wherever_there_is_room) {
  int found = 0, hard = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const std::vector<Wall> walls = any_walls(seed);
    test::Random random(seed);
    const double radius = random.uniform(0.2, 0.55);
    const CornerGraph graph = lattice_graph(walls, radius);
    for (int k = 0; k < 400; ++k) {
      const Vec2 p{random.uniform(-1.0, 21.0), random.uniform(-1.0, 21.0)};
      if (room_of(walls, p, p) < radius || !graph.lattice.covers(p)) continue;
      const std::size_t cell = graph.lattice.cell_of(p);
      const std::size_t sample = graph.corners() + cell;
      if (!(graph.room[sample] > 0.0)) {
        ++hard;
        continue;
      }
      ++found;
      const Vec2 off = graph.points[sample] - graph.lattice.middle_of(cell);
      EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), 0.5 * graph.lattice.spacing + 1e-9);
      EXPECT_GE(room_of(walls, graph.points[sample], graph.points[sample]), radius);
      EXPECT_EQ(point_at(graph, graph.points[sample]), sample);
    }
  }
  EXPECT_GT(found, 2000);
  EXPECT_LT(hard, found / 100);
  RecordProperty("hard", hard);
}

}  // namespace
}  // namespace avo
