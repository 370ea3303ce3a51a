// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0xd13b5edd4433bf02},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x8cd51b2810556d66},
      {"swap_blocks", "swap-blocks", {}, 0, 0x6ae474484a03c110},
      {"uniform_1000", "uniform-1000", {}, 100, 0xb99ae99b6c68ae41},
      {"cars_100", "cars-100", {}, 0, 0x12c213f68ee4557b},
      {"drives_100", "drives-100", {}, 0, 0x2a42d0bada254048},
      // later all have left
      {"planes_12", "planes-12", {}, 600, 0x582de383f23d8b3d},
      {"person", "person", {}, 0, 0xa721cdba7f7b4bf3},
      {"reversing_cars", "reversing-cars", {}, 0, 0xce938db8b88aa135},
      {"mixed_yard", "mixed-yard", {}, 0, 0x48220ada1aaabbc1},
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
       0xd1852e4b9cbe8e12},
      {"reversing_cars_that_sense_late",
       "reversing-cars",
       {"sensing.delay=1"},
       0,
       0x707a6d8ce35960ae},
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
