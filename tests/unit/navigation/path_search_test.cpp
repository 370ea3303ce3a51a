// SPDX-License-Identifier: Apache-2.0
// What a search tells a robot of its route is what the whole map of the goal tells, to the last
// bit.
#include "navigation/path_search.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "navigation/carried_graph.h"
#include "navigation/leg.h"
#include "unit/navigation/mazes.h"

namespace avo {
namespace {

constexpr double kRobotRadius = 0.4;

std::vector<Wall> some_walls(std::uint64_t seed) {
  return seed % 2 == 0 ? test::maze(8, 2.5, seed) : test::random_walls(90, 20.0, seed);
}

Vec2 free_place(const CornerGraph& graph, test::Random& random) {
  while (true) {
    const Vec2 p{random.uniform(-1.0, 21.0), random.uniform(-1.0, 21.0)};
    if (graph.grid.has_room(p, graph.radius)) return p;
  }
}

void expect_same(const Leg& one, const Leg& other) {
  ASSERT_EQ(one.target, other.target);
  ASSERT_EQ(one.length, other.length);
  ASSERT_EQ(one.top, other.top);
  ASSERT_EQ(one.turn, other.turn);
}

// A robot follows its route and is pushed aside, by either map.
class Walk {
 public:
  Walk(const CornerGraph& graph, Vec2 from, Vec2 goal)
      : graph_(graph),
        p_(from),
        whole_(path_map(graph, goal)),
        known_(std::make_shared<const PathMap>(goal_of(graph, goal))) {}

  // push: m, in each step, at most
  void go(test::Random& random, int steps, double push = 0.25) {
    std::uint32_t target = PathMap::kNothing;
    for (int step = 0; step < steps; ++step) {
      const bool looks = step % 3 == 0;
      const Leg leg = next_leg(graph_, whole_, p_, kRobotRadius, target, looks, scratch_);
      const std::shared_ptr<const PathMap> before = known_;
      expect_same(next_leg(graph_, known_, p_, kRobotRadius, target, looks, scratch_), leg);
      if (testing::Test::HasFatalFailure()) return;
      searches_ += known_ != before ? 1 : 0;
      legs_ += leg.target < PathMap::kNothing ? 1 : 0;
      target = leg.target;
      const double left = norm(leg.aim - p_);
      if (target == PathMap::kNothing || !(left > (leg.is_last() ? 0.3 : 0.0))) return;
      const Vec2 along = std::min(0.3, left) / left * (leg.aim - p_);
      const Vec2 pushed = p_ + along + random.uniform(0.0, push) * random.direction();
      if (graph_.grid.has_room(pushed, kRobotRadius)) p_ = pushed;
    }
  }
  [[nodiscard]] int searches() const { return searches_; }
  [[nodiscard]] std::uint32_t begun() const { return scratch_.search.search; }
  [[nodiscard]] int legs() const { return legs_; }

 private:
  const CornerGraph& graph_;
  Vec2 p_;
  PathMap whole_;
  std::shared_ptr<const PathMap> known_;
  LegScratch scratch_;
  int searches_ = 0, legs_ = 0;
};

TEST(PathSearch, leads_as_the_whole_map_does) {
  int searches = 0, legs = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const CornerGraph graph =
        corner_graph(some_walls(seed), kRobotRadius, seed % 3 == 0 ? Joining::near : Joining::all);
    for (int k = 0; k < 15; ++k) {
      SCOPED_TRACE(k);
      const Vec2 goal = free_place(graph, random), from = free_place(graph, random);
      Walk walk(graph, from, goal);
      walk.go(random, 150);
      if (HasFatalFailure()) return;
      searches += walk.searches(), legs += walk.legs();
    }
  }
  EXPECT_GT(legs, 5000);
  EXPECT_LT(searches, legs / 8);  // a robot that knows its route seldom searches again
}

// There are so many corners that a robot remembers only a part of the corners. A robot knows the
// corners beside its whole route, and no other corners where it is pushed aside.
TEST(PathSearch, is_done_once_for_a_long_way) {
  for (const Joining joining : {Joining::all, Joining::near}) {
    const CornerGraph graph =
        corner_graph(test::random_walls(900, 110.0, 3), kRobotRadius, joining);
    test::Random random(5);
    std::uint32_t searches = 0;
    int legs = 0;
    for (int k = 0; k < 24; ++k) {
      SCOPED_TRACE(k);
      const auto place = [&](double x) {
        while (true) {
          const Vec2 p{x, random.uniform(0.0, 110.0)};
          if (graph.grid.has_room(p, kRobotRadius)) return p;
        }
      };
      const bool is_pushed = k % 3 > 0;
      Walk walk(graph, place(0.0), place(110.0));
      walk.go(random, 800, is_pushed ? 0.6 : 0.0);
      if (HasFatalFailure()) return;
      if (!is_pushed) searches += walk.begun(), legs += walk.legs();
    }
    EXPECT_GT(legs, 2500);
    EXPECT_LE(searches, 16u);
  }
}

// What a robot still knows after an edit near its route is what the whole map among the edited
// walls tells. All corners that the robot takes for farther are farther.
TEST(PathSearch, is_of_use_after_an_edit_beside_the_way) {
  std::size_t known = 0, farther = 0, edits = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Joining joining = seed % 2 == 0 ? Joining::near : Joining::all;
    const std::vector<Wall> walls = test::random_walls(90, 20.0, seed);
    const CornerGraph before = corner_graph(walls, kRobotRadius, joining);
    const Vec2 from = free_place(before, random), goal = free_place(before, random);
    LegScratch scratch;
    auto map = std::make_shared<const PathMap>(goal_of(before, goal));
    const Leg leg = next_leg(before, map, from, kRobotRadius, PathMap::kNothing, false, scratch);
    for (int edit = 0; edit < 40 && leg.target < PathMap::kNothing; ++edit) {
      std::vector<Wall> edited = walls;
      if (edit % 3 != 1) edited.erase(edited.begin() + random.below(90));
      const Vec2 place{random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)};
      if (edit % 3 != 0) edited.push_back({place, place + 0.4 * random.direction()});
      std::optional<CarriedGraph> carried;
      const CornerGraph now = corner_graph(edited, kRobotRadius, before, carried, joining);
      if (!carried) continue;
      const std::vector<Zone> changed = zones_for(*carried, now, *map, leg.length);
      if (may_meet(changed, from, goal, leg.length * (1.0 + kRouteRounding))) continue;
      const PathMap left = carried_map(*map, leg.target, before, *carried, changed);
      if (!(left.settled < map->settled)) continue;
      ++edits;
      const PathMap whole = path_map(now, goal);
      ASSERT_EQ(left.corners.front(), carried->number[leg.target]);
      std::vector<char> is_beside(now.corners(), 0);
      for (const std::uint32_t corner : left.beside)
        for (const CornerGraph::Edge& edge : now.edges_of(corner)) is_beside[edge.to] = 1;
      for (std::uint32_t k = 0; k < now.corners(); ++k) {
        const double away = norm(now.points[k] - from);
        if (const PathMap::Known* told = left.around_at(k)) {
          ASSERT_TRUE(told->length == whole.length[k] && told->next == whole.next[k]) << k;
          ++known;
        } else if (away <= left.reach || is_beside[k] != 0) {
          ASSERT_GE(whole.length[k] + away, left.settled * (1.0 - 1e-9)) << k;
          ++farther;
        }
      }
    }
  }
  EXPECT_GT(edits, 20u);
  EXPECT_GT(known, 100u);
  EXPECT_GT(farther, 5000u);
}

