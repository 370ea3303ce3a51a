// SPDX-License-Identifier: Apache-2.0
// Routes beside brute force, in mazes and through narrow doors: by graphs, and by fields.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>

#include "navigation/free_space.h"
#include "navigation/leg.h"
#include "unit/navigation/mazes.h"
#include "walls/segment.h"

namespace avo {
namespace {

using test::room_of;
using test::turned;

constexpr double kMapRadius = 0.5;

// The tests take every map: with all pairs of corners joined, with the near pairs joined, and with
// a lattice.
class RoutesByMap : public testing::TestWithParam<Joining> {
 protected:
  static CornerGraph graph_of(const std::vector<Wall>& walls, double radius) {
    return corner_graph(walls, radius, GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(PathMap, RoutesByMap,
                         testing::Values(Joining::all, Joining::near, Joining::lattice),
                         [](const auto& kind) {
                           return kind.param == Joining::all    ? "graph"
                                  : kind.param == Joining::near ? "near"
                                                                : "field";
                         });

Leg leg_from(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
             bool looks_around) {
  LegScratch scratch;
  return next_leg(graph, map, p, graph.radius, target, looks_around, scratch);
}

/// Returns the length of the shortest route by all pairs of points on circles around all ends. The
/// route is no shorter than the shortest route that keeps `room`. The route is longer by the
/// chords' bends only.
double brute_force(const std::vector<Wall>& walls, Vec2 from, Vec2 to, double room) {
  constexpr int kPoints = 24;
  std::vector<Vec2> points{from, to};
  for (const Wall& wall : walls) {
    for (const Vec2 end : {wall.a, wall.b}) {
      for (int k = 0; k < kPoints; ++k) {
        const double angle = 2.0 * M_PI * (k + 0.37) / kPoints;
        const double reach = (room + wall.radius) / std::cos(M_PI / kPoints) * (1.0 + 1e-9);
        const Vec2 p = end + reach * Vec2{std::cos(angle), std::sin(angle)};
        if (room_of(walls, p, p) >= room) points.push_back(p);
      }
    }
  }
  std::vector<double> length(points.size(), 1e9);
  std::vector<char> is_done(points.size(), 0);
  length[0] = 0.0;
  for (std::size_t round = 0; round < points.size(); ++round) {
    std::size_t here = points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (is_done[k] == 0 && (here == points.size() || length[k] < length[here])) here = k;
    }
    is_done[here] = 1;
    if (here == 1 || length[here] >= 1e9) break;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double there = length[here] + norm(points[k] - points[here]);
      if (is_done[k] == 0 && there < length[k] && room_of(walls, points[here], points[k]) >= room)
        length[k] = there;
    }
  }
  return length[1];
}

TEST_P(RoutesByMap, AreAsShortAsBruteForce) {
  int ways = 0;
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Wall> walls = test::random_walls(9, 12.0, seed);
    const CornerGraph graph = graph_of(walls, kMapRadius);
    test::Random random(seed);
    for (int k = 0; k < 4; ++k) {
      const auto place = [&] {
        for (;;) {
          const Vec2 p{random.uniform(-2.0, 14.0), random.uniform(-2.0, 14.0)};
          if (room_of(walls, p, p) >= kMapRadius + kSpareRoom) return p;
        }
      };
      const Vec2 from = place(), to = place();
      const PathMap map = path_map(graph, to);
      const Leg leg = leg_from(graph, map, from, PathMap::kNothing, false);
      const double reference = brute_force(walls, from, to, kMapRadius + kSpareRoom);
      const double shortest = brute_force(walls, from, to, kMapRadius);
      if (reference >= 1e9) continue;
      ASSERT_NE(leg.target, PathMap::kNothing) << seed;
      EXPECT_LT(leg.length, 1.03 * reference + 1e-9) << seed;
      EXPECT_GT(leg.length, 0.97 * shortest) << seed;
      most = std::max(most, leg.length / reference);
      if (!leg.is_last()) ++ways;
    }
  }
  EXPECT_GT(ways, 20);
  RecordProperty("longest", std::to_string(most));
}

// Follows the map from leg to leg; the length of what it went, or -1 where it is lost.
double followed(const std::vector<Wall>& walls, const CornerGraph& graph, const PathMap& map,
                Vec2 p, double room) {
  double length = 0.0;
  std::uint32_t target = PathMap::kNothing;
  for (int k = 0; k < 10000; ++k) {
    const Leg leg = leg_from(graph, map, p, target, k % 10 == 0);
    if (leg.target == PathMap::kNothing) return -1.0;
    target = leg.target;
    const Vec2 way = leg.aim - p;
    const Vec2 next = norm(way) <= 0.1 ? leg.aim : p + (0.1 / norm(way)) * way;
    if (room_of(walls, p, next) < room) return -1.0;
    length += norm(next - p);
    p = next;
    if (p == map.goal) return length;
  }
  return -1.0;
}

TEST_P(RoutesByMap, LeadThroughMazes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Wall> walls = test::maze(10, 3.0, seed);
    const CornerGraph graph = graph_of(walls, kMapRadius);
    const PathMap map = path_map(graph, {28.5, 28.5});
    for (int k = 0; k < 99; k += 7) {
      const Vec2 from{1.5 + 3.0 * (k % 10), 1.5 + 3.0 * (k / 10)};
      const double planned = leg_from(graph, map, from, PathMap::kNothing, false).length;
      const double length = followed(walls, graph, map, from, kMapRadius - 1e-6);
      EXPECT_GT(length, 0.0) << seed << ' ' << k;
      EXPECT_LT(length, 1.01 * planned);
    }
  }
}

TEST_P(RoutesByMap, LeadThroughNarrowDoors) {
  for (const double more : {0.3, 0.12, 0.05, 1e-2, 1e-3, 1e-6}) {
    const std::vector<Wall> walls = test::two_rooms(2.0 * kMapRadius + more);
    const CornerGraph graph = graph_of(walls, kMapRadius);
    const PathMap map = path_map(graph, {17, 8});
    const double length = followed(walls, graph, map, {3, 3}, kMapRadius - 1e-6);
    EXPECT_GT(length, 14.0) << more;
    EXPECT_LT(length, 1.03 * (norm(Vec2{7, 2}) + norm(Vec2{7, 3}))) << more;
  }
  const CornerGraph graph = graph_of(test::two_rooms(2.0 * kMapRadius - 1e-3), kMapRadius);
  const PathMap map = path_map(graph, {17, 8});
  EXPECT_EQ(leg_from(graph, map, {3, 3}, PathMap::kNothing, false).target, PathMap::kNothing);
}

// A corridor that turns left, so narrow that a robot touches walls on both sides where it turns.
std::vector<Wall> narrow_bend(double width, double turn) {
  const double inner = width * std::tan(0.5 * turn);  // of the outer corner before the inner one
  const Vec2 way{std::cos(turn), std::sin(turn)}, outer{0.0, 0.0}, corner{-inner, width};
  return {{{-12.0, 0.0}, outer, 0.0},
          {{-12.0, width}, corner, 0.0},
          {outer, 12.0 * way, 0.0},
          {corner, corner + 12.0 * way, 0.0}};
}

TEST_P(RoutesByMap, LeadAroundNarrowBends) {
  for (const double turn : {0.5, 1.0, 1.3, 0.5 * M_PI, 2.0}) {
    for (const double more : {0.3, 0.1, 0.09, 0.05, 0.03, 0.015, 1e-3, 1e-5}) {
      const double width = 2.0 * kMapRadius + more, angle = 0.7 + 3.0 * turn;
      std::vector<Wall> walls = narrow_bend(width, turn);
      const auto placed = [&](Vec2 p) { return turned(p, angle) + Vec2{3.3, -1.7}; };
      for (Wall& wall : walls) wall.a = placed(wall.a), wall.b = placed(wall.b);
      const Vec2 from = placed({-10.0, 0.5 * width});
      const Vec2 to = placed(10.0 * Vec2{std::cos(turn), std::sin(turn)} +
                             0.5 * width * Vec2{-std::sin(turn), std::cos(turn)});
      const CornerGraph graph = graph_of(walls, kMapRadius);
      const PathMap map = path_map(graph, to);
      const double length = followed(walls, graph, map, from, kMapRadius - 1e-6);
      EXPECT_GT(length, 10.0) << more << ' ' << turn;
      EXPECT_LT(length, 21.0) << more << ' ' << turn;
    }
  }
}

// The discs are thick, and each route between them has a room of its own. No robot turns back for
// more room.
TEST_P(RoutesByMap, LeadThroughDiscs) {
  int ways = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    test::Random random(seed);
    const double radius = random.uniform(0.2, 0.6);
    std::vector<Wall> walls;
    for (int k = 0; k < 25; ++k) {
      const Vec2 p{random.uniform(0.0, 12.0), random.uniform(0.0, 12.0)};
      walls.push_back({p, p, random.uniform(0.1, 0.9)});
    }
    const CornerGraph graph = graph_of(walls, radius);
    for (int goal = 0; goal < 3; ++goal) {
      const auto place = [&] {
        return Vec2{random.uniform(-1.0, 13.0), random.uniform(-1.0, 13.0)};
      };
      const PathMap map = path_map(graph, place());
      if (!map.is_free) continue;
      for (int k = 0; k < 6; ++k) {
        const Vec2 from = place();
        if (room_of(walls, from, from) < radius) continue;
        if (leg_from(graph, map, from, PathMap::kNothing, false).target == PathMap::kNothing)
          continue;
        ++ways;
        EXPECT_GT(followed(walls, graph, map, from, radius * (1.0 - 1e-6)), 0.0) << seed;
      }
    }
  }
  EXPECT_GT(ways, 300);
}

