// SPDX-License-Identifier: Apache-2.0
// Time of one robot's decision, and of a step of Circle-N, single steps and the whole crossing.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <numbers>
#include <vector>

#include "avo/simulation.h"

namespace avo {
namespace {

// The paper's Circle-N (§VI-B): every robot's goal is opposite; ten nearest neighbors.
Scenario circle(int count, Method method) {
  Scenario scene;
  scene.method = method;
  scene.max_neighbors = 10;
  const double radius = std::max(20.0, 2.25 * count / (2.0 * std::numbers::pi));
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    RobotSetup robot;
    robot.position = radius * Vec2{std::cos(angle), std::sin(angle)};
    robot.goal = -robot.position;
    scene.robots.push_back(robot);
  }
  return scene;
}

// 0: the paper alone, δ 4, τ 10; 1: avo, with its certificate.
Method method_of(std::int64_t number) {
  return number == 0 ? Method::avo_paper : Method::avo;
}

// Returns what the robots of Circle-N see after `seconds`.
std::vector<Simulation::Perception> crowd(int count, double seconds, Simulation& simulation) {
  while (simulation.time() < seconds) simulation.step();
  std::vector<Simulation::Perception> seen;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    seen.push_back(simulation.perceive({i}));
  }
  return seen;
}

// Measures one decision: in Circle-1000 on the way (20 s) and amid the crowd (170 s). Ten neighbors
// get a half-plane; a certificate looks at all neighbors within the sensing radius.
void plan(benchmark::State& state) {
  Simulation simulation(circle(1000, method_of(state.range(1))), 1);
  const std::vector<Simulation::Perception> seen =
      crowd(1000, static_cast<double>(state.range(0)), simulation);
  const Planner& planner = simulation.planner();
  PlanWorkspace workspace;
  std::size_t i = 0, least_unsafe = 0, decisions = 0;
  for (auto _ : state) {
    Detour detour = seen[i].detour;
    const Plan plan = planner.plan(seen[i].robot, seen[i].neighbors, workspace, &detour);
    benchmark::DoNotOptimize(plan);
    least_unsafe += plan.violation > 0.0 ? 1 : 0;
    ++decisions;
    i = (i + 1) % seen.size();
  }
  state.counters["infeasible"] = static_cast<double>(least_unsafe) / static_cast<double>(decisions);
}
BENCHMARK(plan)
    ->ArgNames({"s", "avo"})
    ->ArgsProduct({{20, 170}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

// Measures the steps from `seconds` on, on one thread; the scene advances with them.
void step_of_circle(benchmark::State& state) {
  const auto count = static_cast<int>(state.range(0));
  const auto seconds = static_cast<double>(state.range(1));
  Simulation simulation(circle(count, method_of(state.range(2))), 1);
  while (simulation.time() < seconds) simulation.step();
  for (auto _ : state) simulation.step();
}
BENCHMARK(step_of_circle)
    ->ArgNames({"robots", "s", "avo"})
    ->ArgsProduct({{100}, {0, 10, 18, 30}, {0, 1}})
    ->ArgsProduct({{1000}, {0, 60, 120, 180}, {0, 1}})
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond);

double quantile(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

// Measures every step of the crossing on one thread, until all have arrived; it takes at most one
// and a half times the straight line's time. The median is the figure to compare. CPU time is
// reported because it does not count other programs.
void crossing_of_circle(benchmark::State& state) {
  const Scenario scene = circle(static_cast<int>(state.range(0)), method_of(state.range(1)));
  const double straight = 2.0 * norm(scene.robots[0].goal) / scene.robots[0].preferred_speed;
  std::vector<double> elapsed, cpu;  // ms
  for (auto _ : state) {
    elapsed.clear();
    cpu.clear();
    Simulation simulation(scene, 1);
    while (!simulation.all_at_goal() && simulation.time() < 1.5 * straight) {
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t cpu_start = std::clock();
      simulation.step();
      cpu.push_back(1e3 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC);
      const std::chrono::duration<double, std::milli> taken =
          std::chrono::steady_clock::now() - start;
      elapsed.push_back(taken.count());
    }
  }
  std::sort(elapsed.begin(), elapsed.end());
  std::sort(cpu.begin(), cpu.end());
  state.counters["steps"] = static_cast<double>(elapsed.size());
  state.counters["median_ms"] = quantile(elapsed, 0.5);
  state.counters["median_cpu_ms"] = quantile(cpu, 0.5);
  state.counters["p95_cpu_ms"] = quantile(cpu, 0.95);
  state.counters["max_cpu_ms"] = cpu.back();
}
BENCHMARK(crossing_of_circle)
    ->ArgNames({"robots", "avo"})
    ->ArgsProduct({{100, 1000}, {0, 1}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace avo
