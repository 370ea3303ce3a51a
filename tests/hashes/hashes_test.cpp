// SPDX-License-Identifier: Apache-2.0
// The state hashes of whole runs, pinned; scripts/hashes compares them across compilers.
#include <cstdint>
#include <gtest/gtest.h>

#include "hashes/pinned_runs.h"

namespace avo_test {
namespace {

class Pinned : public testing::TestWithParam<PinnedRun> {};

TEST_P(Pinned, run_has_its_bits) {
  const std::uint64_t hash = state_hash(GetParam(), 0);
  EXPECT_EQ(hash, GetParam().hash) << std::hex << "0x" << hash;
}

INSTANTIATE_TEST_SUITE_P(Hashes, Pinned, testing::ValuesIn(pinned_runs()),
                         [](const auto& run) { return run.param.name; });

}  // namespace
}  // namespace avo_test
