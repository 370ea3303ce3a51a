// SPDX-License-Identifier: Apache-2.0
// The state hashes of whole runs, pinned; scripts/hashes compares them across compilers.
#include <cstdint>
#include <gtest/gtest.h>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "hashes/pinned_runs.h"

namespace avo_test {
namespace {

class Pinned : public testing::TestWithParam<PinnedRun> {};

TEST_P(Pinned, run_has_its_bits) {
  const std::uint64_t hash = state_hash(GetParam(), 0);
  EXPECT_EQ(hash, GetParam().hash) << std::hex << "0x" << hash;
}

// Other robots decide before robot A in the same memory. With another number of threads, these are
// other robots. In a simulation made of saved bytes, no robot decides before A.
TEST_P(Pinned, threads_and_saved_states_change_no_bit) {
  constexpr int kSteps = 40;
  const avo::Scenario scenario = avo_io::load_scenario(GetParam().scene, GetParam().overrides);
  avo::Simulation alone(scenario, 1), two(scenario, 2), four(scenario, 4);
  for (int k = 0; k < kSteps; ++k) {
    avo::Simulation restored(alone.save(), 1);
    for (avo::Simulation* each : {&alone, &two, &four, &restored}) each->step();
    for (const avo::Simulation* each : {&two, &four, &restored})
      ASSERT_EQ(each->state_hash(), alone.state_hash()) << "step " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Hashes, Pinned, testing::ValuesIn(pinned_runs()),
                         [](const auto& run) { return run.param.name; });

}  // namespace
}  // namespace avo_test
