// SPDX-License-Identifier: Apache-2.0
#include "figures/palette.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace avo::figures {
namespace {

int difference(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (const int shift : {16, 8, 0}) {
    const int d = static_cast<int>((a >> shift) & 255U) - static_cast<int>((b >> shift) & 255U);
    most = std::abs(d) > most ? std::abs(d) : most;
  }
  return most;
}

TEST(Palette, few_colors_stay_exact) {
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < 2560; ++i) pixels.push_back((i % 256U) * 0x00010307U & 0xFFFFFFU);
  const IndexedImage image = reduce_colors(pixels);
  EXPECT_LE(image.palette.size(), 256U);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_EQ(image.palette[image.index[i]], pixels[i]);
  }
}

TEST(Palette, many_colors_stay_close_and_white_stays_white) {
  std::vector<std::uint32_t> pixels(300, 0xFFFFFFU);
  for (std::uint32_t r = 0; r < 256; r += 8) {
    for (std::uint32_t g = 0; g < 256; g += 8) {
      for (std::uint32_t b = 0; b < 256; b += 8) pixels.push_back(r << 16 | g << 8 | b);
    }
  }
  const IndexedImage image = reduce_colors(pixels);
  ASSERT_EQ(image.index.size(), pixels.size());
  EXPECT_EQ(image.palette.size(), 256U);
  EXPECT_EQ(image.palette[image.index[0]], 0xFFFFFFU);
  int worst = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int off = difference(image.palette[image.index[i]], pixels[i]);
    worst = off > worst ? off : worst;
  }
  EXPECT_LE(worst, 64);  // a cube cut into 256 parts has sides of 40, some parts are longer
}

TEST(Palette, the_upper_byte_does_not_count) {
  const std::vector<std::uint32_t> pixels{0xFF102030U, 0x00102030U};
  const IndexedImage image = reduce_colors(pixels);
  EXPECT_EQ(image.palette, std::vector<std::uint32_t>{0x102030U});
  EXPECT_TRUE(reduce_colors({}).palette.empty());
}

}  // namespace
}  // namespace avo::figures
