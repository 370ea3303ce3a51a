// SPDX-License-Identifier: Apache-2.0
// Robots that have one goal come to rest around it among walls, in passages, and on wheels.
#include "unit/sim/rallies.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

#include "perceived.h"
#include "support/generators.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::expect_rest;
using test::Random;
using test::robot_at;

// Adds robots on their ways to the goal, at random places in a box, apart from each other and from
// where `is_free` says no.
void gather(Scenario& scene, int robots, Vec2 low, Vec2 high, Vec2 goal,
            const std::function<bool(Vec2)>& is_free, std::uint64_t seed) {
  Random random(seed);
  for (int k = 0; k < robots;) {
    const Vec2 from{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    const bool is_clear =
        std::all_of(scene.robots.begin(), scene.robots.end(),
                    [&](const RobotSetup& other) { return norm(other.position - from) > 1.4; });
    if (!is_clear || !is_free(from)) continue;
    scene.robots.push_back(robot_at(from, goal));
    ++k;
  }
}

// Pillars of 0.3 m with that much between them, around the goal.
Scenario pillar_field(int robots, double gap, Vec2 goal, std::uint64_t seed) {
  Scenario scene;
  const double radius = 0.3, apart = gap + 2.0 * radius, half = 5.0 * apart;
  StaticObstacle pillars{.radius = radius};
  for (int k = 0; k < 100; ++k) {
    const Vec2 center{apart * (k % 10 - 4.5), apart * (k / 10 - 4.5)};
    pillars.chains.push_back({{center}, false});
  }
  scene.obstacles = {pillars};
  const auto is_outside = [half](Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > half; };
  gather(scene, robots, {-half - 4, -half - 4}, {half + 4, half + 4}, goal, is_outside, seed);
  return scene;
}

// A lane along x to both sides of the origin, through a wall that goes on for ever.
Scenario lane(double width, double length) {
  Scenario scene;
  const double x = 0.5 * length, y = 0.5 * width, far = 200.0;
  scene.obstacles = {
      test::pieces({{{-x, far}, {-x, y}}, {{-x, y}, {x, y}}, {{x, y}, {x, far}}}),
      test::pieces({{{-x, -far}, {-x, -y}}, {{-x, -y}, {x, -y}}, {{x, -y}, {x, -far}}})};
  return scene;
}

TEST(RalliesAmongWalls, come_to_rest_between_pillars) {
  for (const double gap : {1.15, 1.3, 2.2}) {
    for (const int robots : {2, 6, 16}) {
      SCOPED_TRACE(testing::Message() << gap << ' ' << robots);
      expect_rest(pillar_field(robots, gap, {}, 4), 10.0);
      expect_rest(pillar_field(robots, gap, {0.1, 0.5 * gap}, 5), 10.0);
    }
  }
}

TEST(RalliesAmongWalls, come_to_rest_in_a_lane) {
  for (const double width : {1.1, 1.6, 2.4}) {
    for (const int robots : {2, 5, 12}) {
      for (const bool from_one_side : {false, true}) {
        SCOPED_TRACE(testing::Message() << width << ' ' << robots << ' ' << from_one_side);
        Scenario scene = lane(width, 6.0);
        const auto is_free = [&](Vec2 p) { return std::abs(p.x) > 3.6; };
        gather(scene, robots, {-12, -6}, {from_one_side ? -4.0 : 12.0, 6}, {0.7, 0.0}, is_free, 3);
        expect_rest(scene, 10.0);
      }
    }
  }
}

TEST(RalliesAmongWalls, come_to_rest_in_and_before_a_dead_end) {
  for (const double width : {1.1, 1.6, 2.6}) {
    for (const int robots : {3, 8, 16}) {
      SCOPED_TRACE(testing::Message() << width << ' ' << robots);
      Scenario scene = lane(width, 4.0);
      scene.obstacles.push_back(test::pieces({{{2.0, -2.0}, {2.0, 2.0}}}));
      const auto is_free = [](Vec2 p) { return p.x < -2.6; };
      gather(scene, robots, {-13, -7}, {-2, 7}, {1.4, 0.0}, is_free, 8);
      expect_rest(scene, 10.0);
    }
  }
}

// Some see the goal from outside, and some do not.
TEST(RalliesAmongWalls, come_to_rest_in_and_before_a_small_room) {
  for (const int robots : {3, 8, 16}) {
    SCOPED_TRACE(robots);
    Scenario scene;
    scene.obstacles = {test::pieces({{{0, -20}, {0, -0.8}},
                                     {{0, 0.8}, {0, 20}},
                                     {{0, -2}, {3, -2}},
                                     {{3, -2}, {3, 2}},
                                     {{3, 2}, {0, 2}}})};
    const auto is_free = [](Vec2 p) { return p.x < -0.6; };
    gather(scene, robots, {-12, -8}, {0, 8}, {2.2, 1.1}, is_free, 2);
    expect_rest(scene, 10.0);
  }
}

// Those beyond the wall are nearer to the goal than others, and have farther to go.
TEST(RalliesAmongWalls, come_to_rest_on_both_sides_of_a_wall) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    Scenario scene;
    scene.obstacles = {test::pieces({{{0, -3}, {0, 3}}})};
    const auto is_free = [](Vec2 p) { return std::abs(p.x) > 2.0; };
    gather(scene, 14, {-12, -10}, {12, 10}, {-1.2, -0.5}, is_free, seed);
    expect_rest(scene);
  }
}

