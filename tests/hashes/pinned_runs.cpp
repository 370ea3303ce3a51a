// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0x7b3383fd832a5606},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x8cd51b2810556d66},
      {"swap_blocks", "swap-blocks", {}, 0, 0xc122637e58df8515},
      {"uniform_1000", "uniform-1000", {}, 100, 0xd71157456f251911},
      {"cars_100", "cars-100", {}, 0, 0x4facf30197e63d7f},
      {"drives_100", "drives-100", {}, 0, 0x533ee79ae426b1cc},
      // later all have left
      {"planes_12", "planes-12", {}, 600, 0x5f5d1d6ff6cfe9cd},
      {"person", "person", {}, 0, 0x3ccf33ec667cddea},
      {"reversing_cars", "reversing-cars", {}, 0, 0x5ff6e396e13e8268},
      {"mixed_yard", "mixed-yard", {}, 0, 0x43f93901d0131374},
      {"moving_obstacle_exponential",
       "moving-obstacle",
       {"motion=exponential"},
       0,
       0x9ad24cf94dd5a47a},
      // more robots than one thread plans; their bodies swing, and what they sense is a step old
      {"cars_that_sense_late",
       "cars-100",
       {"groups.0.number=300", "sensing.delay=1",
        "groups.0.car={max_curvature: 0.8, body: {offset: 0.4, radius: 0.5}, reverse: true, "
        "acceleration_set: exact}",
        "groups.0.placement.random={min: [0, 0], max: [44, 44], clearance: 0.1}",
        "groups.0.goals.random={min: [0, 0], max: [44, 44], clearance: 0.1}"},
       100,
       0xb94775bef26dc10f},
      {"reversing_cars_that_sense_late",
       "reversing-cars",
       {"sensing.delay=1"},
       0,
       0xa072e4ee6fae4860},
  };
  return runs;
}

std::int64_t steps_of(const PinnedRun& run, const avo::Scenario& scenario) {
  return run.steps > 0 ? run.steps : avo::last_step(scenario, scenario.duration);
}

std::uint64_t state_hash(const PinnedRun& run, int threads) {
  const avo::Scenario scenario = avo_io::load_scenario(run.scene, run.overrides);
  const std::int64_t steps = steps_of(run, scenario);
  avo::Simulation simulation(scenario, threads);
  while (simulation.steps() < steps) simulation.step();
  return simulation.state_hash();
}

}  // namespace avo_test
