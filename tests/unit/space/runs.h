// SPDX-License-Identifier: Apache-2.0
// Whole runs of scenes of space.
#pragma once
#include "avo/space/metrics.h"
#include "avo/space/simulation.h"

namespace avo::space::tests {

enum class RunUntil : unsigned char { all_arrive, its_end };

inline RunSummary summary_of(const Scenario& scene, RunUntil until) {
  Simulation simulation(scene);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (simulation.time() < scene.duration - 1e-9) {
    if (until == RunUntil::all_arrive && metrics.all_arrived()) break;
    simulation.step();
    metrics.observe(simulation);
  }
  return metrics.summary();
}

}  // namespace avo::space::tests
