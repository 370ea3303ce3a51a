// SPDX-License-Identifier: Apache-2.0
// Uses the library as a user would: fails unless two robots pass each other, on two threads, and
// unless an exception of the library's is caught as what it is.
#include <cstdio>
#include <cstring>

#include <avo/avo.h>

namespace {

bool refuses_bad_options() {
  try {
    const avo::Planner planner(avo::PlannerOptions{.control_time = -1.0});
  } catch (const avo::Error& error) {
    return std::strstr(error.what(), "control_time") != nullptr;
  }
  return false;
}

// Two robots in front of each other; as many besides, far away, that threads have work.
avo::Scenario crossing() {
  avo::Scenario scene;
  for (int k = 0; k < 200; ++k) {
    const double y = 20.0 * k;
    scene.robots.push_back({.position = {-10.0, y}, .goal = {10.0, y}});
    scene.robots.push_back({.position = {10.0, y + 0.5}, .goal = {-10.0, y + 0.5}});
  }
  return scene;
}

}  // namespace

extern "C" int cross() {
  const avo::Scenario scene = crossing();
  avo::Simulation simulation(scene, 2);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  while (!simulation.all_at_goal() && simulation.time() < 60.0) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf("avo %s, %s: clearance %.3f m\n", avo::kVersion, avo::simd_target(),
              summary.min_clearance.value_or(0.0));
  const bool apart = summary.collision_pairs == 0 && summary.min_clearance.value_or(-1.0) > 0.0;
  return simulation.all_at_goal() && apart && refuses_bad_options() ? 0 : 1;
}

int main() {
  return cross();
}
