// SPDX-License-Identifier: Apache-2.0
// Time of the other parts of a robot-step: the preferred velocity, the wish among ten neighbors,
// one step of motion.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "planner/decision_columns.h"
#include "planner/rules/arrival.h"
#include "sim/columns/moving_columns.h"

namespace avo {
namespace {

constexpr std::size_t kRobots = 1024;  // so many that branch prediction cannot learn them
constexpr std::size_t kNeighbors = 10;

double uniform(std::uint64_t& state, double a, double b) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
}

Vec2 in_ring(std::uint64_t& state, double near, double far) {
  const double angle = uniform(state, 0.0, 2.0 * std::numbers::pi);
  return uniform(state, near, far) * Vec2{std::cos(angle), std::sin(angle)};
}

// A moving or arriving robot, and ten neighbors 1 to 7 m away.
struct Scene {
  Robot robot;
  Vec2 goal;
  std::vector<Neighbor> neighbors;
  Plan plan;
};

std::vector<Scene> scenes(const Planner& planner) {
  std::uint64_t state = 2011;
  const StepResponse step = step_response(planner);
  std::vector<Scene> all(kRobots);
  for (Scene& scene : all) {
    Robot& robot = scene.robot;
    robot.velocity = in_ring(state, 0.0, 1.5);
    scene.goal = in_ring(state, 0.0, 20.0);
    scene.plan.new_velocity = in_ring(state, 0.0, 1.5);
    const RobotTraits traits{robot.radius, robot.max_speed, robot.max_acceleration, 1.5};
    robot.preferred_velocity =
        preferred_velocity(robot.position, robot.velocity, traits, scene.goal, step);
    for (std::size_t k = 0; k < kNeighbors; ++k) {
      scene.neighbors.push_back({in_ring(state, 1.0, 7.0), in_ring(state, 0.0, 1.5), 0.5, 1.0, {}});
    }
  }
  return all;
}

// Measures action(scene), for one scene after the other.
template <typename Action>
void run(benchmark::State& state, const Planner& planner, Action action) {
  const std::vector<Scene> all = scenes(planner);
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(action(all[k]));
    k = (k + 1) % kRobots;
  }
}

struct MovedTile {
  RobotColumns robots;
  MovingColumns moving;
};

// Measures action() for one robot of a tile after the other; a whole tile is one iteration.
template <typename Action>
void run_tiles(benchmark::State& state, const Planner& planner, Action action) {
  const std::vector<Scene> all = scenes(planner);
  std::vector<MovedTile> tiles(kRobots / kTileRobots);
  for (std::size_t i = 0; i < kRobots; ++i) {
    const auto& [robot, goal, neighbors, plan] = all[i];
    auto& [robots, moving] = tiles[i / kTileRobots];
    robots.reserve(kTileRobots);
    const std::size_t k = robots.count;
    robots.add(robot, {});
    moving.goal_x[k] = goal.x, moving.goal_y[k] = goal.y, moving.preferred_speed[k] = 1.5;
    moving.new_x[k] = plan.new_velocity.x, moving.new_y[k] = plan.new_velocity.y;
  }
  std::size_t k = 0;
  MovedTile tile;
  for (auto _ : state) {
    tile = tiles[k];
    benchmark::DoNotOptimize(action(tile));
    k = (k + 1) % tiles.size();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kTileRobots));
}

void motion_of_tile(benchmark::State& state) {
  const Planner planner({});
  const StepResponse response = step_response(planner);
  run_tiles(state, planner,
            [&](MovedTile& tile) { return advance(response, tile.moving, tile.robots); });
}
BENCHMARK(motion_of_tile);

void ways_of_tile(benchmark::State& state) {
  const Planner planner({});
  const StepResponse step = step_response(planner);
  run_tiles(state, planner, [&](MovedTile& tile) {
    choose_preferred(step, tile.moving, tile.robots);
    return tile.robots.preferred_x[0];
  });
}
BENCHMARK(ways_of_tile);

void towards_goal(benchmark::State& state) {
  const Planner planner({});
  const StepResponse step = step_response(planner);
  run(state, planner, [&](const Scene& scene) {
    const Robot& robot = scene.robot;
    const RobotTraits traits{robot.radius, robot.max_speed, robot.max_acceleration, 1.5};
    return preferred_velocity(robot.position, robot.velocity, traits, scene.goal, step);
  });
}
BENCHMARK(towards_goal);

void wish_among_ten(benchmark::State& state) {
  const Planner planner({});
  NeighborColumns seen;
  RobotColumns robots;
  DecisionColumns columns;
  robots.reserve(1);
  columns.reserve(1);
  run(state, planner, [&](const Scene& scene) {
    robots.clear();
    robots.add(scene.robot, in_columns(scene.neighbors, seen));
    look_around(robots, columns);
    keep_right(robots, columns);
    Detour detour;
    const Traffic traffic = columns.traffic(0);
    const PushRule rule = push_rule(scene.robot, traffic.is_beside, planner.options(), detour);
    return wish_of(scene.robot, columns.wish(0), traffic, rule);
  });
}
BENCHMARK(wish_among_ten);

}  // namespace
}  // namespace avo
