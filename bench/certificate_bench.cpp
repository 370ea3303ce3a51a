// SPDX-License-Identifier: Apache-2.0
// Time of the certificate alone: the constraints of ten near neighbors, one admission, and a whole
// choice that is admitted at once or refused.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "planner/stages/certified.h"
#include "planner/stages/certify.h"

namespace avo {
namespace {

constexpr int kNeighbors = 10;
constexpr double kSpeed = 1.5;

double uniform(std::uint64_t& state, double a, double b) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
}

// A moving robot among neighbors within 5 m; it is about to drive into them, or they move along
// with it.
struct Scene {
  Robot robot;
  std::vector<Neighbor> neighbors;
  Vec2 wanted;
};

enum class Traffic : std::int64_t { along, across };

Scene random_scene(std::uint64_t& state, Traffic traffic) {
  Scene scene;
  scene.robot.velocity = {kSpeed, 0.0};
  scene.wanted = {kSpeed + 0.05, 0.0};
  while (scene.neighbors.size() < kNeighbors) {
    const double angle = uniform(state, 0.0, 2.0 * std::numbers::pi);
    const double heading = traffic == Traffic::along ? uniform(state, -0.1, 0.1)
                                                     : uniform(state, 0.0, 2.0 * std::numbers::pi);
    const double distance = uniform(state, traffic == Traffic::along ? 2.0 : 1.5, 5.0);
    const double speed = traffic == Traffic::along ? kSpeed : 0.4 * kSpeed;
    scene.neighbors.push_back({distance * Vec2{std::cos(angle), std::sin(angle)},
                               speed * Vec2{std::cos(heading), std::sin(heading)},
                               0.5,
                               1.0,
                               {}});
  }
  return scene;
}

CertificateLaw law() {
  return certificate_law(Planner({}));
}

// Returns scenes whose invariant holds, and whose wanted velocity is admitted or not.
std::vector<Scene> scenes(Traffic traffic, bool admitted) {
  std::uint64_t state = 2025;
  std::vector<Scene> scenes;
  CertificateConstraints constraints;
  while (scenes.size() < 1024) {  // so many that branch prediction cannot learn them
    Scene scene = random_scene(state, traffic);
    collect_constraints(scene.robot, scene.neighbors, law(), constraints);
    if (constraints.invariant.broken.any()) continue;
    if (admits(scene.robot, scene.wanted, law(), constraints) == admitted) scenes.push_back(scene);
  }
  return scenes;
}

void constraints_of_ten(benchmark::State& state) {
  const std::vector<Scene> all = scenes(Traffic{state.range(0)}, true);
  const CertificateLaw agreed = law();
  CertificateConstraints constraints;
  std::size_t k = 0, count = 0, decisions = 0;
  for (auto _ : state) {
    collect_constraints(all[k].robot, all[k].neighbors, agreed, constraints);
    count += constraints.trajectories.columns.count;
    ++decisions;
    k = (k + 1) % all.size();
  }
  state.counters["constraints"] = static_cast<double>(count) / static_cast<double>(decisions);
}
BENCHMARK(constraints_of_ten)->ArgName("across")->Arg(0)->Arg(1);

void admission(benchmark::State& state) {
  const std::vector<Scene> all = scenes(Traffic::across, true);
  const CertificateLaw agreed = law();
  std::vector<CertificateConstraints> constraints(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    collect_constraints(all[k].robot, all[k].neighbors, agreed, constraints[k]);
  }
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(admits(all[k].robot, all[k].wanted, agreed, constraints[k]));
    k = (k + 1) % all.size();
  }
}
BENCHMARK(admission);

void choice(benchmark::State& state, bool admitted) {
  const std::vector<Scene> all = scenes(Traffic::across, admitted);
  const CertificateLaw agreed = law();
  CertifiedWorkspace workspace;
  std::size_t k = 0;
  for (auto _ : state) {
    collect_constraints(all[k].robot, all[k].neighbors, agreed, workspace.constraints);
    benchmark::DoNotOptimize(choose_certified(all[k].robot, all[k].wanted, agreed, workspace));
    k = (k + 1) % all.size();
  }
}
BENCHMARK_CAPTURE(choice, admitted, true);
BENCHMARK_CAPTURE(choice, refused, false);

}  // namespace
}  // namespace avo
