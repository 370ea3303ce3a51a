// SPDX-License-Identifier: Apache-2.0
// The cost of the C interface, compared with the same in C++. It measures a getter, a decision, and
// a frame of 1000 robots (a step, and reading all positions).
#include <algorithm>
#include <avo_c/avo.h>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <vector>

#include "avo/simulation.h"

namespace {

using Clock = std::chrono::steady_clock;

// Returns ns, of this thread: the time of the work itself, also on a busy machine.
double processor_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

constexpr int kRobots = 1000;

double nanoseconds(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::nano>(end - begin).count();
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void require(avo_result result) {
  if (result == AVO_OK) return;
  std::fprintf(stderr, "%s\n", avo_last_error());
  std::exit(1);
}

// Returns a place in a square full of robots, each on its way to the other side.
avo::Vec2 place(int k) {
  return {4.0 * (k % 32) + 0.1 * (k % 7), 4.0 * (k / 32) + 0.1 * (k % 5)};
}
avo::Vec2 goal(int k) {
  return avo::Vec2{124.0, 124.0} - place(k);
}

avo::Simulation simulation_of_cpp() {
  avo::Scenario scene;
  scene.max_neighbors = 10;
  for (int k = 0; k < kRobots; ++k) {
    avo::RobotSetup robot;
    robot.position = place(k);
    robot.goal = goal(k);
    scene.robots.push_back(robot);
  }
  return avo::Simulation(scene, 1);
}

avo_simulation_id simulation_of_c() {
  std::vector<avo_robot_def> robots(kRobots, avo_default_robot_def());
  for (int k = 0; k < kRobots; ++k) {
    robots[static_cast<std::size_t>(k)].position = {place(k).x, place(k).y};
    robots[static_cast<std::size_t>(k)].goal = {goal(k).x, goal(k).y};
  }
  avo_simulation_def def = avo_default_simulation_def();
  def.max_neighbors = 10;
  def.robots = robots.data();
  def.robot_count = robots.size();
  def.threads = 1;
  avo_simulation_id simulation;
  require(avo_create_simulation(&def, &simulation));
  return simulation;
}

double frame(avo::Simulation& simulation) {
  simulation.step();
  const avo::FleetView fleet = simulation.fleet();
  double sum = 0.0;
  for (std::size_t k = 0; k < fleet.id.size(); ++k)
    sum += fleet.position[k].x + fleet.position[k].y + static_cast<double>(fleet.id[k].value);
  return sum;
}

double frame(avo_simulation_id simulation) {
  avo_columns columns;
  require(avo_simulation_step(simulation));
  require(avo_simulation_columns(simulation, &columns));
  double sum = 0.0;
  for (std::size_t k = 0; k < columns.count; ++k)
    sum += columns.position[k].x + columns.position[k].y + static_cast<double>(columns.id[k].value);
  return sum;
}

// Both interfaces run the same robots, frame by frame in turns; the result is the ratio of their
// medians.
void frame_of_1000_robots(benchmark::State& state) {
  avo::Simulation cpp = simulation_of_cpp();
  const avo_simulation_id c = simulation_of_c();
  std::vector<double> of_cpp, of_c;
  bool cpp_first = false;
  for (auto _ : state) {
    cpp_first = !cpp_first;
    for (const bool is_cpp : {cpp_first, !cpp_first}) {
      const double begin = processor_time();
      benchmark::DoNotOptimize(is_cpp ? frame(cpp) : frame(c));
      (is_cpp ? of_cpp : of_c).push_back(processor_time() - begin);
    }
  }
  std::uint64_t hash = 0;
  require(avo_simulation_get_state_hash(c, &hash));
  if (hash != cpp.state_hash()) state.SkipWithError("other bits than in C++");
  require(avo_destroy_simulation(c));
  const double cpp_median = median(of_cpp), c_median = median(of_c);
  state.counters["cpp_us"] = cpp_median / 1e3;
  state.counters["c_us"] = c_median / 1e3;
  state.counters["c_to_cpp"] = c_median / cpp_median;
}
BENCHMARK(frame_of_1000_robots)->Iterations(400)->Repetitions(5)->Unit(benchmark::kMillisecond);

// Reads a robot's values by its id, of 1000 in a scattered order. The result is the median of 10^6
// calls, minus the time of reading the clock.
template <typename Value>
void get(benchmark::State& state, avo_result (*getter)(avo_simulation_id, avo_robot_id, Value*),
         Value value) {
  const avo_simulation_id simulation = simulation_of_c();
  const auto gone = static_cast<std::uint64_t>(state.range(0));
  for (std::uint64_t k = 0; k < gone; ++k)
    require(avo_simulation_remove_robot(simulation, {2 * k + 1}));
  require(avo_simulation_step(simulation));
  avo_columns columns;
  require(avo_simulation_columns(simulation, &columns));
  constexpr int kCalls = 1'000'000;
  std::vector<double> calls, clock;
  for (auto _ : state) {
    std::uint64_t number = 1;
    for (int k = 0; k < kCalls; ++k) {
      number = number * 6364136223846793005u + 1442695040888963407u;
      const avo_robot_id robot = columns.id[(number >> 33) % columns.count];
      const Clock::time_point begin = Clock::now();
      const avo_result result = getter(simulation, robot, &value);
      benchmark::DoNotOptimize(value);
      const Clock::time_point end = Clock::now();
      calls.push_back(nanoseconds(begin, end));
      clock.push_back(nanoseconds(end, Clock::now()));
      require(result);
    }
  }
  require(avo_destroy_simulation(simulation));
  state.counters["with_clock_ns"] = median(calls);
  state.counters["median_ns"] = median(calls) - median(clock);
}

void get_position(benchmark::State& state) {
  get(state, avo_simulation_get_position, avo_vec2{});
}
// number of robots that have left: then ids differ from places
BENCHMARK(get_position)->Arg(0)->Arg(1)->Arg(500)->Iterations(1);

// the largest of all values
void get_robot_def(benchmark::State& state) {
  get(state, avo_simulation_get_robot_def, avo_default_robot_def());
}
BENCHMARK(get_robot_def)->Arg(0)->Iterations(1);

// The same without a clock between the calls: the mean of the calls.
void get_positions(benchmark::State& state) {
  const avo_simulation_id simulation = simulation_of_c();
  require(avo_simulation_step(simulation));
  std::uint64_t number = 1;
  for (auto _ : state) {
    avo_vec2 position;
    number = number % kRobots + 1;
    benchmark::DoNotOptimize(avo_simulation_get_position(simulation, {number}, &position));
    benchmark::DoNotOptimize(position);
  }
  require(avo_destroy_simulation(simulation));
}
BENCHMARK(get_positions);

}  // namespace
