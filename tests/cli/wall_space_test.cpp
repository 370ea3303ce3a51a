// SPDX-License-Identifier: Apache-2.0
// Random places keep clear of walls, solids and bounds, as a search through all of them says.
#include "io/maps/wall_space.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "support/generators.h"
#include "support/segment_distance.h"

namespace avo_test {
namespace {

using avo::Chain;
using avo::Fill;
using avo::StaticObstacle;
using avo::Vec2;
using avo::Wall;
using avo::test::Random;

double distance(Vec2 p, const Wall& wall) {
  return avo::test::slow_segment_distance(p, wall.a, wall.b) - wall.radius;
}

// By the angle that the chain turns around the point, not by counting crossings.
bool is_around(const Chain& chain, Vec2 p) {
  double turned = 0.0;
  for (std::size_t k = 0; k < chain.points.size(); ++k) {
    const Vec2 a = chain.points[k] - p, b = chain.points[(k + 1) % chain.points.size()] - p;
    turned += std::atan2(cross(a, b), dot(a, b));
  }
  return std::lround(turned / (2.0 * std::acos(-1.0))) % 2 != 0;
}

bool is_allowed(const std::vector<StaticObstacle>& obstacles, Vec2 p) {
  return std::all_of(obstacles.begin(), obstacles.end(), [&](const StaticObstacle& obstacle) {
    bool inside = false;
    for (const Chain& chain : obstacle.chains)
      inside = inside != (chain.closed && is_around(chain, p));
    return obstacle.fill == Fill::none || inside == (obstacle.fill == Fill::bounds);
  });
}

Vec2 any_point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  return {x, random.uniform(-size, size)};
}

StaticObstacle any_obstacle(Random& random, double size) {
  StaticObstacle obstacle;
  const double extent = size * random.log_uniform(0.01, 1.0);
  for (int chain = 0; chain <= random.below(2); ++chain) {
    Chain& points = obstacle.chains.emplace_back();
    points.closed = random.below(2) == 0;
    const Vec2 center = any_point(random, size);
    for (int k = 0; k <= random.below(6); ++k)
      points.points.push_back(center + any_point(random, extent));
  }
  if (random.below(3) == 0) obstacle.radius = size * random.log_uniform(1e-3, 0.3);
  if (random.below(3) == 0) obstacle.fill = Fill::solid;
  return obstacle;
}

TEST(WallSpace, agrees_with_a_search_through_all_walls) {
  Random random(7);
  int clear = 0, near = 0, inside = 0;
  for (int k = 0; k < 300 && !HasFailure(); ++k) {
    const double size = random.log_uniform(1e-3, 1e6);
    const double reach = size * random.log_uniform(1e-3, 0.3);
    std::vector<StaticObstacle> obstacles;
    const int count = random.below(12);
    for (int i = 0; i < count; ++i) obstacles.push_back(any_obstacle(random, size));
    if (random.below(2) == 0) {
      const double half = size * random.uniform(0.5, 1.2);
      obstacles.push_back(
          {{Chain{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true}},
           0.0,
           Fill::bounds});
    }
    const avo_io::WallSpace space(obstacles, reach);
    const std::vector<Wall> walls = avo::walls_of(obstacles);
    for (int i = 0; i < 300; ++i) {
      const Vec2 p = any_point(random, 1.3 * size);
      double gap = size;
      for (const Wall& wall : walls) gap = std::min(gap, distance(p, wall) - reach);
      if (std::abs(gap) < 1e-6 * size) continue;
      const bool allowed = is_allowed(obstacles, p);
      EXPECT_EQ(space.is_clear(p), gap > 0.0 && allowed) << p.x << ", " << p.y;
      ++(gap < 0.0 ? near : allowed ? clear : inside);
    }
  }
  EXPECT_GT(clear, 10000);
  EXPECT_GT(near, 10000);
  EXPECT_GT(inside, 5000);
}

TEST(WallSpace, without_walls_all_is_clear) {
  EXPECT_TRUE(avo_io::WallSpace({}, 1.0).is_clear({1e12, -1e12}));
}

// Each edge crosses all strips, or each lies in few.
TEST(WallSpace, of_many_walls) {
  Random random(3);
  for (const bool upright : {true, false}) {
    Chain comb{{}, true};
    for (int k = 0; k < 20000; ++k) {
      const Vec2 a{0.05 * k, k % 2 == 0 ? 0.0 : 1000.0};
      comb.points.push_back(upright ? a : Vec2{a.y, a.x});
    }
    const std::vector<StaticObstacle> obstacles{{{comb}, 0.0, Fill::bounds}};
    const std::vector<Wall> walls = avo::walls_of(obstacles);
    const avo_io::WallSpace space(obstacles, 1e-4);
    int clear = 0;
    for (int i = 0; i < 100; ++i) {
      const Vec2 p = Vec2{500.0, 500.0} + any_point(random, 510.0);
      const bool expected = is_allowed(obstacles, p) &&
                            std::all_of(walls.begin(), walls.end(),
                                        [&](const Wall& w) { return distance(p, w) >= 1e-4; });
      EXPECT_EQ(space.is_clear(p), expected);
      clear += expected ? 1 : 0;
    }
    EXPECT_GT(clear, 15);
  }
}

const std::string kRoom = R"yaml(version: 1
obstacles:
  - {wkt: "POLYGON ((0 0, 20 0, 20 20, 0 20, 0 0), (8 8, 8 12, 12 12, 12 8, 8 8))", as: bounds}
  - {polygon: [[2, 2], [6, 2], [6, 6], [2, 6]], solid: true}
  - {polyline: [[0, 15], [12, 15]]}
  - {disc: {center: [16, 4], radius: 2}}
groups:
  - {number: 60, radius: 0.4, placement: {random: {min: [-5, -5], max: [25, 25], clearance: 0.1}},
     goals: {random: {min: [-5, -5], max: [25, 25], clearance: 0.1}}}
)yaml";

TEST(WallSpace, random_starts_and_goals_keep_clear) {
  const avo::Scenario scenario = avo_io::parse_scenario(kRoom, "f");
  ASSERT_EQ(scenario.robots.size(), 60U);
  const std::vector<Wall> walls = avo::walls_of(scenario.obstacles);
  for (const avo::RobotSetup& robot : scenario.robots) {
    for (const Vec2 p : {robot.position, robot.goal}) {
      EXPECT_TRUE(is_allowed(scenario.obstacles, p)) << p.x << ", " << p.y;
      for (const Wall& wall : walls) EXPECT_GE(distance(p, wall), 0.5);
    }
  }
}

TEST(WallSpace, a_rectangle_inside_a_solid_has_no_room) {
  try {
    avo_io::parse_scenario(R"yaml(version: 1
obstacles: [{polygon: [[0, 0], [20, 0], [20, 20], [0, 20]], solid: true}]
groups: [{number: 3, placement: {random: {min: [5, 5], max: [15, 15]}}, goals: antipodal}]
)yaml",
                           "f");
    FAIL();
  } catch (const avo_io::SceneError& error) {
    EXPECT_STREQ(error.what(),
                 "f:3:10: groups.0.placement: found room for 0 of 3, must have room for all: "
                 "enlarge the rectangle");
  }
}

}  // namespace
}  // namespace avo_test
