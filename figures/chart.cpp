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

// Returns a range from 0, or below, to the next tick above the largest value, with some space above
// the curves.
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

Stroke stroke_of(const Series& series) {
  return {series.color, 1.4, series.dash, series.pattern};
}

void draw_series(Canvas& canvas, const Series& series) {
  canvas.add_polyline(series.points);
  canvas.stroke(stroke_of(series));
  if (!series.marks) return;
  for (const Vec2 point : series.points) {
    canvas.add_dot(point, 2.4);
    canvas.fill_and_stroke(series.color, {kWhite, 0.6});
  }
}

constexpr double kLegendLine = 20.0;  // pt, of a curve
constexpr double kLegendGap = 6.0;    // pt, from a legend line to its label
constexpr double kLegendNext = 16.0;  // pt, to the next column
constexpr double kLegendRow = 14.0;   // pt
const TextStyle kLegendText{.size = 8.5, .color = gray(0.15), .align_y = 0.5};

/// The legend below the axes, in as many columns as fit.
struct Legend {
  std::vector<const Series*> entries;
  std::vector<std::string> labels;  // as they are drawn
  std::size_t columns = 1;
  double column = 0.0;  // pt, width

  [[nodiscard]] double height() const {
    return kLegendRow * static_cast<double>((entries.size() + columns - 1) / columns);
  }
};

double label_width(const Canvas& canvas, const std::string& label, bool plain) {
  return plain ? canvas.plain_text_width(label, kLegendText)
               : canvas.text_width(label, kLegendText);
}

/// Returns a plain label that fits: the end of a long one is left out.
std::string fitted(const Canvas& canvas, std::string label, double room) {
  if (label_width(canvas, label, true) <= room) return label;
  while (!label.empty() && label_width(canvas, label + "\u2026", true) > room) {
    while (!label.empty() && (static_cast<unsigned char>(label.back()) & 0xC0U) == 0x80U)
      label.pop_back();  // the rest of a character of UTF-8
    if (!label.empty()) label.pop_back();
  }
  return label + "\u2026";
}

Legend legend_of(const Chart& chart, const std::string& path, double width) {
  const Canvas canvas(path, 1.0, 1.0);
  Legend legend;
  double widest = 0.0;
  for (const Series& series : chart.series) {
    if (series.label.empty()) continue;
    legend.entries.push_back(&series);
    const double room = width - kLegendLine - kLegendGap;
    legend.labels.push_back(series.plain ? fitted(canvas, series.label, room) : series.label);
    widest = std::max(widest, label_width(canvas, legend.labels.back(), series.plain));
  }
  legend.column = kLegendLine + kLegendGap + widest + kLegendNext;
  const double fit = std::floor((width + kLegendNext) / legend.column);
  legend.columns = static_cast<std::size_t>(
      std::clamp(fit, 1.0, static_cast<double>(std::max<std::size_t>(legend.entries.size(), 1))));
  return legend;
}

void draw_legend(Canvas& canvas, const Legend& legend) {
  const Box page = canvas.view_page();
  for (std::size_t k = 0; k < legend.entries.size(); ++k) {
    const Series& series = *legend.entries[k];
    const double x = page.lower.x + legend.column * static_cast<double>(k % legend.columns);
    const double y =
        page.upper.y + kAxesBottom + kLegendRow * (static_cast<double>(k / legend.columns) + 0.4);
    canvas.add_page_line({x, y}, {x + kLegendLine, y});
    canvas.stroke(stroke_of(series));
    const Vec2 at{x + kLegendLine + kLegendGap, y};
    if (series.plain)
      canvas.plain_page_text(at, legend.labels[k], kLegendText);
    else
      canvas.page_text(at, legend.labels[k], kLegendText);
  }
}

}  // namespace

std::string draw_chart(const Chart& chart, const std::string& path, const FigureOptions& options) {
  check_figure_path(path);
  const Box world = range_of(chart, path);
  const double top = options.title.empty() ? kTop : kTitleHeight;
  const Axes axes{.x_label = chart.x_label, .y_label = chart.y_label};
  const double left = axes_left(path, world, axes);
  const double width = options.width - left - kRight;
  const double height = kShape * width;
  const Legend legend = legend_of(chart, path, width);
  Canvas canvas(path, options.width, top + height + kAxesBottom + legend.height());
  canvas.set_view({{left, top}, {left + width, top + height}}, world, Aspect::stretch);
  draw_grid(canvas, axes);
  {
    // so that marks on the frame are not clipped
    const Canvas::ClipScope scope(canvas);
    canvas.add_page_box(grown(canvas.view_page(), 4.0));
    canvas.clip();
    for (const Series& series : chart.series) draw_series(canvas, series);
  }
  draw_axes(canvas, axes);
  draw_legend(canvas, legend);
  if (!options.title.empty()) {
    canvas.plain_page_text({0.5 * options.width, 12.0}, options.title,
                           {.size = 10.0, .color = gray(0.1), .align_x = 0.5});
  }
  return canvas.finish();
}

}  // namespace avo::figures
