// SPDX-License-Identifier: Apache-2.0
// The edges of a graph are those of all pairs of its corners.
#include "navigation/corner_graph.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "navigation/carried_graph.h"
#include "support/walls.h"
#include "unit/navigation/mazes.h"

namespace avo {
namespace {

// The function looks at all pairs of corners, one by one.
std::vector<std::uint32_t> joined_to(const CornerGraph& graph, std::uint32_t i) {
  std::vector<std::uint32_t> joined;
  for (std::uint32_t k = 0; k < graph.corners(); ++k) {
    const Vec2 p = graph.points[std::min(i, k)], q = graph.points[std::max(i, k)];
    const double length = norm(q - p);
    if (!(length > 0.0)) continue;
    const Vec2 direction = (q - p) / length;
    if (graph.may_bend(i, direction) && graph.may_bend(k, direction) &&
        graph.grid.is_clear(p, q, std::min(graph.room[i], graph.room[k])))
      joined.push_back(k);
  }
  return joined;
}

std::vector<std::uint32_t> ends_of(std::span<const CornerGraph::Edge> edges) {
  std::vector<std::uint32_t> ends;
  for (const CornerGraph::Edge& edge : edges) ends.push_back(edge.to);
  return ends;
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

std::vector<Wall> any_walls(std::uint64_t seed, double radius) {
  test::Random random(seed);
  std::vector<Wall> walls = seed % 3 == 0   ? test::maze(5, 3.0, seed)
                            : seed % 3 == 1 ? test::random_walls(30, 15.0, seed)
                                            : test::random_walls(random, 9.0, radius);
  for (int k = 0; k < 12; ++k) walls.push_back(any_wall(random, walls, 15.0));
  return walls;
}

TEST(CornerGraph, joins_all_corners_that_see_each_other) {
  std::size_t edges = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const double radius = test::Random(seed).uniform(0.1, 0.6);
    const CornerGraph graph = corner_graph(any_walls(seed, radius), radius, Joining::all);
    for (std::uint32_t k = 0; k < graph.corners(); ++k) {
      ASSERT_EQ(ends_of(graph.edges_of(k)), joined_to(graph, k));
      edges += graph.edges_of(k).size();
    }
  }
  EXPECT_GT(edges, 20000u);
}

// The same as far as 64 radii; beyond, one in each sector that has none nearer, and all of them
// among those that see each other.
TEST(CornerGraph, of_many_corners_joins_those_that_are_near) {
  const double radius = 0.05;
  std::size_t far = 0, left_out = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const CornerGraph graph = corner_graph(any_walls(seed, radius), radius, Joining::near);
    ASSERT_EQ(graph.all_within, 64.0 * radius);
    for (std::uint32_t k = 0; k < graph.corners(); ++k) {
      const Vec2 p = graph.points[k];
      std::map<std::size_t, std::pair<double, std::uint32_t>> nearest;
      std::vector<std::uint32_t> expected;
      for (const std::uint32_t other : joined_to(graph, k)) {
        const double length = norm(graph.points[other] - p);
        const std::size_t sector = Horizons::sector_of(graph.points[other] - p);
        const auto [place, is_new] = nearest.insert({sector, {length, other}});
        if (!is_new) place->second = std::min(place->second, {length, other});
        if (length <= graph.all_within) expected.push_back(other);
      }
      for (const auto& [sector, best] : nearest)
        if (best.first > graph.all_within) expected.push_back(best.second), ++far;
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(ends_of(graph.edges_of(k)), expected);
      left_out += joined_to(graph, k).size() - expected.size();
    }
  }
  EXPECT_GT(far, 1000u);
  EXPECT_GT(left_out, 1000u);
}

// After edits, whatever was known before: corners, their numbers and edges are those of a graph
// that is made of nothing.
TEST(CornerGraph, is_the_same_whatever_it_was_made_of) {
  std::size_t carried_edges = 0, carried_corners = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Joining joining = seed % 4 < 2 ? Joining::all : Joining::near;
    const double radius = random.uniform(0.05, 0.3), side = seed % 2 == 0 ? 15.0 : 40.0;
    std::vector<Wall> walls = seed % 3 == 0 ? test::maze(side < 20 ? 5 : 12, 3.0, seed)
                                            : test::random_walls(side < 20 ? 30 : 200, side, seed);
    walls.push_back({{1, 1}, {1, 1}, 0.3});
    CornerGraph graph = corner_graph(walls, radius, joining);
    for (int edit = 0; edit < 8; ++edit) {
      for (std::uint32_t k = 0; k < graph.corners(); ++k)
        if (random.below(3) > 0) (void)graph.edges_of(k);
      const auto place = [&] {
        return walls.begin() + random.below(static_cast<int>(walls.size()) + 1);
      };
      for (int k = random.below(3); k > 0; --k) {
        Wall wall = any_wall(random, walls, side);
        wall.radius = std::min(wall.radius, 0.3);
        walls.insert(random.below(2) == 0 ? walls.end() : place(), wall);
      }
      const auto gone = place();
      if (gone + 1 < walls.end()) walls.erase(gone);
      const CornerGraph fresh = corner_graph(walls, radius, joining);
      std::optional<CarriedGraph> carried;
      CornerGraph made = corner_graph(walls, radius, graph, carried, joining);
      ASSERT_TRUE(made.points == fresh.points && made.room == fresh.room);
      ASSERT_TRUE(made.outward == fresh.outward && made.most_lean == fresh.most_lean);
      for (std::uint32_t k = 0; k < fresh.corners(); ++k) {
        carried_edges += made.edges.known(k) != nullptr ? 1 : 0;
        ASSERT_EQ(ends_of(made.edges_of(k)), ends_of(fresh.edges_of(k))) << edit << ' ' << k;
      }
      for (std::uint32_t k = 0; carried && k < graph.corners(); ++k) {
        if (carried->number[k] == kNoCorner) continue;
        ++carried_corners;
        ASSERT_EQ(graph.points[k], fresh.points[carried->number[k]]);
      }
      graph = std::move(made);
    }
  }
  EXPECT_GT(carried_edges, 2000u);
  EXPECT_GT(carried_corners, 10000u);
}

TEST(CornerGraph, finds_its_points_by_their_places) {
  const CornerGraph graph = corner_graph(test::maze(5, 3.0, 1), 0.4);
  for (std::uint32_t k = 0; k < graph.corners(); ++k)
    EXPECT_EQ(point_at(graph, graph.points[k]), k);
  EXPECT_EQ(point_at(graph, {1.5, 1.5}), graph.corners());
}

}  // namespace
}  // namespace avo
