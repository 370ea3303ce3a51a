// SPDX-License-Identifier: Apache-2.0
#include "figures/axes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace avo::figures {
namespace {

TEST(Axes, ticks_are_round_inside_and_not_too_many) {
  for (const double lower : {-1234.0, -7.3, -0.02, 0.0, 0.7, 990.0}) {
    for (const double span : {1e-3, 0.9, 1.0, 4.7, 20.0, 999.0, 1e5}) {
      for (const int most : {2, 5, 9}) {
        const auto ticks = nice_ticks(lower, lower + span, most);
        ASSERT_LE(ticks.size(), static_cast<std::size_t>(most));
        for (const double tick : ticks) {
          EXPECT_GE(tick, lower - 1e-6 * span);
          EXPECT_LE(tick, lower + span * (1.0 + 1e-6));
        }
        EXPECT_GE(ticks.size(), most >= 5 ? 2U : 0U) << lower << " " << span << " " << most;
        if (ticks.size() < 2) continue;
        const double spacing = ticks[1] - ticks[0];
        const double leading = spacing / std::pow(10.0, std::floor(std::log10(spacing) + 1e-6));
        EXPECT_NEAR(leading * (leading - 1.0) * (leading - 2.0) * (leading - 5.0), 0.0, 1e-3);
      }
    }
  }
}

TEST(Axes, ticks_of_a_round_range_include_both_ends) {
  EXPECT_EQ(nice_ticks(0.0, 1000.0, 7), (std::vector<double>{0, 200, 400, 600, 800, 1000}));
  EXPECT_EQ(nice_ticks(-10.0, 10.0, 7), (std::vector<double>{-10, -5, 0, 5, 10}));
  const auto narrow = nice_ticks(0.0, 0.3, 4);
  ASSERT_EQ(narrow.size(), 4U);
  EXPECT_NEAR(narrow[3], 0.3, 1e-12);
}

TEST(Axes, an_empty_range_does_no_harm) {
  EXPECT_LE(nice_ticks(1.0, 1.0, 5).size(), 1U);
  EXPECT_LE(nice_ticks(0.0, std::nan(""), 5).size(), 5U);
}

TEST(Axes, labels_are_as_short_as_the_spacing_allows) {
  EXPECT_EQ(tick_label(0.0, 5.0), "0");
  EXPECT_EQ(tick_label(2.5, 0.5), "2.5");
  EXPECT_EQ(tick_label(-10.0, 5.0), "\u221210");
  EXPECT_EQ(tick_label(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(tick_label(1000.0, 200.0), "1000");
  EXPECT_EQ(tick_label(0.02, 0.02), "0.02");
}

}  // namespace
}  // namespace avo::figures
