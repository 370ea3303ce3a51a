// SPDX-License-Identifier: Apache-2.0
// Time of one exact half-plane (Eqs. 15, 16) with the paper's limits, by kind of situation.
#include <benchmark/benchmark.h>
#include <cstdint>
#include <vector>

#include "pairs.h"

namespace avo {
namespace {

constexpr double kReach = 8.0;  // δ (a_A + a_B) = 4 (1 + 1) m/s

void half_planes(benchmark::State& state, Kind kind, double near, double far) {
  const Horizon horizon(4.0, 10.0, 0.1);
  std::uint64_t seed = 2011;
  std::vector<Pair> pairs;
  while (pairs.size() < 4096) {  // so many that branch prediction cannot learn them
    const Pair pair = random_pair(seed, near, far);
    if (kind == Kind::mixed || kind_of(pair, horizon) == kind) pairs.push_back(pair);
  }
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(half_plane(pairs[k], kReach, horizon));
    k = (k + 1) % pairs.size();
  }
}

BENCHMARK_CAPTURE(half_planes, mixed_1_to_7_m, Kind::mixed, 1.0, 7.0);
BENCHMARK_CAPTURE(half_planes, mixed_1_to_15_m, Kind::mixed, 1.0, 15.0);
BENCHMARK_CAPTURE(half_planes, dense_1_to_2_m, Kind::mixed, 1.0, 2.0);
BENCHMARK_CAPTURE(half_planes, tip, Kind::tip, 1.0, 7.0);
BENCHMARK_CAPTURE(half_planes, convex, Kind::convex, 1.0, 7.0);
BENCHMARK_CAPTURE(half_planes, horn, Kind::horn, 1.0, 7.0);

}  // namespace
}  // namespace avo
