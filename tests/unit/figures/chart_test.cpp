// SPDX-License-Identifier: Apache-2.0
#include "figures/chart.h"

#include <limits>

#include "avo/error.h"
#include "figures/axes.h"
#include "picture.h"

namespace avo::figures {
namespace {

class ChartFile : public FigureFile {};

constexpr Color kRed{1.0, 0.0, 0.0, 1.0};

TEST_F(ChartFile, points_stand_at_their_values) {
  const Chart chart{"x", "y", {{"", {{0.0, 0.0}, {500.0, 2.0}, {1000.0, 4.0}}, kRed}}};
  write_bytes(path("a.png"), draw_chart(chart, path("a.png"), {.width = 300.0}));
  const Picture picture = read_png(path("a.png"));
  // the y axis reaches from 0 to 5, the first tick above 4 and some air
  const double width = 300.0 - kAxesLeft - 14.0;
  const double height = 0.58 * width;
  const auto red_at = [&](double x, double y) {
    const png_byte* pixel =
        picture.at(kAxesLeft + width * x / 1000.0, 8.0 + height * (1.0 - y / 5.0));
    return pixel[0] > 200 && pixel[1] < 120;
  };
  EXPECT_TRUE(red_at(500.0, 2.0));
  EXPECT_TRUE(red_at(995.0, 3.98));
  EXPECT_TRUE(red_at(750.0, 3.0));
  EXPECT_FALSE(red_at(500.0, 3.0));
}

TEST_F(ChartFile, an_empty_or_broken_chart_is_refused) {
  EXPECT_THROW((void)draw_chart({"x", "y", {}}, path("a.png")), Error);
  EXPECT_THROW((void)draw_chart({"x", "y", {{"", {}, kRed}}}, path("a.png")), Error);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)draw_chart({"x", "y", {{"", {{0.0, infinite}}, kRed}}}, path("a.png")), Error);
  EXPECT_THROW((void)draw_chart({"x", "y", {{"", {{0.0, 1.0}}, kRed}}}, path("a.bmp")), Error);
}

TEST_F(ChartFile, a_single_point_can_be_drawn) {
  EXPECT_TRUE(draw_chart({"x", "y", {{"", {{0.0, 0.0}}, kRed}}}, "a.svg").ends_with("</svg>\n"));
}

}  // namespace
}  // namespace avo::figures
