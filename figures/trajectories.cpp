// SPDX-License-Identifier: Apache-2.0
// Time-lapse of a run as in the paper's Figs. 1, 7, 8 and 9.
#include "figures/trajectories.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "avo/error.h"
#include "figures/axes.h"
#include "figures/canvas.h"
#include "figures/robot_drawing.h"
#include "figures/time_lapse.h"
#include "figures/walls.h"

namespace avo::figures {
namespace {

constexpr std::size_t kMostDiscs = 1500;  // more discs would hide each other
constexpr double kPanelGap = 10.0;        // pt

// One panel: its frames and its scenario.
struct TimeLapse {
  const Scenario& scenario;
  std::span<const TrajectoryFrame> frames;
  std::vector<std::size_t> selected;  // ascending; the newest is drawn full
  std::vector<Color> colors;
};

void draw_paths(Canvas& canvas, const TimeLapse& lapse) {
  const std::size_t first = lapse.selected.front();
  const std::size_t last = lapse.selected.back();
  // one point per half point of the page is enough for a line
  const double closest = 0.5 / canvas.scale();
  for (std::size_t i = 0; i < lapse.scenario.robots.size(); ++i) {
    if (is_parked(lapse.scenario.robots[i])) continue;
    std::vector<Vec2> path{lapse.frames[first].position[i]};
    for (std::size_t k = first + 1; k <= last; ++k) {
      const Vec2 at = lapse.frames[k].position[i];
      if (norm(at - path.back()) >= closest || k == last) path.push_back(at);
    }
    canvas.add_polyline(path);
    canvas.stroke({mix(kWhite, lapse.colors[i], 0.5), 0.4});
  }
}

void draw_goals(Canvas& canvas, const TimeLapse& lapse) {
  for (std::size_t i = 0; i < lapse.scenario.robots.size(); ++i)
    draw_goal(canvas, lapse.scenario.robots[i], lapse.colors[i]);
}

void draw_lapse(Canvas& canvas, const TimeLapse& lapse) {
  const Canvas::ClipScope scope(canvas);
  canvas.clip_to_view();
  draw_walls(canvas, lapse.scenario.obstacles);
  draw_paths(canvas, lapse);
  const double start = lapse.frames[lapse.selected.front()].time;
  const double span = lapse.frames[lapse.selected.back()].time - start;
  for (const std::size_t frame : lapse.selected) {
    const bool newest = frame == lapse.selected.back();
    const double age = newest || !(span > 0.0) ? 1.0 : (lapse.frames[frame].time - start) / span;
    for (std::size_t i = 0; i < lapse.scenario.moving_obstacles.size(); ++i) {
      const double radius = lapse.scenario.moving_obstacles[i].radius;
      draw_mover(canvas, {lapse.frames[frame].mover_position[i], radius}, age);
    }
    for (std::size_t i = 0; i < lapse.scenario.robots.size(); ++i) {
      const TrajectoryFrame& at = lapse.frames[frame];
      const double heading = at.heading.empty() ? 0.0 : at.heading[i];
      draw_robot(canvas, lapse.scenario.robots[i], {at.position[i], heading}, lapse.colors[i], age);
    }
  }
  draw_goals(canvas, lapse);
}

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g s", time);
  return text;
}

double panel_height(const Box& world, double panel_width) {
  const Vec2 size = world.upper - world.lower;
  return panel_width * std::clamp(size.y / std::fmax(size.x, 1e-9), 0.2, 1.3);
}

// Draws the panels of one figure side by side, all on the same scale.
std::string draw_panels(std::span<const TimeLapse> panels, const Box& world,
                        std::span<const std::string> titles, const std::string& path,
                        const FigureOptions& options) {
  const double left = options.axes ? axes_left(path, world, {.most_ticks_y = kMostTicks}) : kMargin;
  const double bottom = options.axes ? kAxesBottom : kMargin;
  const double top = (options.title.empty() ? kMargin : kTitleHeight) +
                     (titles.empty() ? 0.0 : kTitleHeight - 4.0);
  const double count = static_cast<double>(panels.size());
  const double panel = (options.width - left - kMargin - (count - 1.0) * kPanelGap) / count;
  const double height =
      options.height > 0.0 ? options.height - top - bottom : panel_height(world, panel);
  Canvas canvas(path, options.width, top + height + bottom);
  if (!options.title.empty()) {
    canvas.plain_page_text({0.5 * options.width, 12.0}, options.title,
                           {.size = 10.0, .color = gray(0.1), .align_x = 0.5});
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double x = left + static_cast<double>(i) * (panel + kPanelGap);
    canvas.set_view({{x, top}, {x + panel, top + height}}, world);
    draw_lapse(canvas, panels[i]);
    if (options.axes) {
      const auto ticks = [](double length) {
        return std::clamp(static_cast<int>(length / 28.0), 3, kMostTicks);
      };
      draw_axes(canvas, {.x_label = "x (m)",
                         .y_label = i == 0 ? options.y_label : "",
                         .most_ticks_x = ticks(panel),
                         .most_ticks_y = ticks(height),
                         .y_numbers = i == 0});
    }
    if (!titles.empty()) {
      canvas.plain_page_text({x + 0.5 * panel, top - 5.0}, titles[i],
                             {.size = 9.0, .color = gray(0.1), .align_x = 0.5});
    }
  }
  return canvas.finish();
}

Box with_margin(const Box& world) {
  const Vec2 size = world.upper - world.lower;
  return grown(world, 0.03 * std::fmax(std::fmax(size.x, size.y), 1e-6));
}

// Leaves the robots of these rows alone.
template <typename Value>
void keep_rows(std::vector<Value>& values, std::span<const std::size_t> rows) {
  if (values.empty()) return;
  std::vector<Value> kept;
  for (const std::size_t row : rows) kept.push_back(values[row]);
  values = std::move(kept);
}

std::string draw_lapse_of(const Scenario& scenario, std::span<const TrajectoryFrame> frames,
                          std::vector<Color> colors, const std::string& path,
                          const FigureOptions& options) {
  const std::size_t last = last_motion(scenario, frames);
  const TimeLapse lapse{scenario, frames, select_frames(scenario, frames, last, kMostDiscs),
                        std::move(colors)};
  return draw_panels({&lapse, 1}, with_margin(covered(scenario, frames, 0, last)), {}, path,
                     options);
}

}  // namespace

