// SPDX-License-Identifier: Apache-2.0
// Time of one exact half-plane (Eqs. 15, 16) with the paper's limits, by kind of situation.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "avo/half_plane.h"

namespace avo {
namespace {

constexpr double kReach = 8.0;  // δ (a_A + a_B) = 4 (1 + 1) m/s
constexpr double kSumOfRadii = 1.0;

double uniform(std::uint64_t& state, double a, double b) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
}

// Distances `near` to `far`, both robots with speeds up to 2 m/s.
Pair random_pair(std::uint64_t& state, double near, double far) {
  const auto direction = [&] {
    const double angle = uniform(state, 0.0, 2.0 * std::numbers::pi);
    return Vec2{std::cos(angle), std::sin(angle)};
  };
  const Vec2 p = uniform(state, near, far) * direction();
  const Vec2 v_A = uniform(state, 0.0, 2.0) * direction();
  return {p, v_A - uniform(state, 0.0, 2.0) * direction(), kSumOfRadii};
}

// The cases of the closed form: the disc of τ decides (tip); the robots close in and would hit
// (convex); neither (horn).
enum class Kind { mixed, tip, convex, horn };

Kind kind_of(const Pair& pair, const Horizon& horizon) {
  const Vec2 tip = pair.position + horizon.end().time * pair.velocity;
  const Vec2 n = tip / norm(tip);
  const Vec2 tangent = pair.position + horizon.end().lag * pair.velocity;
  if (dot(n, pair.position) >= pair.radius && dot(n, tangent) >= pair.radius) return Kind::tip;
  const double miss = std::abs(cross(pair.position, pair.velocity)) / norm(pair.velocity);
  const bool closing = dot(pair.position, pair.velocity) < 0.0;
  return closing && miss < pair.radius ? Kind::convex : Kind::horn;
}

void half_planes(benchmark::State& state, Kind kind, double near, double far) {
  const Horizon horizon(4.0, 10.0, 0.1);
  std::uint64_t seed = 2011;
  std::vector<Pair> pairs;
  while (pairs.size() < 4096) {  // so many that no branch can be learned
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
