// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0xb99f0bba3d3a8cd9},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x8cd51b2810556d66},
      {"swap_blocks", "swap-blocks", {}, 0, 0xa633a5241e82228a},
      {"uniform_1000", "uniform-1000", {}, 100, 0xe3bcf9fb9afbc68e},
      {"cars_100", "cars-100", {}, 0, 0x064ecc3e87caef1d},
      {"drives_100", "drives-100", {}, 0, 0x701044eed0758fbd},
      {"planes_12", "planes-12", {}, 0, 0x062b497854bbad13},
      {"person", "person", {}, 0, 0x3326998f242467b7},
      {"reversing_cars", "reversing-cars", {}, 0, 0xe8e767353779561f},
      {"mixed_yard", "mixed-yard", {}, 0, 0xe1e6fe9e1147d57c},
      {"moving_obstacle_exponential",
       "moving-obstacle",
       {"motion=exponential"},
       0,
       0xd9142e5b0bb74caa},
      // more robots than one thread plans; their bodies swing, and what they sense is a step old
      {"cars_that_sense_late",
       "cars-100",
       {"groups.0.number=300", "sensing.delay=1",
        "groups.0.car={max_curvature: 0.8, body: {offset: 0.4, radius: 0.5}, reverse: true, "
        "acceleration_set: exact}",
        "groups.0.placement.random={min: [0, 0], max: [44, 44], clearance: 0.1}",
        "groups.0.goals.random={min: [0, 0], max: [44, 44], clearance: 0.1}"},
       100,
       0x38780c69a8391325},
      {"reversing_cars_that_sense_late",
       "reversing-cars",
       {"sensing.delay=1"},
       0,
       0xc309723996d39984},
  };
  return runs;
}

std::uint64_t state_hash(const PinnedRun& run, int threads) {
  const avo::Scenario scenario = avo_io::load_scenario(run.scene, run.overrides);
  const std::int64_t steps =
      run.steps > 0 ? run.steps : avo::last_step(scenario, scenario.duration);
  avo::Simulation simulation(scenario, threads);
  while (simulation.steps() < steps) simulation.step();
  return simulation.state_hash();
}

}  // namespace avo_test
