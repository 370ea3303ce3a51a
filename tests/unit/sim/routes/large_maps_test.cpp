// SPDX-License-Identifier: Apache-2.0
// On maps with so many corners each robot searches for its own route. Nothing depends on which
// robot asks first, on how many threads ask, nor on what was known before.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "guidance/routes.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

constexpr double kSide = 92.0;  // m
const std::vector<Wall>& many_walls() {
  static const std::vector<Wall> walls = test::random_walls(500, kSide, 3);
  return walls;
}

// Some of them share goals.
Scenario fleet_among_many_walls(int robots) {
  const double radius = 0.4;
  test::Random random(7);
  Scenario scene;
  scene.obstacles = {test::pieces(many_walls())};
  const FreeSpace space(many_walls(), radius);
  const auto place = [&] {
    while (true) {
      const Vec2 p{random.uniform(0.0, kSide), random.uniform(0.0, kSide)};
      const bool is_apart = std::all_of(
          scene.robots.begin(), scene.robots.end(),
          [&](const RobotSetup& other) { return norm(other.position - p) > 2.5 * radius; });
      if (is_apart && space.grid().has_room(p, radius + 0.1) && space.are_connected(p, {-5, -5}))
        return p;
    }
  };
  for (int k = 0; k < robots; ++k) {
    RobotSetup robot = test::robot_at(place(), place());
    robot.radius = radius;
    if (k % 12 > 2) robot.goal = scene.robots[static_cast<std::size_t>(k - k % 12)].goal;
    scene.robots.push_back(robot);
  }
  return scene;
}

TEST(LargeMaps, haveManyCorners) {
  EXPECT_GT(corner_graph(many_walls(), 0.4).corners(), 2000u);
}

TEST(LargeMaps, stepsAreTheSameOnSeveralThreads) {
  const Scenario scene = fleet_among_many_walls(280);
  Simulation one(scene, 1), several(scene, 3);
  for (int k = 0; k < 60; ++k) {
    one.step(), several.step();
    ASSERT_EQ(one.state_hash(), several.state_hash()) << k;
  }
}

// The wall stands across the route of the first robot from `first` on that has room for it ahead,
// with no robot near.
std::optional<StaticObstacle> wall_across_a_way(const Simulation& simulation, std::size_t first) {
  const std::span<const Vec2> positions = simulation.fleet().position;
  for (std::size_t k = first; k < positions.size(); ++k) {
    const Vec2 ahead = simulation.route({k}).next - positions[k];
    if (norm(ahead) < 7.0) continue;
    const Vec2 unit = ahead / norm(ahead), middle = positions[k] + 4.5 * unit;
    const Vec2 half = 0.8 * perpendicular(unit);
    if (std::any_of(positions.begin(), positions.end(),
                    [&](Vec2 p) { return norm(p - middle) < 4.0; }))
      continue;
    StaticObstacle wall;
    wall.chains = {{{middle - half, middle + half}, false}};
    return wall;
  }
  return std::nullopt;
}

// Through a gap that is only wide enough for the robot itself, and not for the largest one that
// shares graphs with it, until a wide one opens far away.
TEST(LargeMaps, whoseRadiusIsNoClassGoesAfterAnEditAsOneThatComes) {
  const auto wall = [](Vec2 a, Vec2 b) { return StaticObstacle{{{{a, b}, false}}}; };
  Scenario scene;
  scene.right_of_way = RightOfWay::none;
  scene.obstacles = {wall({0, 0.522}, {0, 30}),   wall({0, -0.522}, {0, -7}),
                     wall({0, -11}, {0, -30}),    wall({0, -7}, {0, -11}),
                     wall({-20, 30}, {20, 30}),   wall({-20, -30}, {20, -30}),
                     wall({-20, -30}, {-20, 30}), wall({20, -30}, {20, 30})};
  RobotSetup robot = test::robot_at({-10, 0}, {10, 0});
  robot.radius = 0.5201;
  ASSERT_NE(radius_class(robot.radius), robot.radius);
  scene.robots = {robot};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 8; ++k) simulation.step();
  EXPECT_LT(simulation.route({0}).length, 20.1);
  simulation.remove_obstacle(ObstacleId{3});
  Simulation anew(simulation.save(), 1);
  anew.set_goal({0}, {10, 1});
  anew.set_goal({0}, robot.goal);
  EXPECT_EQ(simulation.route({0}).length, anew.route({0}).length);
}

// A restored simulation knows nothing but what is saved, and finds all the rest anew.
TEST(LargeMaps, goOnTheSameAfterEditsWhateverIsKnown) {
  const Scenario scene = fleet_among_many_walls(40);
  Simulation simulation(scene, 1);
  std::vector<ObstacleId> added;
  int edits = 0;
  for (int round = 0; round < 12; ++round) {
    const std::size_t robots = scene.robots.size();
    const auto wall = wall_across_a_way(simulation, static_cast<std::size_t>(3 * round));
    if (round % 3 == 2 && !added.empty()) {
      simulation.remove_obstacle(added.back());
      added.pop_back(), ++edits;
    } else if (wall) {
      added.push_back(simulation.add_obstacle(*wall)), ++edits;
    }
    simulation.set_goal(RobotId{static_cast<std::uint64_t>(round)},
                        scene.robots[robots - 1 - static_cast<std::size_t>(round)].position);
    Simulation restored(simulation.save(), 1);
    for (int k = 0; k < 12; ++k) {
      simulation.step(), restored.step();
      ASSERT_EQ(simulation.state_hash(), restored.state_hash()) << round << ' ' << k;
      for (std::size_t robot = 0; robot < robots; ++robot)
        ASSERT_EQ(simulation.route({robot}).length, restored.route({robot}).length) << robot;
    }
  }
  EXPECT_GT(edits, 6);
}

}  // namespace
}  // namespace avo
