// SPDX-License-Identifier: Apache-2.0
#include "hashes/pinned_runs.h"

#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace avo_test {

const std::vector<PinnedRun>& pinned_runs() {
  static const std::vector<PinnedRun> runs{
      {"circle_100", "circle-100", {}, 0, 0x765f7c179f939a4c},
      {"circle_100_by_avo_paper", "circle-100", {"method=avo_paper"}, 0, 0x8cd51b2810556d66},
      {"swap_blocks", "swap-blocks", {}, 0, 0x8e7c562cde957962},
      {"uniform_1000", "uniform-1000", {}, 100, 0x65630337abcf672d},
      {"cars_100", "cars-100", {}, 0, 0x7a2aac3521813e6a},
      {"drives_100", "drives-100", {}, 0, 0xf18a0bc2af0230e2},
      {"planes_12", "planes-12", {}, 0, 0x062b497854bbad13},
      {"person", "person", {}, 0, 0x3acc942a286b85da},
      {"reversing_cars", "reversing-cars", {}, 0, 0x0cb943cecda187dd},
      {"mixed_yard", "mixed-yard", {}, 0, 0xe810bfe7fd0338d2},
      {"moving_obstacle_exponential",
       "moving-obstacle",
       {"motion=exponential"},
       0,
       0x59874e7ba377b84b},
      // more robots than one thread plans; their bodies swing, and what they sense is a step old
      {"cars_that_sense_late",
       "cars-100",
       {"groups.0.number=300", "sensing.delay=1",
        "groups.0.car={max_curvature: 0.8, body: {offset: 0.4, radius: 0.5}, reverse: true, "
        "acceleration_set: exact}",
        "groups.0.placement.random={min: [0, 0], max: [44, 44], clearance: 0.1}",
        "groups.0.goals.random={min: [0, 0], max: [44, 44], clearance: 0.1}"},
       100,
       0x6eee3689871946d2},
      {"reversing_cars_that_sense_late",
       "reversing-cars",
       {"sensing.delay=1"},
       0,
       0x47173d37c03441d0},
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
