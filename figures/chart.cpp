// SPDX-License-Identifier: Apache-2.0
// Lines over a common x axis, as the paper's Fig. 10.
#include "figures/chart.h"

#include <algorithm>
#include <cmath>

#include "avo/error.h"
#include "figures/axes.h"

namespace avo::figures {
namespace {

constexpr double kTop = 8.0;     // pt
constexpr double kRight = 14.0;  // pt
constexpr double kShape = 0.58;  // height of the plot over its width

// From 0, or below, to the next tick above the largest value, with some air above the curves.
Box range_of(const Chart& chart, const std::string& path) {
  Box box{};
  bool empty = true;
  for (const Series& series : chart.series) {
    for (const Vec2 point : series.points) {
      if (!is_finite(point)) throw Error(path + ": found a value that is not finite in the chart");
      box = enclosing(box, {point, point});
      empty = false;
    }
  }
  if (empty) throw Error(path + ": the chart has no point");
  const auto ceiling = [](double lower, double upper) {
    const std::vector<double> ticks = nice_ticks(lower, upper, 7);
    if (ticks.size() < 2) return upper > lower ? upper : lower + 1.0;
    const double spacing = ticks[1] - ticks[0];
    return spacing * std::ceil(upper / spacing - 1e-9);
  };
  const double top = ceiling(box.lower.y, box.upper.y + 0.05 * (box.upper.y - box.lower.y));
  return {box.lower, {ceiling(box.lower.x, box.upper.x), chart.y_most.value_or(top)}};
}

void draw_series(Canvas& canvas, const Series& series) {
  canvas.add_polyline(series.points);
  canvas.stroke({series.color, 1.4, series.dash});
  if (!series.marks) return;
  for (const Vec2 point : series.points) {
    canvas.add_dot(point, 2.4);
    canvas.fill_and_stroke(series.color, {kWhite, 0.6});
  }
}

// In the upper left corner: growing curves leave it free.
void draw_legend(Canvas& canvas, const Chart& chart) {
  const Box page = canvas.view_page();
  double y = page.lower.y + 14.0;
  for (const Series& series : chart.series) {
    const double x = page.lower.x + 12.0;
    canvas.add_page_line({x, y}, {x + 20.0, y});
    canvas.stroke({series.color, 1.4, series.dash});
    const TextStyle style{.size = 8.5, .color = gray(0.15), .align_y = 0.5};
    if (series.plain)
      canvas.plain_page_text({x + 26.0, y}, series.label, style);
    else
      canvas.page_text({x + 26.0, y}, series.label, style);
    y += 14.0;
  }
}

}  // namespace

std::string draw_chart(const Chart& chart, const std::string& path, const FigureOptions& options) {
  check_figure_path(path);
  const Box world = range_of(chart, path);
  const double top = options.title.empty() ? kTop : kTitleHeight;
  const double width = options.width - kAxesLeft - kRight;
  const double height = kShape * width;
  Canvas canvas(path, options.width, top + height + kAxesBottom);
  canvas.set_view({{kAxesLeft, top}, {kAxesLeft + width, top + height}}, world, Aspect::stretch);
  const Axes axes{.x_label = chart.x_label, .y_label = chart.y_label};
  draw_grid(canvas, axes);
  {
    // marks on the frame stay whole
    const Canvas::ClipScope scope(canvas);
    canvas.add_page_box(grown(canvas.view_page(), 4.0));
    canvas.clip();
    for (const Series& series : chart.series) draw_series(canvas, series);
  }
  draw_axes(canvas, axes);
  draw_legend(canvas, chart);
  if (!options.title.empty()) {
    canvas.plain_page_text({0.5 * options.width, 12.0}, options.title,
                           {.size = 10.0, .color = gray(0.1), .align_x = 0.5});
  }
  return canvas.finish();
}

}  // namespace avo::figures
