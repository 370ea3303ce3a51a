// SPDX-License-Identifier: Apache-2.0
// A recording as a drawing that the page animates.
#include "reports/report_replay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

#include "avo/discs.h"
#include "avo/wall.h"
#include "figures/picture.h"
#include "figures/time_lapse.h"
#include "reports/html.h"

namespace avo_cli {
namespace {

namespace figures = avo::figures;

constexpr std::size_t kMostFrames = 600;
constexpr std::size_t kMostPositions = 400'000;  // 2.2 MB on a page
constexpr std::uint16_t kNotThere = 65535;

/// Returns "#rrggbb".
std::string word_of(const figures::Color& color) {
  const auto level = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", level(color.red), level(color.green),
                     level(color.blue));
}

std::uint16_t coordinate(double value, double low, double size) {
  return static_cast<std::uint16_t>(
      std::lround(65534.0 * std::clamp((value - low) / size, 0.0, 1.0)));
}

/// Returns the discs of robot i.
std::vector<avo::Disc> discs_of(const avo::Scenario& scenario, const avo_io::RecordedFrame& frame,
                                std::size_t i) {
  return discs_at(scenario.robots[i], frame.position[i], frame.heading[i]);
}

/// Returns the box of everything that is visible at any time.
figures::Box world_of(const avo_io::RecordedRun& run) {
  const avo::Scenario& scenario = run.scenario;
  figures::Box world = figures::world_of(scenario);
  const auto add = [&world](avo::Vec2 center, double radius) {
    world = enclosing(world, figures::enclosing(avo::Disc{center, radius}));
  };
  for (const avo_io::RecordedFrame& frame : run.frames) {
    for (std::size_t i = 0; i < scenario.robots.size(); ++i)
      for (const avo::Disc& disc : discs_of(scenario, frame, i)) add(disc.center, disc.radius);
    for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k)
      add(frame.mover_position[k], scenario.moving_obstacles[k].radius);
  }
  return world;
}

}  // namespace

std::size_t most_frames(std::int64_t robots) {
  return std::clamp(kMostPositions / static_cast<std::size_t>(robots), std::size_t{2}, kMostFrames);
}

std::string drawing_of(const avo_io::RecordedRun& run, std::size_t views) {
  const avo::Scenario& scenario = run.scenario;
  const figures::Box world = world_of(run);
  const avo::Vec2 low = world.lower, size = world.upper - world.lower;
  const double hair = 0.002 * std::max(size.x, size.y);  // m
  std::string svg = fmt::format(
      "<svg viewBox=\"{} {} {} {}\" role=\"img\" aria-label=\"replay\"><g "
      "transform=\"scale(1,-1)\" "
      "stroke-width=\"{:.4g}\">\n<g stroke=\"#555\" stroke-linecap=\"round\">\n",
      low.x, -low.y - size.y, size.x, size.y, hair);
  for (const avo::Wall& wall : walls_of(scenario.obstacles))
    svg += fmt::format(
        "<line x1=\"{:.6g}\" y1=\"{:.6g}\" x2=\"{:.6g}\" y2=\"{:.6g}\" stroke-width=\"{:.4g}\"/>\n",
        wall.a.x, wall.a.y, wall.b.x, wall.b.y, std::max(2.0 * wall.radius, hair));
  svg += "</g>\n<g>\n";
  const std::vector<figures::Color> colors = figures::robot_colors(scenario, views);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    if (!is_parked(scenario.robots[i]))
      svg += fmt::format("<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.4g}\" fill=\"{}\"/>\n",
                         scenario.robots[i].goal.x, scenario.robots[i].goal.y, 2.0 * hair,
                         word_of(colors[i]));
  svg += "</g>\n<g id=\"bodies\" fill-opacity=\"0.85\">\n";
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    for (const avo::Disc& disc : discs_at(scenario.robots[i], {}, 0.0))
      svg += fmt::format("<circle r=\"{:.6g}\" fill=\"{}\"><title>robot {}</title></circle>\n",
                         disc.radius, word_of(colors[i]), i % (scenario.robots.size() / views));
  for (std::size_t i = 0; i < scenario.moving_obstacles.size(); ++i)
    svg += fmt::format(
        "<circle r=\"{:.6g}\" fill=\"#555\"><title>moving obstacle {}</title></circle>\n",
        scenario.moving_obstacles[i].radius, i);
  return svg + "</g></g></svg>";
}

std::string data_of(const avo_io::RecordedRun& run) {
  const avo::Scenario& scenario = run.scenario;
  const figures::Box world = world_of(run);
  const avo::Vec2 low = world.lower, size = world.upper - world.lower;
  std::vector<std::uint16_t> positions;
  const auto add = [&](avo::Vec2 at, bool there) {
    positions.push_back(there ? coordinate(at.x, low.x, size.x) : kNotThere);
    positions.push_back(there ? coordinate(at.y, low.y, size.y) : kNotThere);
  };
  std::vector<double> times;
  for (const avo_io::RecordedFrame& frame : run.frames) {
    times.push_back(frame.time);
    for (std::size_t i = 0; i < scenario.robots.size(); ++i)
      for (const avo::Disc& disc : discs_of(scenario, frame, i)) add(disc.center, frame.there[i]);
    for (const avo::Vec2 at : frame.mover_position) add(at, true);
  }
  const std::string bytes(reinterpret_cast<const char*>(positions.data()),
                          positions.size() * sizeof positions[0]);
  const nlohmann::ordered_json json{{"times", times},
                                    {"low", {low.x, low.y}},
                                    {"size", {size.x, size.y}},
                                    {"positions", base64(bytes)}};
  return json.dump();
}

avo_io::RecordedRun run_in_plane(const avo::space::Scenario& scenario,
                                 const std::vector<figures::SpaceRecorder::Frame>& frames) {
  const figures::ViewsInPlane views = views_in_plane(scenario, frames);
  avo_io::RecordedRun run;
  run.scenario = views.scenario;
  run.travelers = static_cast<std::int64_t>(scenario.robots.size());
  for (const figures::SpaceRecorder::Frame& frame : frames) {
    const std::size_t discs = 2 * frame.position.size();
    run.frames.push_back({frame.time, views.places(frame.position), std::vector<double>(discs, 0.0),
                          std::vector<bool>(discs, true), views.places(frame.mover)});
  }
  return run;
}

}  // namespace avo_cli
