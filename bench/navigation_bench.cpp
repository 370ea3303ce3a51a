// SPDX-License-Identifier: Apache-2.0
// The cost of goals and edits on large maps: one new goal, and one obstacle more and less.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "avo/simulation.h"
#include "navigation/clearance_grid.h"

namespace avo {
namespace {

enum Map : std::int64_t { blocks, shelves, walls, trees };

struct World {
  Scenario scene;
  double side = 0.0, radius = 0.0;  // m
  ClearanceGrid grid;
  std::vector<Vec2> solid;  // m, lower left and upper right corners in turns
  std::mt19937_64 random{7};

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  void add_box(Vec2 low, Vec2 size) {
    StaticObstacle box;
    box.chains = {{{low, low + Vec2{size.x, 0}, low + size, low + Vec2{0, size.y}}, true}};
    scene.obstacles.push_back(box);
    solid.push_back(low), solid.push_back(low + size);
  }
  Vec2 free_place() {
    while (true) {
      const Vec2 p{uniform(1.0, side - 1.0), uniform(1.0, side - 1.0)};
      bool is_inside = false;
      for (std::size_t k = 0; k < solid.size(); k += 2)
        is_inside = is_inside || (p.x > solid[k].x && p.x < solid[k + 1].x && p.y > solid[k].y &&
                                  p.y < solid[k + 1].y);
      if (!is_inside && grid.has_room(p, radius + 0.06)) return p;
    }
  }
};

// Returns 600 blocks or 4800 shelves on 512 x 512 m, 4160 walls of 1 m at random, or 1000 trees.
World world_of(std::int64_t map, int robots) {
  World world;
  world.radius = map == shelves ? 0.3 : 0.5;
  world.side = map == walls ? 220.0 : map == trees ? 200.0 : 512.0;
  if (map == blocks) {
    for (int k = 0; k < 600; ++k)
      world.add_box({20.3 * (k / 24) + world.uniform(4, 7), 21.1 * (k % 24) + world.uniform(4, 7)},
                    {world.uniform(6, 14), world.uniform(6, 14)});
  } else if (map == shelves) {
    for (double y = 6.0; y < 507.0; y += 4.0)
      for (double x = 6.0; x < 498.0; x += 13.0) world.add_box({x, y}, {10, 1});
  } else {
    for (int k = 0; k < (map == walls ? 4160 : 1000); ++k) {
      const Vec2 p{world.uniform(0, world.side), world.uniform(0, world.side)};
      const double angle = world.uniform(0, 2.0 * std::numbers::pi);
      StaticObstacle one;
      one.chains = {{{p}, false}};
      if (map == walls)
        one.chains[0].points.push_back(p + Vec2{std::cos(angle), std::sin(angle)});
      else
        one.radius = world.uniform(0.15, 0.5);
      world.scene.obstacles.push_back(one);
    }
  }
  world.grid = ClearanceGrid(walls_of(world.scene.obstacles), 1.0);
  for (int k = 0; k < robots; ++k) {
    RobotSetup robot;
    robot.radius = world.radius;
    robot.position = world.free_place(), robot.goal = world.free_place();
    world.scene.robots.push_back(robot);
  }
  world.scene.allow_broken_assumptions = true;  // some robots may begin too near to each other
  return world;
}

double since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void count(benchmark::State& state, std::vector<double> taken) {
  std::sort(taken.begin(), taken.end());
  state.counters["median_ms"] = taken[taken.size() / 2];
  state.counters["most_ms"] = taken.back();
}

// Sets 400 goals for one robot, one after the other; the first goals find the edges that they need.
void set_goal_on_map(benchmark::State& state) {
  World world = world_of(state.range(0), 1);
  Simulation simulation(world.scene, 1);
  std::vector<double> taken;
  for (auto _ : state) {
    const Vec2 goal = world.free_place();
    const auto begin = std::chrono::steady_clock::now();
    simulation.set_goal(RobotId{0}, goal);
    taken.push_back(since(begin));
    state.SetIterationTime(1e-3 * taken.back());
  }
  count(state, taken);
}
BENCHMARK(set_goal_on_map)
    ->ArgName("map")
    ->DenseRange(blocks, trees)
    ->Iterations(400)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// As many robots set out as there are goals.
void set_out_on_blocks(benchmark::State& state) {
  const World world = world_of(blocks, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(Simulation(world.scene, 1));
}
BENCHMARK(set_out_on_blocks)
    ->ArgName("robots")
    ->Arg(100)
    ->Arg(1000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// A short wall is added, and removed again; 100 robots are in motion.
void edit_of_map(benchmark::State& state) {
  World world = world_of(state.range(0), 100);
  Simulation simulation(world.scene, 1);
  std::vector<double> taken;
  for (auto _ : state) {
    StaticObstacle wall;
    Vec2 place;
    const auto is_near = [&](const RobotSetup& robot) {
      return norm(robot.position - place) < 5.0;
    };
    do {
      place = world.free_place();
    } while (std::any_of(world.scene.robots.begin(), world.scene.robots.end(), is_near));
    wall.chains = {{{place, place + Vec2{0.3, 0.0}}, false}};
    const auto begin = std::chrono::steady_clock::now();
    const ObstacleId id = simulation.add_obstacle(wall);
    taken.push_back(since(begin));
    simulation.remove_obstacle(id);
    state.SetIterationTime(1e-3 * taken.back());
  }
  count(state, taken);
}
BENCHMARK(edit_of_map)
    ->ArgName("map")
    ->DenseRange(blocks, trees)
    ->Iterations(15)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace avo