// A robot that is restored on its route asks for the route from its target on.
TEST(PathSearch, tells_of_the_way_from_any_corner_what_the_whole_map_tells) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const CornerGraph graph = corner_graph(some_walls(seed), kRobotRadius);
    const PathMap goal = goal_of(graph, free_place(graph, random));
    const PathMap whole = path_map(graph, goal.goal);
    PathScratch scratch;
    for (std::uint32_t k = 0; k < graph.corners(); ++k) {
      const PathMap way = route_from(graph, goal, k, scratch);
      ASSERT_EQ(way.after(k), whole.after(k));
      ASSERT_EQ(length_from(graph, way, k), length_from(graph, whole, k));
      for (std::size_t place = 0; place < way.corners.size(); ++place) {
        ASSERT_EQ(way.next[place], whole.next[way.corners[place]]);
        ASSERT_EQ(way.top[place], whole.top[way.corners[place]]);
      }
    }
  }
}

TEST(PathSearch, settles_few_corners_of_a_large_map) {
  const std::vector<Wall> walls = test::random_walls(2500, 180.0, 3);
  const CornerGraph graph = corner_graph(walls, kRobotRadius);
  test::Random random(5);
  PathScratch scratch;
  std::size_t in_view = 0;
  for (int k = 0; k < 10; ++k) {
    const auto place = [&] {
      while (true) {
        const Vec2 p{random.uniform(0.0, 180.0), random.uniform(0.0, 180.0)};
        if (graph.grid.has_room(p, kRobotRadius)) return p;
      }
    };
    const PathMap goal = goal_of(graph, place());
    const Vec2 from = place();
    PathSearch search(graph, goal, from, scratch);
    double best = std::numeric_limits<double>::infinity();
    search.settle(best, [&](std::uint32_t corner, double sum) {
      if (graph.grid.is_clear(from, graph.points[corner], kRobotRadius)) best = std::min(best, sum);
      return best;
    });
    EXPECT_LT(best, 400.0);
    EXPECT_LE(search.count(), graph.corners() / 10);
    in_view += scratch.in_view.size();
  }
  EXPECT_GT(in_view, 1000u) << "corners of which nobody has asked whether the goal sees them";
}

// A line is closed across the only route that is short.
TEST(PathSearch, keeps_off_lines_that_are_closed) {
  const std::vector<Wall> walls{{{0, -10}, {0, -1}}, {{0, 1}, {0, 10}}};
  const CornerGraph graph = corner_graph(walls, kRobotRadius);
  PathMap goal = goal_of(graph, {5, 0});
  LegScratch scratch;
  auto open = std::make_shared<const PathMap>(goal);
  EXPECT_LT(
      next_leg(graph, open, {-5, 0.5}, kRobotRadius, PathMap::kNothing, false, scratch).length, 11);
  goal.closed = {{{0, -1}, {0, 1}}};
  auto closed = std::make_shared<const PathMap>(goal);
  const Leg leg =
      next_leg(graph, closed, {-5, 0.5}, kRobotRadius, PathMap::kNothing, false, scratch);
  EXPECT_GT(leg.length, 20);
  EXPECT_EQ(closed->closed.size(), 1u);
}

}  // namespace
}  // namespace avo
