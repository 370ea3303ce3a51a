// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0x15a81ea617f22856},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x8cd51b2810556d66},
      {"swap_blocks", "swap-blocks", {}, 0, 0x195bdec291f1a094},
      {"uniform_1000", "uniform-1000", {}, 100, 0xb78e48fc6e5e00e4},
      {"cars_100", "cars-100", {}, 0, 0x80d51173f29e3093},
      {"drives_100", "drives-100", {}, 0, 0xc2171644c3b8190d},
      {"planes_12", "planes-12", {}, 0, 0x062b497854bbad13},
      {"person", "person", {}, 0, 0x3acc942a286b85da},
      {"reversing_cars", "reversing-cars", {}, 0, 0x6b6435ca066cff6c},
      {"mixed_yard", "mixed-yard", {}, 0, 0x2a73250863b98f13},
      {"moving_obstacle_exponential",
       "moving-obstacle",
       {"motion=exponential"},
       0,
       0x59874e7ba377b84b},
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
