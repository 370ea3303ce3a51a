// SPDX-License-Identifier: Apache-2.0
// Time of a half-plane (Eqs. 15, 16) in batches of 640, by kind of situation. AVO_SIMD sets the
// instruction set.
#include <benchmark/benchmark.h>
#include <cstdint>
#include <vector>

#include "avo/simd.h"
#include "obstacles/half_planes.h"
#include "pairs.h"

namespace avo {
namespace {

constexpr std::size_t kBatch = 640;  // ten neighbors of 64 robots
constexpr std::size_t kBatches = 8;

void batch(benchmark::State& state, Kind kind, double near, double far, double delta, double tau) {
  const Horizon horizon(delta, tau, 0.1);
  std::uint64_t seed = 2011;
  std::vector<PairColumns> batches(kBatches);
  for (PairColumns& pairs : batches) {
    pairs.reserve(kBatch);
    while (pairs.count < kBatch) {
      const Pair pair = random_pair(seed, near, far);
      if (kind != Kind::mixed && kind_of(pair, horizon) != kind) continue;
      pairs.add(pair.position, pair.velocity, pair.radius, 2.0 * delta);
    }
  }
  HalfPlaneWorkspace workspace;
  PlaneColumns planes;
  std::size_t k = 0;
  HalfPlaneCases all;
  for (auto _ : state) {
    half_planes(batches[k], horizon, workspace, planes);
    benchmark::DoNotOptimize(planes.h.data());
    all.tip += workspace.cases.tip, all.convex += workspace.cases.convex;
    all.horn += workspace.cases.horn, all.follow += workspace.cases.follow,
        all.contact += workspace.cases.contact;
    all.rest += workspace.cases.rest;
    k = (k + 1) % kBatches;
  }
  const auto pairs = static_cast<double>(state.iterations()) * static_cast<double>(kBatch);
  state.SetItemsProcessed(static_cast<std::int64_t>(pairs));
  state.counters["ns"] =
      benchmark::Counter(pairs * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["contact"] = static_cast<double>(all.contact) / pairs;
  state.counters["tip"] = static_cast<double>(all.tip) / pairs;
  state.counters["convex"] = static_cast<double>(all.convex) / pairs;
  state.counters["horn"] = static_cast<double>(all.horn) / pairs;
  state.counters["follow"] = static_cast<double>(all.follow) / pairs;
  state.counters["rest"] = static_cast<double>(all.rest) / pairs;
  state.SetLabel(simd_target());
}

BENCHMARK_CAPTURE(batch, mixed_1_to_7_m, Kind::mixed, 1.0, 7.0, 4.0, 10.0);
BENCHMARK_CAPTURE(batch, mixed_1_to_15_m, Kind::mixed, 1.0, 15.0, 4.0, 10.0);
BENCHMARK_CAPTURE(batch, crowd_1_to_15_m, Kind::mixed, 1.0, 15.0, 2.0, 3.0);
BENCHMARK_CAPTURE(batch, dense_1_to_2_m, Kind::mixed, 1.0, 2.0, 4.0, 10.0);
BENCHMARK_CAPTURE(batch, tip, Kind::tip, 1.0, 7.0, 4.0, 10.0);
BENCHMARK_CAPTURE(batch, convex, Kind::convex, 1.0, 7.0, 4.0, 10.0);
BENCHMARK_CAPTURE(batch, horn, Kind::horn, 1.0, 7.0, 4.0, 10.0);

}  // namespace
}  // namespace avo
