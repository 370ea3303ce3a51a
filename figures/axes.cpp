// SPDX-License-Identifier: Apache-2.0
// Frame, ticks and units around the view of a canvas.
#include "figures/axes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace avo::figures {
namespace {

constexpr double kTick = 3.0;       // pt
constexpr double kTickText = 7.5;   // pt
constexpr double kLabelText = 8.5;  // pt
constexpr double kTickGap = 2.5;    // pt, from a tick to its number
// pt, from the numbers to the label, for parts of letters below the baseline
constexpr double kLabelGap = 4.0;
constexpr double kPageGap = 10.0;  // pt, from the edge of the page to the label
constexpr Color kInk = gray(0.25);

double spacing_of(double lower, double upper, int most) {
  const double span = upper - lower;
  if (!(span > 0.0) || !std::isfinite(span)) return 1.0;
  const double rough = span / std::max(most, 1);  // a smaller spacing gives too many ticks
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    const double spacing = factor * decade;
    const double count = std::floor(upper / spacing) - std::ceil(lower / spacing) + 1.0;
    if (count <= most) return spacing;
  }
  return 50.0 * decade;
}

}  // namespace

std::vector<double> nice_ticks(double lower, double upper, int most) {
  const double spacing = spacing_of(lower, upper, most);
  const double slack = 1e-9 * spacing;
  std::vector<double> ticks;
  const double first = std::ceil((lower - slack) / spacing);
  for (int k = 0; k < most; ++k) {
    const double tick = (first + k) * spacing;
    if (tick > upper + slack) break;
    ticks.push_back(tick == 0.0 ? 0.0 : tick);  // no -0
  }
  return ticks;
}

std::string tick_label(double value, double spacing) {
  const double exponent = std::floor(std::log10(spacing) + 1e-9);
  const int decimals = exponent < 0.0 ? static_cast<int>(-exponent) : 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::min(decimals, 12), value);
  std::string label = text;
  if (label[0] == '-') label.replace(0, 1, "\u2212");
  return label;
}

namespace {

/// Returns pt from the view to the label of the y axis: beside the widest number.
double label_distance(const Canvas& canvas, const Box& world, const Axes& axes) {
  double widest = 0.0;
  const double spacing = spacing_of(world.lower.y, world.upper.y, axes.most_ticks_y);
  if (axes.y_numbers)
    for (const double tick : nice_ticks(world.lower.y, world.upper.y, axes.most_ticks_y))
      widest = std::max(widest, canvas.text_width(tick_label(tick, spacing), {.size = kTickText}));
  return std::max(kAxesLeft - kPageGap, kTick + kTickGap + widest + kLabelGap);
}

}  // namespace

double axes_left(const std::string& path, const Box& world, const Axes& axes) {
  return label_distance(Canvas(path, 1.0, 1.0), world, axes) + kPageGap;
}

void draw_grid(Canvas& canvas, const Axes& axes) {
  const Box world = canvas.view_world();
  const Box page = canvas.view_page();
  for (const double tick : nice_ticks(world.lower.x, world.upper.x, axes.most_ticks_x)) {
    const double x = canvas.to_page({tick, 0.0}).x;
    canvas.add_page_line({x, page.lower.y}, {x, page.upper.y});
  }
  for (const double tick : nice_ticks(world.lower.y, world.upper.y, axes.most_ticks_y)) {
    const double y = canvas.to_page({0.0, tick}).y;
    canvas.add_page_line({page.lower.x, y}, {page.upper.x, y});
  }
  canvas.stroke({gray(0.9), 0.5});
}

void draw_axes(Canvas& canvas, const Axes& axes) {
  const Box world = canvas.view_world();
  const Box page = canvas.view_page();
  canvas.add_page_box(page);
  canvas.stroke({kInk, 0.6});

  const auto x_ticks = nice_ticks(world.lower.x, world.upper.x, axes.most_ticks_x);
  const double x_spacing = spacing_of(world.lower.x, world.upper.x, axes.most_ticks_x);
  for (const double tick : x_ticks) {
    const double x = canvas.to_page({tick, 0.0}).x;
    canvas.add_page_line({x, page.upper.y}, {x, page.upper.y + kTick});
    canvas.stroke({kInk, 0.6});
    canvas.page_text({x, page.upper.y + kTick + kTickGap}, tick_label(tick, x_spacing),
                     {.size = kTickText, .color = kInk, .align_x = 0.5, .align_y = 1.0});
  }
  const auto y_ticks = nice_ticks(world.lower.y, world.upper.y, axes.most_ticks_y);
  const double y_spacing = spacing_of(world.lower.y, world.upper.y, axes.most_ticks_y);
  for (const double tick : y_ticks) {
    const double y = canvas.to_page({0.0, tick}).y;
    canvas.add_page_line({page.lower.x - kTick, y}, {page.lower.x, y});
    canvas.stroke({kInk, 0.6});
    if (!axes.y_numbers) continue;
    canvas.page_text({page.lower.x - kTick - kTickGap, y}, tick_label(tick, y_spacing),
                     {.size = kTickText, .color = kInk, .align_x = 1.0, .align_y = 0.5});
  }

  const Vec2 middle = 0.5 * (page.lower + page.upper);
  canvas.page_text({middle.x, page.upper.y + kAxesBottom - 13.0}, axes.x_label,
                   {.size = kLabelText, .color = kInk, .align_x = 0.5, .align_y = 1.0});
  canvas.page_text(
      {page.lower.x - label_distance(canvas, world, axes), middle.y}, axes.y_label,
      {.size = kLabelText, .color = kInk, .align_x = 0.5, .angle = 1.5707963267948966});
}

}  // namespace avo::figures
