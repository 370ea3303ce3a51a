// SPDX-License-Identifier: Apache-2.0
// Moments of a run as pictures of pixels.
#include "figures/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "figures/robot_drawing.h"
#include "figures/time_lapse.h"
#include "figures/walls.h"

namespace avo::figures {

struct MomentPainter::State {
  const Scenario& scenario;
  Box world;
  double width, height;  // pt, half a pixel each
  std::vector<Color> colors;
  std::optional<Canvas> canvas;  // of the last picture

  void draw_paths(std::span<const TrajectoryFrame> frames, const std::vector<bool>& there);
};

MomentPainter::MomentPainter(const Scenario& scenario, const Box& world, int width, int height,
                             std::size_t views)
    : state_(new State{
          scenario, world, 0.5 * width, 0.5 * height, robot_colors(scenario, views), {}}) {}
MomentPainter::~MomentPainter() = default;

void MomentPainter::State::draw_paths(std::span<const TrajectoryFrame> frames,
                                      const std::vector<bool>& there) {
  const double closest = 0.5 / canvas->scale();
  std::vector<Vec2> path;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    if (is_parked(scenario.robots[i]) || !there[i]) continue;
    path.clear();
    for (const TrajectoryFrame& frame : frames)
      if (path.empty() || norm(frame.position[i] - path.back()) >= closest)
        path.push_back(frame.position[i]);
    if (path.size() < 2) continue;
    canvas->add_polyline(path);
    canvas->stroke({mix(kWhite, colors[i], 0.45), 0.8});
  }
}

std::string_view MomentPainter::paint(std::span<const TrajectoryFrame> frames,
                                      const std::vector<bool>& there) {
  State& state = *state_;
  Canvas& canvas = state.canvas.emplace("moment.png", state.width, state.height);
  canvas.set_view({{0.0, 0.0}, {state.width, state.height}}, state.world);
  const TrajectoryFrame& now = frames.back();
  const Scenario& scenario = state.scenario;
  draw_walls(canvas, scenario.obstacles);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    draw_goal(canvas, scenario.robots[i], mix(kWhite, state.colors[i], 0.6));
  state.draw_paths(frames, there);
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k)
    draw_mover(canvas, {now.mover_position[k], scenario.moving_obstacles[k].radius}, 1.0);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    if (there[i])
      draw_robot(canvas, scenario.robots[i],
                 {now.position[i], now.heading.empty() ? 0.0 : now.heading[i]}, state.colors[i],
                 1.0);
  char time[32];
  std::snprintf(time, sizeof time, "%.1f s", now.time);
  canvas.plain_page_text({10.0, 18.0}, time, {.size = 12.0, .color = gray(0.2), .halo = true});
  return canvas.pixels();
}

Box world_of(const Scenario& scenario) {
  TrajectoryFrame start;
  for (const RobotSetup& robot : scenario.robots) {
    start.position.push_back(robot.position);
    start.heading.push_back(robot.heading);
  }
  for (const MovingObstacle& obstacle : scenario.moving_obstacles)
    start.mover_position.push_back(obstacle.position);
  const Box world = covered(scenario, {&start, 1}, 0, 0);
  const Vec2 size = world.upper - world.lower;
  return grown(world, 0.05 * std::fmax(std::fmax(size.x, size.y), 1e-6));
}

}  // namespace avo::figures