std::string draw_trajectories(const Scenario& scenario, std::span<const TrajectoryFrame> frames,
                              const std::string& path, const FigureOptions& options) {
  check_figure_path(path);
  check_frames(scenario, frames);
  std::vector<Color> colors = robot_colors(scenario);
  if (options.robots.empty()) return draw_lapse_of(scenario, frames, colors, path, options);
  Scenario fewer = scenario;
  std::vector<TrajectoryFrame> theirs(frames.begin(), frames.end());
  keep_rows(fewer.robots, options.robots);
  keep_rows(colors, options.robots);
  for (TrajectoryFrame& frame : theirs) {
    keep_rows(frame.position, options.robots);
    keep_rows(frame.heading, options.robots);
  }
  return draw_lapse_of(fewer, theirs, colors, path, options);
}

std::string draw_instants(const Scenario& scenario, std::span<const TrajectoryFrame> frames,
                          std::span<const double> times, double tail, const std::string& path,
                          const FigureOptions& options) {
  check_figure_path(path);
  check_frames(scenario, frames);
  std::vector<TimeLapse> panels;
  std::vector<std::string> titles;
  for (const double time : times) {
    const std::size_t last = frame_at(frames, time);
    const std::size_t first = frame_at(frames, frames[last].time - tail);
    std::vector<std::size_t> selected =
        select_frames(scenario, frames.subspan(first), last - first, kMostDiscs);
    for (std::size_t& index : selected) index += first;
    panels.push_back({scenario, frames, std::move(selected), robot_colors(scenario)});
    titles.push_back("t = " + seconds(frames[last].time));
  }
  const Box world = with_margin(covered(scenario, frames, 0, frames.size() - 1));
  return draw_panels(panels, world, titles, path, options);
}

std::string draw_side_by_side(std::span<const TracedRun> runs, const std::string& path,
                              const FigureOptions& options) {
  check_figure_path(path);
  if (runs.empty()) throw Error(path + ": found no run, must be one or more");
  std::vector<TimeLapse> panels;
  std::vector<std::string> titles;
  std::optional<Box> world;
  for (const TracedRun& run : runs) {
    check_frames(run.scenario, run.frames);
    const std::size_t last = last_motion(run.scenario, run.frames);
    panels.push_back(
        {run.scenario, run.frames, select_frames(run.scenario, run.frames, last, kMostDiscs),
         run.like_first && !panels.empty() ? panels.front().colors : robot_colors(run.scenario)});
    titles.push_back(run.title);
    const Box all = covered(run.scenario, run.frames, 0, last);
    world = world ? enclosing(*world, all) : all;
  }
  return draw_panels(panels, with_margin(*world), titles, path, options);
}

}  // namespace avo::figures