// What the map calls a route is a route, and no place that a fair door leads to lacks a route.
TEST_P(RoutesByMap, AreOnlyWhereThereIsOne) {
  int none = 0, lost = 0, some = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<Wall> walls = test::random_walls(45, 10.0, seed);
    const CornerGraph graph = graph_of(walls, 0.4);
    const FreeSpace space(walls, 0.4);
    test::Random random(seed);
    for (int k = 0; k < 100; ++k) {
      const Vec2 from{random.uniform(0.0, 10.0), random.uniform(0.0, 10.0)};
      const Vec2 to{random.uniform(0.0, 10.0), random.uniform(0.0, 10.0)};
      if (room_of(walls, from, from) < 0.4 || room_of(walls, to, to) < 0.4) continue;
      const Leg leg = leg_from(graph, path_map(graph, to), from, PathMap::kNothing, false);
      const bool has_way = leg.target != PathMap::kNothing;
      const bool connected = space.are_connected(from, to);
      EXPECT_TRUE(!has_way || connected) << seed;
      none += !connected ? 1 : 0, some += has_way ? 1 : 0, lost += connected && !has_way ? 1 : 0;
    }
  }
  EXPECT_GT(some, 300);
  EXPECT_GT(none, 50);
  EXPECT_LE(lost, some / 500);
  RecordProperty("lost", lost);
}

