// SPDX-License-Identifier: Apache-2.0
// Time to index n robots and to find the ten nearest of each within the sensing radius. Points are
// in any order, or in the order of their cells, as a step keeps them.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <vector>

#include "spatial/point_grid.h"

namespace avo {
namespace {

// Returns positions such that about `crowd` of n robots are within the radius of each.
std::vector<Vec2> random_positions(int n, double crowd) {
  const double side = std::sqrt(3.14159 * n / crowd);
  std::uint64_t random = 2011;
  const auto coordinate = [&] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return side * (static_cast<double>(random >> 11) * 0x1p-53);
  };
  std::vector<Vec2> positions;
  for (int i = 0; i < n; ++i) {
    const double x = coordinate();
    positions.push_back({x, coordinate()});
  }
  return positions;
}

void in_order_of_cells(std::vector<Vec2>& positions) {
  PointGrid grid;
  grid.build(positions, 1.0);
  std::vector<Vec2> ordered;
  for (const std::uint32_t i : grid.order()) ordered.push_back(positions[i]);
  positions = ordered;
}

void index_and_gather(benchmark::State& state, double crowd, bool ordered) {
  const auto n = static_cast<int>(state.range(0));
  std::vector<Vec2> positions = random_positions(n, crowd);
  if (ordered) in_order_of_cells(positions);
  PointGrid grid;
  SearchScratch scratch;
  for (auto _ : state) {
    grid.build(positions, 1.0);
    for (int i = 0; i < n; ++i) {
      benchmark::DoNotOptimize(
          grid.gather(positions[static_cast<std::size_t>(i)], i, 10, scratch).data());
    }
  }
  state.counters["robots/s"] = benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(index_and_gather, ten_within, 10.0, false)->Arg(1000)->Arg(100000);
BENCHMARK_CAPTURE(index_and_gather, ten_within_ordered, 10.0, true)->Arg(1000)->Arg(100000);
BENCHMARK_CAPTURE(index_and_gather, hundred_within, 100.0, false)->Arg(1000)->Arg(100000);
BENCHMARK_CAPTURE(index_and_gather, hundred_within_ordered, 100.0, true)->Arg(1000)->Arg(100000);

void index_only(benchmark::State& state) {
  std::vector<Vec2> positions;
  positions.reserve(100000);
  for (int i = 0; i < 100000; ++i) positions.push_back({std::fmod(i * 0.618, 300.0), i * 0.003});
  PointGrid grid;
  for (auto _ : state) {
    grid.build(positions, 1.0);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(index_only);

}  // namespace
}  // namespace avo
