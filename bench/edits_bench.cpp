// SPDX-License-Identifier: Apache-2.0
// What a host's edits cost between two steps: goals of thousands of robots, robots that come and go
// by arrays, and frames of 60 Hz in which some robots are exchanged.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

#include "avo/simulation.h"

namespace avo {
namespace {

// ms, of this thread: the time of the work itself, also on a busy machine.
double processor_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// A field of robots, 2.5 m apart, of several speeds. Each crosses it to the other side.
std::vector<RobotSetup> field(int count) {
  constexpr int kRow = 50;
  std::vector<RobotSetup> robots;
  for (int k = 0; k < count; ++k) {
    RobotSetup robot;
    robot.position = {2.5 * (k % kRow), 2.5 * (k / kRow)};
    robot.goal = {2.5 * (kRow - 1 - k % kRow), robot.position.y};
    robot.max_speed = robot.preferred_speed = 1.0 + 0.01 * (k % 97);
    robots.push_back(robot);
  }
  return robots;
}

Simulation simulation_of(int count) {
  Scenario scene;
  scene.max_neighbors = 10;
  scene.sensing_radius = 20.0;
  scene.robots = field(count);
  return Simulation(scene, 1);
}

std::vector<RobotId> ids_of(const Simulation& simulation) {
  const auto ids = simulation.fleet(Columns::id).id;
  return {ids.begin(), ids.end()};
}

std::vector<Vec2> goals_of(int count, double aside) {
  std::vector<Vec2> goals;
  for (const RobotSetup& robot : field(count)) goals.push_back(robot.goal + Vec2{0.0, aside});
  return goals;
}

// New goals for all robots by one call.
void set_goals(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  Simulation simulation = simulation_of(count);
  const std::vector<RobotId> ids = ids_of(simulation);
  const std::vector<Vec2> goals[] = {goals_of(count, 0.5), goals_of(count, -0.5)};
  std::size_t turn = 0;
  for (auto _ : state) simulation.set_goals(ids, goals[++turn % 2]);
}
BENCHMARK(set_goals)->Arg(2000)->Arg(8000)->Unit(benchmark::kMillisecond);

// A look at each robot and a goal for it, in turn: it takes no longer for each in a large fleet.
void look_and_set_goal(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  Simulation simulation = simulation_of(count);
  const std::vector<RobotId> ids = ids_of(simulation);
  double aside = 0.5;
  for (auto _ : state) {
    aside = -aside;
    for (const RobotId id : ids) {
      const RobotState robot = simulation.robot(id);
      simulation.set_goal(id, robot.position + Vec2{20.0, aside});
    }
  }
}
BENCHMARK(look_and_set_goal)->Arg(2000)->Arg(8000)->Unit(benchmark::kMillisecond);

// Robots come to a fleet of one robot, and go again: each half by one call.
void spawn(benchmark::State& state) {
  std::vector<RobotSetup> robots = field(static_cast<int>(state.range(0)));
  for (RobotSetup& robot : robots) robot.position.x += 10.0;
  Simulation simulation = simulation_of(1);
  double going = 0.0;  // ms
  for (auto _ : state) {
    const double begin = processor_time();
    const std::vector<RobotId> ids = simulation.add_robots(robots);
    const double added = processor_time();
    simulation.remove_robots(ids);
    going += processor_time() - added;
    state.SetIterationTime(1e-3 * (added - begin));
  }
  state.counters["removed_ms"] = benchmark::Counter(going, benchmark::Counter::kAvgIterations);
}
BENCHMARK(spawn)->Arg(2000)->Arg(8000)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Takes `count` robots out, and puts others with other goals into their places and motion.
void exchange(Simulation& simulation, std::size_t count) {
  const std::vector<RobotId> all = ids_of(simulation);
  std::vector<RobotId> gone;
  std::vector<RobotSetup> come;
  for (std::size_t k = 0; k < count; ++k) {
    gone.push_back(all[k]);
    RobotSetup robot = simulation.setup(gone.back());
    robot.goal = {robot.position.x > 60.0 ? 0.0 : 122.5, robot.goal.y};
    come.push_back(robot);
  }
  simulation.remove_robots(gone);
  simulation.add_robots(come);
}

// Frames of a game at 60 Hz, of 16.7 ms each: some robots are exchanged, and all decide.
void frames_with_exchange(benchmark::State& state) {
  const int robots = static_cast<int>(state.range(0));
  const auto exchanged = static_cast<std::size_t>(state.range(1));
  Scenario scene;
  scene.max_neighbors = 10;
  scene.sensing_radius = 20.0;
  scene.time_step = 1.0 / 60.0;
  scene.robots = field(robots);
  Simulation simulation(scene, 1);
  double edits = 0.0, longest = 0.0;  // ms
  for (auto _ : state) {
    const double begin = processor_time();
    exchange(simulation, exchanged);
    const double edited = processor_time();
    simulation.step();
    const double frame = processor_time() - begin;
    edits += edited - begin, longest = std::max(longest, frame);
    state.SetIterationTime(1e-3 * frame);
  }
  state.counters["edits_ms"] = benchmark::Counter(edits, benchmark::Counter::kAvgIterations);
  state.counters["longest_ms"] = longest;
}
BENCHMARK(frames_with_exchange)
    ->Args({2000, 0})
    ->Args({2000, 100})
    ->Iterations(300)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace avo