// A route around a closed gap is a route among the same walls and one more wall across the gap.
// Only what the route keeps from that wall differs.
TEST_P(RoutesByMap, LeadAroundClosedGaps) {
  std::vector<Wall> walls;
  for (const double x : {0.0, 10.0}) {
    for (const double y : {-6.0, 0.0, 6.0}) walls.push_back({{x, y - 2.2}, {x, y + 2.2}});
  }
  const std::vector<Segment> closed{{{0, 2.2}, {0, 3.8}}, {{10, -2.2}, {10, -3.8}}};
  const CornerGraph graph = graph_of(walls, kMapRadius);
  const Vec2 goal{15, -3};
  const PathMap open = path_map(graph, goal), around = path_map(graph, goal, closed);
  int longer = 0;
  for (double y = -9.0; y <= 9.0; y += 0.5) {
    Vec2 p{-4.0, y};
    const Leg straight = leg_from(graph, open, p, PathMap::kNothing, true);
    Leg leg = leg_from(graph, around, p, PathMap::kNothing, true);
    EXPECT_GE(leg.length, straight.length - 1e-9);
    longer += leg.length > straight.length + 0.5 ? 1 : 0;
    double length = 0.0;
    for (int k = 0; k < 50 && norm(p - goal) > 0.0; ++k) {
      ASSERT_NE(leg.target, PathMap::kNothing) << y;
      EXPECT_TRUE(around.is_open(p, leg.aim)) << y;
      length += norm(leg.aim - p);
      p = leg.aim;
      leg = leg_from(graph, around, p, leg.target, k % 2 == 0);
    }
    EXPECT_EQ(p, goal);
    EXPECT_LE(length, leg_from(graph, around, {-4.0, y}, PathMap::kNothing, true).length + 1e-6);
  }
  EXPECT_GT(longer, 15);
  const std::vector<Segment> all{
      closed[0], closed[1], {{10, 2.2}, {10, 3.8}}, {{10, 8.2}, {10, 99}}, {{10, -8.2}, {10, -99}}};
  EXPECT_EQ(leg_from(graph, path_map(graph, goal, all), {-4, 0}, PathMap::kNothing, true).target,
            PathMap::kNothing);
}

