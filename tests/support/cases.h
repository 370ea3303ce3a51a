// SPDX-License-Identifier: Apache-2.0
// Tests properties that hold in all cases on a thousand cases; every run uses the same ones.
#pragma once
#include <cstdint>
#include <gtest/gtest.h>
#include <type_traits>

#include "support/generators.h"

namespace avo::test {

inline constexpr int kCases = 1000;

/// Calls property(random) until the first case fails; the message names its seed. Cases for which
/// it returns false do not belong to the property, and do not count.
template <typename Property>
void in_all_cases(const Property& property) {
  int cases = 0;
  for (std::uint64_t seed = 1; cases < kCases; ++seed) {
    ASSERT_LE(seed, 10U * kCases) << "only " << cases << " cases are the property's own";
    Random random(seed);
    bool is_own = true;
    if constexpr (std::is_void_v<decltype(property(random))>) {
      property(random);
    } else {
      is_own = property(random);
    }
    if (is_own) ++cases;
    ASSERT_FALSE(testing::Test::HasFailure()) << "in the case of seed " << seed;
  }
}

}  // namespace avo::test
