// SPDX-License-Identifier: Apache-2.0
// Time of one linear program (Eqs. 22, 23) with the paper's limits: one robot at a time, and many
// in lanes (lanes/half-planes/infeasible per cent; ns per robot is real_time).
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "lp/linear_program.h"
#include "lp/programs.h"

namespace avo {
namespace {

struct Program {
  std::vector<HalfPlane> soft;
  Disc acceleration;
  Vec2 preferred;
};

double uniform(std::uint64_t& state, double a, double b) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
}

// Returns 1024 programs of `planes` half-planes with offsets around `crowd`, so that the branches
// differ from call to call; `radius`: of the acceleration disc.
std::vector<Program> programs(int planes, double crowd, double radius) {
  std::uint64_t state = 2011;
  const auto direction = [&] {
    const double angle = uniform(state, 0.0, 2.0 * std::numbers::pi);
    return Vec2{std::cos(angle), std::sin(angle)};
  };
  std::vector<Program> all(1024);
  for (Program& p : all) {
    const Vec2 v = uniform(state, 0.0, 2.0) * direction();
    p.acceleration = {v, radius};
    p.preferred = 2.0 * direction();
    for (int k = 0; k < planes; ++k) {
      const Vec2 n = direction();
      p.soft.push_back({n, dot(n, v) + uniform(state, crowd - 0.5, crowd + 0.5)});
    }
  }
  return all;
}

void solve(benchmark::State& state, int planes, double crowd, double radius,
           ProgramState expected) {
  std::vector<Program> all;
  ProgramRows scratch;
  for (Program& p : programs(planes, crowd, radius)) {
    if (nearest_point(p.soft, p.acceleration, 2.0, p.preferred, scratch).state == expected) {
      all.push_back(p);
    }
  }
  if (all.empty()) return state.SkipWithError("no program ends in this state");
  std::size_t k = 0;
  for (auto _ : state) {
    const Program& p = all[k];
    k = k + 1 < all.size() ? k + 1 : 0;
    benchmark::DoNotOptimize(nearest_point(p.soft, p.acceleration, 2.0, p.preferred, scratch));
  }
  state.counters["programs"] = static_cast<double>(all.size());
}

BENCHMARK_CAPTURE(solve, free_10, 10, -3.0, 4.0, ProgramState::optimal);
BENCHMARK_CAPTURE(solve, feasible_10, 10, -0.9, 4.0, ProgramState::optimal);
BENCHMARK_CAPTURE(solve, feasible_10_crossing_discs, 10, -0.9, 1.5, ProgramState::optimal);
BENCHMARK_CAPTURE(solve, least_unsafe_10, 10, -0.2, 4.0, ProgramState::least_unsafe);
BENCHMARK_CAPTURE(solve, least_unsafe_10_crossing_discs, 10, -0.2, 1.5, ProgramState::least_unsafe);
BENCHMARK_CAPTURE(solve, least_unsafe_50, 50, -0.2, 4.0, ProgramState::least_unsafe);

// Returns 1024 programs, of which `infeasible` per cent have no solution, shuffled.
std::vector<Program> mixed(int planes, int infeasible) {
  ProgramRows scratch;
  const std::vector<Program> feasible = programs(planes, -0.9, 4.0);
  std::vector<Program> all, none;
  for (const Program& p : programs(planes, -0.2, 4.0)) {
    if (nearest_point(p.soft, p.acceleration, 2.0, p.preferred, scratch).state ==
        ProgramState::least_unsafe) {
      none.push_back(p);
    }
  }
  std::uint64_t state = 7;
  for (std::size_t k = 0; k < feasible.size(); ++k) {
    const bool empty = uniform(state, 0.0, 100.0) < infeasible;
    all.push_back(empty ? none[k % none.size()] : feasible[k]);
  }
  return all;
}

void lanes(benchmark::State& state) {
  const std::vector<Program> all =
      mixed(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::vector<ProgramBatch> batches(all.size() / 256);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ProgramBatch& batch = batches[k / 256];
    batch.add(all[k].acceleration, 2.0, all[k].preferred, all[k].soft);
  }
  std::size_t settled = 0;
  for (ProgramBatch& batch : batches) {
    nearest_points(batch);
    for (std::size_t k = 0; k < batch.size(); ++k) settled += batch.settled(k);
  }
  std::size_t k = 0;
  while (state.KeepRunningBatch(256)) {
    nearest_points(batches[k]);
    k = k + 1 < batches.size() ? k + 1 : 0;
  }
  state.counters["settled"] = static_cast<double>(settled) / static_cast<double>(all.size());
}

void fill(benchmark::State& state) {
  const std::vector<Program> all = mixed(static_cast<int>(state.range(0)), 0);
  ProgramBatch batch;
  while (state.KeepRunningBatch(256)) {
    batch.clear();
    for (std::size_t k = 0; k < 256; ++k) {
      batch.add(all[k].acceleration, 2.0, all[k].preferred, all[k].soft);
    }
    benchmark::DoNotOptimize(batch.size());
  }
}

BENCHMARK(lanes)->ArgsProduct({{4, 10, 32}, {0, 5, 50}});
BENCHMARK(fill)->Arg(10);

}  // namespace
}  // namespace avo