TEST(RalliesAmongWalls, come_to_rest_around_a_pillar_on_the_goal) {
  Scenario scene;
  scene.obstacles = {{.chains = {{{{0.2, 0.0}}}}, .radius = 1.0}};
  const auto is_free = [](Vec2 p) { return norm(p) > 4.0; };
  gather(scene, 12, {-12, -12}, {12, 12}, {}, is_free, 6);
  const test::Rally rally = test::run_rally(scene, 60.0);
  EXPECT_LT(rally.rest, 45.0);
  EXPECT_EQ(rally.at_rest, 0) << "that is too far from the goal";
  EXPECT_EQ(rally.contacts, 0);
}

TEST(RalliesAmongWalls, come_to_rest_around_a_mover_that_rests_on_the_goal) {
  Scenario scene;
  scene.moving_obstacles = {{.position = {0.1, 0.0}, .radius = 2.0}};
  const auto is_free = [](Vec2 p) { return norm(p) > 4.0; };
  gather(scene, 12, {-12, -12}, {12, 12}, {}, is_free, 6);
  expect_rest(scene);
}

// Robots that want to get through do, and the others come back and rest.
TEST(RalliesAmongWalls, let_through_a_lane_who_has_another_goal) {
  for (const int robots : {2, 3, 5}) {
    SCOPED_TRACE(robots);
    Scenario scene = lane(1.6, 8.0);
    for (int k = 0; k < robots; ++k)
      scene.robots.push_back(robot_at({-5.5 - 1.2 * k, 0.3 * (k % 3 - 1)}, {1.0, 0.0}));
    scene.robots.push_back(robot_at({18.0, 1.0}, {-12.0, 3.0}));
    scene.robots.push_back(robot_at({-22.0, -2.0}, {12.0, -3.0}));
    const test::Rally rally = test::run_rally(scene, 200.0);
    EXPECT_EQ(rally.at_rest, robots + 2);
    EXPECT_EQ(rally.contacts, 0);
  }
}

TEST(RalliesAmongWalls, are_perceived_as_they_are_stepped_and_restored) {
  Scenario scene = lane(1.6, 6.0);
  const auto is_free = [](Vec2 p) { return std::abs(p.x) > 3.6; };
  gather(scene, 5, {-9, -4}, {9, 4}, {0.7, 0.0}, is_free, 3);
  Simulation simulation(scene, 1);
  int taken = 0;
  const auto count = [&](const Simulation::Perception& seen) {
    taken += seen.detour.goal_taken ? 1 : 0;
  };
  for (int k = 0; k < 250; ++k) {
    ASSERT_NO_FATAL_FAILURE(test::step_as_perceived(simulation, count));
  }
  EXPECT_GT(taken, 100);
  EXPECT_TRUE(simulation.all_at_goal());
  Simulation restored(simulation.save(), 1);
  EXPECT_TRUE(restored.all_at_goal());
}

// The first of them that it is, and others that steer.
TEST(RalliesOnWheels, come_to_rest) {
  const std::vector<MotionModel> models = {
      Car{.wheelbase = 0.8}, Car{.max_curvature = 0.8, .reverse = true}, Car{.max_curvature = 0.8},
      Car{.wheelbase = 0.8, .body = CarBody{0.3, 0.5}},
      Car{.max_curvature = 0.8, .body = CarBody{0.3, 0.5}, .reverse = true}};
  for (const int robots : {3, 8, 16}) {
    for (const int every : {1, 2}) {
      for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(testing::Message() << robots << ' ' << every << ' ' << seed);
        Scenario scene;
        const auto is_free = [](Vec2 p) { return norm(p) > 5.0; };
        const double outer = 8.0 + 2.0 * std::sqrt(robots);
        gather(scene, robots, {-outer, -outer}, {outer, outer}, {}, is_free, seed);
        for (std::size_t k = 0; k < scene.robots.size(); k += static_cast<std::size_t>(every)) {
          const Vec2 p = scene.robots[k].position;
          scene.robots[k].model = models[(k + seed) % models.size()];
          scene.robots[k].heading = std::atan2(-p.y, -p.x) + 0.4 * static_cast<double>(k % 5) - 0.8;
        }
        expect_rest(scene);
      }
    }
  }
}

}  // namespace
}  // namespace avo
