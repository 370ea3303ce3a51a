// SPDX-License-Identifier: Apache-2.0
#include "figures/chart.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

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

TEST_F(ChartFile, the_legend_stands_below_the_axes) {
  const Series curve{"", {{0.0, 0.0}, {10.0, 4.0}}, kRed, false};
  const Chart bare{"x", "y", {curve, curve}, 10.0};
  Chart named = bare;
  named.series[0].label = "a";
  named.series[1].label = "b";
  write_bytes(path("bare.png"), draw_chart(bare, path("bare.png"), {.width = 300.0}));
  write_bytes(path("named.png"), draw_chart(named, path("named.png"), {.width = 300.0}));
  const Picture without = read_png(path("bare.png")), with = read_png(path("named.png"));
  EXPECT_EQ(with.width, without.width);
  ASSERT_GT(with.height, without.height);
  const std::size_t both = 3 * without.width * (without.height - 2);  // its edge is no whole pixel
  int largest = 0;  // difference: Cairo rounds differently on a higher page
  for (std::size_t k = 0; k < both; ++k)
    largest = std::max(largest, std::abs(int{without.rgb[k]} - int{with.rgb[k]}));
  EXPECT_LE(largest, 8) << "the plot and its axes are as without a legend";
  const auto red = [](const Picture& picture, std::size_t from) {
    std::size_t found = 0;
    for (std::size_t k = from; k < picture.rgb.size(); k += 3)
      found += picture.rgb[k] > 200 && picture.rgb[k + 1] < 120 ? 1U : 0U;
    return found;
  };
  EXPECT_GT(red(with, both), 2U * 2U * 20U) << "two lines of 20 pt, two pixels to the point";
}

TEST_F(ChartFile, the_label_of_the_y_axis_keeps_away_from_wide_numbers) {
  const auto blank_between = [&](double top) {
    const Chart chart{"x", "label of y", {{"", {{0.0, 0.0}, {1.0, top}}, kRed}}, top};
    write_bytes(path("w.png"), draw_chart(chart, path("w.png"), {.width = 300.0}));
    const Picture picture = read_png(path("w.png"));
    // columns of pixels from the left: blank, the label, blank, numbers
    std::vector<bool> ink(picture.width);
    for (std::size_t x = 0; x < picture.width; ++x)
      for (std::size_t y = 0; y < picture.height; ++y)
        if (picture.rgb[3 * (y * picture.width + x)] < 200) ink[x] = true;
    const auto label = std::find(ink.begin(), ink.end(), true);
    EXPECT_GT(label - ink.begin(), 1) << "the label is whole";
    const auto blank = std::find(label, ink.end(), false);
    EXPECT_LT(blank - label, 2 * 14) << "the label alone";
    return std::find(blank, ink.end(), true) - blank;
  };
  for (const double top : {5.0, 1e6, 1e9, 0.0004}) EXPECT_GE(blank_between(top), 2) << top;
}

TEST_F(ChartFile, curves_can_have_a_pattern_of_dashes) {
  const auto red_pixels = [&](std::array<double, 4> pattern) {
    Chart chart{"x", "y", {{"", {{0.0, 5.0}, {10.0, 5.0}}, kRed, false}}, 10.0};
    chart.series[0].pattern = pattern;
    write_bytes(path("p.png"), draw_chart(chart, path("p.png"), {.width = 300.0}));
    const Picture picture = read_png(path("p.png"));
    int found = 0;
    for (std::size_t k = 0; k < picture.rgb.size(); k += 3)
      found += picture.rgb[k] > 200 && picture.rgb[k + 1] < 120 ? 1 : 0;
    return found;
  };
  const double solid = red_pixels({});
  EXPECT_NEAR(red_pixels({6, 2, 6, 2}) / solid, 0.75, 0.05);
  EXPECT_NEAR(red_pixels({6, 6, 6, 2}) / solid, 0.6, 0.05);
}

TEST_F(ChartFile, the_axis_ends_behind_curves_over_time) {
  const Chart chart{"x", "y", {{"", {{0.0, 5.0}, {41.0, 5.0}}, kRed, false}}, 10.0};
  write_bytes(path("e.png"), draw_chart(chart, path("e.png"), {.width = 300.0}));
  const Picture picture = read_png(path("e.png"));
  const double height = 0.58 * (300.0 - kAxesLeft - 14.0);
  const auto is_red = [&](double from_the_frame) {
    const png_byte* pixel = picture.at(300.0 - 14.0 - from_the_frame, 8.0 + 0.5 * height);
    return pixel[0] > 200 && pixel[1] < 120;
  };
  EXPECT_TRUE(is_red(8.0));
  EXPECT_FALSE(is_red(2.0));
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST_F(ChartFile, several_charts_have_titles_and_one_legend) {
  const auto chart = [](const char* title) {
    return Chart{"time",
                 "y",
                 {{"one", {{0.0, 0.0}, {1.0, 1.0}}, kRed, false},
                  {"two", {{0.0, 1.0}, {1.0, 0.0}}, kBlack, false}},
                 1.0,
                 title};
  };
  const std::vector<Chart> charts{chart("a"), chart("b"), chart("c")};
  const std::string svg = draw_charts(charts, "a.svg");
  for (const char* text : {">a<", ">b<", ">c<", ">one<", ">two<"})
    EXPECT_EQ(count_of(text, svg), 1U) << text;
  EXPECT_EQ(count_of(">time<", svg), 3U);
  EXPECT_THROW((void)draw_charts({}, "a.svg"), Error);
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