TEST_P(RoutesByMap, AreNoneToAGoalNearerThanTheRadiusToAWall) {
  const CornerGraph graph = graph_of(test::two_rooms(2.0), kMapRadius);
  EXPECT_FALSE(path_map(graph, {10.0 - kMapRadius + 1e-9, 2.0}).is_free);
  EXPECT_TRUE(path_map(graph, {10.0 - kMapRadius, 2.0}).is_free);
  const PathMap map = path_map(graph, {9.6, 2.0});
  EXPECT_EQ(leg_from(graph, map, {3, 3}, PathMap::kNothing, false).target, PathMap::kNothing);
}

TEST_P(RoutesByMap, AmongLoosePiecesAreThoseAmongTheWallsThatTheyMakeUp) {
  // one wall with a right-angled end, whole, in overlapping pieces, and in pieces end to end
  const std::vector<Wall> whole{{{0, 0}, {10, 0}, 0}, {{10, 0}, {10, 5}, 0}};
  std::vector<Wall> pieces;
  for (int k = 19; k >= 0; --k) {
    pieces.push_back({{0.5 * k + 0.5, 0}, {0.5 * k - (k % 2 == 1 ? 0.3 : 0.0), 0}, 0});
    pieces.push_back({{10, 0.25 * k}, {10, 0.25 * k + 0.25}, 0});
  }
  const CornerGraph graph = graph_of(whole, kMapRadius), loose = graph_of(pieces, kMapRadius);
  EXPECT_EQ(graph.points.size(), loose.points.size());
  const Vec2 goal{5, 2}, from{8, -3};
  const double length =
      leg_from(graph, path_map(graph, goal), from, PathMap::kNothing, false).length;
  EXPECT_NEAR(leg_from(loose, path_map(loose, goal), from, PathMap::kNothing, false).length, length,
              1e-6);
}

TEST_P(RoutesByMap, AreSlowBeforeTurns) {
  // around the end of a wall: v² = 2 a W / sin² φ + 1.6 a d, and never more before later turns
  const CornerGraph graph = graph_of(std::vector<Wall>{{{0, 0}, {0, 50}, 0}}, kMapRadius);
  const PathMap map = path_map(graph, {0.6, 40});
  const Vec2 from{-0.6, 40};
  const Leg leg = leg_from(graph, map, from, PathMap::kNothing, false);
  ASSERT_FALSE(leg.is_last());
  const double distance = norm(leg.aim - from);
  EXPECT_NEAR(leg.turn, 0.5, 0.02);  // 30 degrees at each corner but the first and last
  const double turning = 2.0 * 0.3 * kMapRadius / (leg.turn * leg.turn);
  EXPECT_LE(speed_limit(leg, 2.0), std::sqrt(2.0 * (turning + 1.6 * distance)) + 1e-9);
  EXPECT_GT(speed_limit(leg, 2.0), std::sqrt(2.0 * 1.6 * distance));
  const Leg last = leg_from(graph, map, {0.6, 39}, PathMap::kNothing, false);
  EXPECT_TRUE(last.is_last());
  EXPECT_EQ(speed_limit(last, 2.0), std::numeric_limits<double>::infinity());
}

TEST(PathMap, OfManyCornersIsMadeInSeconds) {
  const std::vector<Wall> walls = test::random_walls(700, 92.0, 3);
  const auto begin = std::chrono::steady_clock::now();
  const CornerGraph graph = corner_graph(walls, 0.4);
  const auto built = std::chrono::steady_clock::now();
  const PathMap map = path_map(graph, {55, 55});
  const auto mapped = std::chrono::steady_clock::now();
  EXPECT_GT(graph.points.size(), 3000u);
  const auto milliseconds = [](auto span) {
    return std::to_string(std::chrono::duration<double, std::milli>(span).count());
  };
  RecordProperty("graph_ms", milliseconds(built - begin));
  RecordProperty("map_ms", milliseconds(mapped - built));
  RecordProperty("points", static_cast<int>(graph.points.size()));
}

}  // namespace
}  // namespace avo
