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
  const bool has_marks = std::any_of(chart.series.begin(), chart.series.end(),
                                     [](const Series& series) { return series.marks; });
  const bool ends_at_tick = has_marks || !(box.upper.x > box.lower.x);
  const double air = 0.02 * (box.upper.x - box.lower.x);  // so that a last jump is seen
  const double right = ends_at_tick ? ceiling(box.lower.x, box.upper.x) : box.upper.x + air;
  return {box.lower, {right, chart.y_most.value_or(top)}};
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

/// Returns a plain text that fits: the end of a long one is left out.
std::string fitted(const Canvas& canvas, std::string label, const TextStyle& style, double room) {
  if (canvas.plain_text_width(label, style) <= room) return label;
  while (!label.empty() && canvas.plain_text_width(label + "\u2026", style) > room) {
    while (!label.empty() && (static_cast<unsigned char>(label.back()) & 0xC0U) == 0x80U)
      label.pop_back();  // the rest of a character of UTF-8
    if (!label.empty()) label.pop_back();
  }
  return label + "\u2026";
}

/// Returns the series that the legend names: the first one of each label.
std::vector<const Series*> named_series(std::span<const Chart> charts) {
  std::vector<const Series*> named;
  for (const Chart& chart : charts)
    for (const Series& series : chart.series)
      if (!series.label.empty() &&
          std::none_of(named.begin(), named.end(),
                       [&](const Series* other) { return other->label == series.label; }))
        named.push_back(&series);
  return named;
}

Legend legend_of(std::span<const Chart> charts, const std::string& path, double width) {
  const Canvas canvas(path, 1.0, 1.0);
  Legend legend{named_series(charts), {}, 1, 0.0};
  double widest = 0.0;
  for (const Series* entry : legend.entries) {
    const Series& series = *entry;
    const double room = width - kLegendLine - kLegendGap;
    legend.labels.push_back(series.plain ? fitted(canvas, series.label, kLegendText, room)
                                         : series.label);
    widest = std::max(widest, label_width(canvas, legend.labels.back(), series.plain));
  }
  legend.column = kLegendLine + kLegendGap + widest + kLegendNext;
  const double fit = std::floor((width + kLegendNext) / legend.column);
  legend.columns = static_cast<std::size_t>(
      std::clamp(fit, 1.0, static_cast<double>(std::max<std::size_t>(legend.entries.size(), 1))));
  return legend;
}

/// Draws it below and to the right of `corner`, on the page.
void draw_legend(Canvas& canvas, const Legend& legend, Vec2 corner) {
  for (std::size_t k = 0; k < legend.entries.size(); ++k) {
    const Series& series = *legend.entries[k];
    const double x = corner.x + legend.column * static_cast<double>(k % legend.columns);
    const double y = corner.y + kLegendRow * (static_cast<double>(k / legend.columns) + 0.4);
    canvas.add_page_line({x, y}, {x + kLegendLine, y});
    canvas.stroke(stroke_of(series));
    const Vec2 at{x + kLegendLine + kLegendGap, y};
    if (series.plain)
      canvas.plain_page_text(at, legend.labels[k], kLegendText);
    else
      canvas.page_text(at, legend.labels[k], kLegendText);
  }
}

/// The places of several charts on a page, all of one size.
struct PanelGrid {
  std::size_t columns = 1, rows = 1;
  double left = 0.0, top = 0.0;      // pt, from the edge of a cell to its axes
  double width = 0.0, height = 0.0;  // pt, of the axes

  [[nodiscard]] double cell_width() const { return left + width + kRight; }
  [[nodiscard]] double cell_height() const { return top + height + kAxesBottom; }
  [[nodiscard]] Box axes_of(std::size_t k) const {
    const Vec2 corner{cell_width() * static_cast<double>(k % columns) + left,
                      cell_height() * static_cast<double>(k / columns) + top};
    return {corner, corner + Vec2{width, height}};
  }
};

PanelGrid grid_of(std::span<const Chart> charts, std::span<const Box> worlds,
                  const std::string& path, const FigureOptions& options) {
  constexpr double kPart = 0.65;  // of the width of a chart that stands alone
  PanelGrid grid;
  grid.columns = charts.size() < 2 ? 1 : charts.size() <= 4 ? 2 : 3;
  grid.rows = (charts.size() + grid.columns - 1) / grid.columns;
  grid.top = options.title.empty() ? kTop : kTitleHeight;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (!charts[k].title.empty()) grid.top = kTitleHeight;
    grid.left = std::max(grid.left, axes_left(path, worlds[k], {.y_label = charts[k].y_label}));
  }
  grid.width = (charts.size() < 2 ? 1.0 : kPart) * options.width - grid.left - kRight;
  grid.height = kShape * grid.width;
  return grid;
}

void draw_panel(Canvas& canvas, const Chart& chart, const Box& axes_page, const Box& world) {
  const Axes axes{.x_label = chart.x_label, .y_label = chart.y_label};
  canvas.set_view(axes_page, world, Aspect::stretch);
  draw_grid(canvas, axes);
  {
    // so that marks on the frame are not clipped
    const Canvas::ClipScope scope(canvas);
    canvas.add_page_box(grown(canvas.view_page(), 4.0));
    canvas.clip();
    for (const Series& series : chart.series) draw_series(canvas, series);
  }
  draw_axes(canvas, axes);
  if (chart.title.empty()) return;
  const TextStyle style{.size = 10.0, .color = gray(0.1), .align_x = 0.5};
  const double width = axes_page.upper.x - axes_page.lower.x;
  canvas.plain_page_text({axes_page.lower.x + 0.5 * width, axes_page.lower.y - 6.0},
                         fitted(canvas, chart.title, style, width), style);
}

}  // namespace

std::string draw_chart(const Chart& chart, const std::string& path, const FigureOptions& options) {
  Chart titled = chart;
  if (!options.title.empty()) titled.title = options.title;
  return draw_charts({&titled, 1}, path, options);
}

std::string draw_charts(std::span<const Chart> charts, const std::string& path,
                        const FigureOptions& options) {
  check_figure_path(path);
  if (charts.empty()) throw Error(path + ": found no chart, must be one or more");
  std::vector<Box> worlds;
  for (const Chart& chart : charts) worlds.push_back(range_of(chart, path));
  const PanelGrid grid = grid_of(charts, worlds, path, options);
  const double width = grid.cell_width() * static_cast<double>(grid.columns);
  const double height = grid.cell_height() * static_cast<double>(grid.rows);
  const Legend legend = legend_of(charts, path, width - grid.left - kRight);
  Canvas canvas(path, width, height + legend.height());
  for (std::size_t k = 0; k < charts.size(); ++k)
    draw_panel(canvas, charts[k], grid.axes_of(k), worlds[k]);
  draw_legend(canvas, legend, {grid.left, height});
  return canvas.finish();
}

}  // namespace avo::figures
