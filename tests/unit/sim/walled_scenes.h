// SPDX-License-Identifier: Apache-2.0
// Fleets among walls.
#pragma once
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "navigation/corner_graph.h"
#include "navigation/free_space.h"
#include "unit/navigation/mazes.h"
#include "unit/sim/scenes.h"

namespace avo::test {

inline StaticObstacle pieces(const std::vector<Wall>& walls) {
  StaticObstacle obstacle;
  for (const Wall& wall : walls) obstacle.chains.push_back({{wall.a, wall.b}, false});
  return obstacle;
}

inline Vec2 cell_of_maze(int k) {
  return {1.5 + 3.0 * (k % 10), 1.5 + 3.0 * (k / 10)};
}

/// Up to four robots in each cell of a maze of 10 x 10, on their ways to others.
inline Scenario crowded_maze(int robots) {
  Scenario scene{.sensing_radius = 15.0};
  scene.obstacles = {pieces(maze(10, 3.0, 4))};
  for (int k = 0; k < robots; ++k) {
    RobotSetup robot = robot_at(cell_of_maze((7 * k) % 100), cell_of_maze((31 * k + 5) % 100));
    const Vec2 shift{0.55 * (k / 100 % 2 == 0 ? -1 : 1), 0.55 * (k / 200 % 2 == 0 ? -1 : 1)};
    robot.position = robot.position + shift;
    robot.radius = k % 2 == 0 ? 0.3 : 0.25;
    scene.robots.push_back(robot);
  }
  return scene;
}

/// A map with so many corners that long edges lead to the nearest alone. All goals can be reached.
inline Scenario noise_scene(int robots) {
  constexpr int kSide = 96;
  Random random(3);
  const std::vector<Wall> walls = noise_map(kSide, 0.12, 11);
  Scenario scene;
  scene.obstacles = {pieces(walls)};
  const double radius = 0.4;
  const CornerGraph graph = corner_graph(walls, radius);
  const FreeSpace space(walls, radius);
  std::vector<Vec2> taken;
  const auto place = [&] {
    for (;;) {
      const Vec2 p{random.uniform(-2.0, kSide + 2.0), random.uniform(-2.0, kSide + 2.0)};
      const bool is_free =
          graph.grid.clearance(p) > radius + 0.1 && space.are_connected(p, {-2, -2});
      const auto is_near = [&](Vec2 other) { return norm(p - other) < 4.0 * radius; };
      if (!is_free || std::any_of(taken.begin(), taken.end(), is_near)) continue;
      taken.push_back(p);
      return p;
    }
  };
  for (int k = 0; k < robots; ++k) {
    const Vec2 position = place(), goal = place();
    scene.robots.push_back(robot_at(position, goal));
    scene.robots.back().radius = radius;
  }
  return scene;
}

/// 5 x 5 rooms of 8 m with a door of 1.5 m to each room beside them.
inline std::vector<Wall> rooms_with_doors() {
  constexpr double kRoom = 8.0, kDoor = 1.5, kSide = 40.0;
  std::vector<Wall> walls;
  for (int line = 0; line <= 5; ++line) {
    for (int room = 0; room < 5; ++room) {
      const double at = kRoom * line, from = kRoom * room, door = from + 0.5 * (kRoom - kDoor);
      const auto add = [&](double begin, double end) {
        walls.push_back({{at, begin}, {at, end}, 0.0}),
            walls.push_back({{begin, at}, {end, at}, 0.0});
      };
      const bool is_inner = at > 0.0 && at < kSide;
      add(from, is_inner ? door : from + kRoom);
      if (is_inner) add(door + kDoor, from + kRoom);
    }
  }
  return walls;
}

/// Up to twelve robots in each room, on their ways to other rooms.
inline Scenario crowd_at_doors(int robots, RightOfWay right_of_way) {
  Scenario scene;
  scene.obstacles = {pieces(rooms_with_doors())};
  scene.right_of_way = right_of_way;
  scene.max_neighbors = 10;
  const auto place = [](int room, int n) {
    return Vec2{8.0 * (room % 5) + 1.3 + 1.8 * (n % 4), 8.0 * (room / 5) + 1.7 + 2.3 * (n / 4)};
  };
  for (int k = 0; k < robots; ++k) {
    RobotSetup robot = robot_at(place(k % 25, k / 25), place((7 * k + 3) % 25, (k / 25 + 5) % 12));
    robot.position.x += 0.001 * k;
    robot.radius = 0.35;
    robot.preferred_speed = 1.5;
    scene.robots.push_back(robot);
  }
  return scene;
}

/// A step decides on what each robot perceives before it.
inline void expect_as_perceived(Simulation& simulation) {
  const auto ids = simulation.fleet().id;
  const std::vector<RobotId> robots(ids.begin(), ids.end());
  std::vector<Plan> plans;
  PlanWorkspace workspace;
  for (const RobotId robot : robots) {
    Simulation::Perception seen = simulation.perceive(robot);
    plans.push_back(
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &seen.detour, seen.walls));
  }
  simulation.step();
  for (std::size_t k = 0; k < robots.size(); ++k) {
    EXPECT_EQ(simulation.fleet().plan[k].new_velocity, plans[k].new_velocity) << k;
    EXPECT_EQ(simulation.fleet().plan[k].status, plans[k].status) << k;
  }
}

}  // namespace avo::test
