// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0xa68713678c7d1db7},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x808c9f74d53aa99a},
      {"swap_blocks", "swap-blocks", {}, 0, 0xefdf742b7b7ecdaa},
      {"uniform_1000", "uniform-1000", {}, 100, 0x318e50f666ac02f2},
      {"cars_100", "cars-100", {}, 0, 0x06419f790387692d},
      {"drives_100", "drives-100", {}, 0, 0xa7f54f7ee3238dc9},
      {"planes_12", "planes-12", {}, 0, 0x062b497854bbad13},
      {"person", "person", {}, 0, 0xb0d5ffd3f91cdb1b},
      {"reversing_cars", "reversing-cars", {}, 0, 0xbb99824511c86911},
      {"mixed_yard", "mixed-yard", {}, 0, 0x216a0f71455dfeaa},
      {"moving_obstacle_exponential",
       "moving-obstacle",
       {"motion=exponential"},
       0,
       0xb6667258c747a752},
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
