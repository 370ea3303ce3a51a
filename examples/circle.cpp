// SPDX-License-Identifier: Apache-2.0
// Circle-100 from C++: prints how many arrive, and the state hash at the end.
#include <avo_io/scene.h>
#include <cinttypes>
#include <cstdio>

#include <avo/avo.h>

int main() {
  try {
    const avo::Scenario scene = avo_io::load_scenario("circle-100");
    avo::Simulation simulation(scene);
    avo::Metrics metrics(scene);
    metrics.observe(simulation);
    while (simulation.can_step_by(scene.duration)) {
      simulation.step();
      metrics.observe(simulation);
    }
    const avo::RunSummary summary = metrics.summary();
    std::printf("%" PRId64 " of %" PRId64 " arrived, %" PRId64
                " collisions, state hash 0x%016" PRIx64 "\n",
                summary.arrived, summary.robots, summary.collision_pairs, simulation.state_hash());
  } catch (const avo::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
