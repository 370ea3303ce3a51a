// SPDX-License-Identifier: Apache-2.0
#include "figures/colors.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace avo::figures {
namespace {

unsigned hex_of(Color color) {
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(255.0 * part)); };
  return (byte(color.red) << 16U) + (byte(color.green) << 8U) + byte(color.blue);
}

// The same numbers are in tests/python/svg_test.py and in tests/lab/page/drawing.test.mjs.
TEST(Colors, directions_have_the_colors_of_the_lab) {
  const std::vector<std::pair<double, unsigned>> expected{
      {0.0, 0x56b4e9}, {100.0, 0xc47aa8}, {180.0, 0xde7f00}, {250.0, 0xc2ad00}, {-30.0, 0x30a8a5}};
  for (const auto& [degrees, hex] : expected)
    EXPECT_EQ(hex_of(direction_color(degrees)), hex) << degrees;
  EXPECT_EQ(hex_of(direction_color(330.0)), hex_of(direction_color(-30.0)));
}

TEST(Colors, a_few_are_of_the_palette_and_many_are_directions) {
  EXPECT_EQ(hex_of(color_of(1, 6)), 0xd55e00U);
  EXPECT_EQ(hex_of(color_of(0, 7)), hex_of(direction_color(0.0)));
}

}  // namespace
}  // namespace avo::figures
