// SPDX-License-Identifier: Apache-2.0
// A host program with kernels of its own by Highway: neither finds the other's choice of an
// instruction set changed. This file is compiled once for each by hwy/foreach_target.h.
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/sim/highway/highway_host_test.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace host::HWY_NAMESPACE {
std::int64_t target_of_kernel() {
  return HWY_TARGET;
}
}  // namespace host::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>
#include <string>

#include "avo/simulation.h"
#include "core/simd_target.h"
#include "unit/sim/scenes.h"

namespace host {
HWY_EXPORT(target_of_kernel);
}

namespace avo {
namespace {

void take_steps() {
  Simulation simulation(test::dense_scene(20, Motion::held), 1);
  for (int k = 0; k < 3; ++k) simulation.step();
}

TEST(HighwayHost, finds_its_own_target_after_steps) {
  const std::int64_t supported = hwy::SupportedTargets();
  using namespace host;
  const std::int64_t target = HWY_DYNAMIC_DISPATCH(target_of_kernel)();
  for (const char* name : simd_targets()) {
    ASSERT_TRUE(use_simd_target(name));
    take_steps();
    EXPECT_EQ(hwy::SupportedTargets(), supported) << name;
    EXPECT_EQ(HWY_DYNAMIC_DISPATCH(target_of_kernel)(), target) << name;
  }
  use_simd_target(simd_targets().front());
}

TEST(HighwayHost, what_the_host_forbids_itself_is_not_forbidden_to_the_library) {
  const std::string best = simd_targets().front();
  hwy::SetSupportedTargetsForTest(HWY_STATIC_TARGET);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  take_steps();
  EXPECT_EQ(simd_target(), best);
  EXPECT_EQ(simd_targets().front(), best);
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace avo
#endif
