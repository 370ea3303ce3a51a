// SPDX-License-Identifier: Apache-2.0
// Selects the frames of a run that a time-lapse shows, and their colors.
#include "figures/time_lapse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "avo/error.h"
#include "figures/colors.h"
#include "figures/walls.h"

namespace avo::figures {
namespace {

// Distance between centers of two successive discs of one robot at cruising speed, in its
// diameters.
constexpr double kSpacing = 1.1;
// A robot within this part of its radius from its end has come to rest.
constexpr double kRest = 0.05;

bool all_finite(std::span<const Vec2> points) {
  return std::all_of(points.begin(), points.end(), [](Vec2 point) { return is_finite(point); });
}

bool has_headings(const Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const RobotSetup& robot) { return !is_holonomic(robot.model); });
}

// Returns the diameters per second of a cruising robot. It is the upper quintile over all robots
// and frames with motion, so that acceleration and braking have no effect.
double cruising_rate(const Scenario& scenario, std::span<const TrajectoryFrame> frames,
                     std::size_t last) {
  std::vector<double> rates;
  for (std::size_t k = 1; k <= last; ++k) {
    const double dt = frames[k].time - frames[k - 1].time;
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      const double moved = norm(frames[k].position[i] - frames[k - 1].position[i]);
      const double rate = moved / (2.0 * disc_radius(scenario.robots[i]) * dt);
      if (rate > 0.01) rates.push_back(rate);
    }
  }
  if (rates.empty()) return 0.0;
  const auto quintile = rates.begin() + static_cast<std::ptrdiff_t>(4 * (rates.size() - 1) / 5);
  std::nth_element(rates.begin(), quintile, rates.end());
  return *quintile;
}

}  // namespace

void check_frames(const Scenario& scenario, std::span<const TrajectoryFrame> frames) {
  if (frames.empty()) throw Error("figure of " + scenario.name + ": there is no frame to draw");
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const TrajectoryFrame& frame = frames[k];
    const std::string where = "figure of " + scenario.name + ": frame " + std::to_string(k) + ": ";
    if (frame.position.size() != scenario.robots.size() ||
        frame.mover_position.size() != scenario.moving_obstacles.size()) {
      throw Error(where + "found " + std::to_string(frame.position.size()) + " robots and " +
                  std::to_string(frame.mover_position.size()) + " moving obstacles, must be " +
                  std::to_string(scenario.robots.size()) + " and " +
                  std::to_string(scenario.moving_obstacles.size()));
    }
    if (has_headings(scenario) && frame.heading.size() != scenario.robots.size()) {
      throw Error(where + "the headings of the robots are missing");
    }
    if (!std::isfinite(frame.time) || !all_finite(frame.position) ||
        !all_finite(frame.mover_position)) {
      throw Error(where + "found a value that is not finite");
    }
    if (k > 0 && !(frame.time > frames[k - 1].time)) {
      throw Error(where + "found a time that is not later than the one before");
    }
  }
}

std::size_t last_motion(const Scenario& scenario, std::span<const TrajectoryFrame> frames) {
  std::size_t last = frames.size() - 1;
  const TrajectoryFrame& end = frames.back();
  const auto at_rest = [&](const TrajectoryFrame& frame) {
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      const double away = norm(frame.position[i] - end.position[i]);
      if (away > kRest * scenario.robots[i].radius) return false;
    }
    return true;
  };
  while (last > 0 && at_rest(frames[last - 1])) --last;
  // no robot ever moved: then the moving obstacles are what the figure can show
  return last == 0 ? frames.size() - 1 : last;
}

std::size_t frame_at(std::span<const TrajectoryFrame> frames, double time) {
  // the time of a step is a rounded multiple of the time step
  const double slack = 1e-9 * std::fmax(1.0, std::fabs(time));
  std::size_t index = 0;
  while (index + 1 < frames.size() && frames[index + 1].time <= time + slack) ++index;
  return index;
}

std::vector<std::size_t> select_frames(const Scenario& scenario,
                                       std::span<const TrajectoryFrame> frames, std::size_t last,
                                       std::size_t most_discs) {
  const double span = frames[last].time - frames[0].time;
  const double rate = cruising_rate(scenario, frames, last);
  const double robots = static_cast<double>(std::max<std::size_t>(scenario.robots.size(), 1));
  const double most_frames = std::fmax(2.0, static_cast<double>(most_discs) / robots);
  double count = std::floor(std::fmax(span * rate / kSpacing, 1.0));
  count = std::floor(std::fmin(count, most_frames - 1.0));
  std::vector<std::size_t> selected{0};
  for (double k = 1.0; k <= count; k += 1.0) {
    const std::size_t index = frame_at(frames, frames[0].time + span * k / count);
    if (index > selected.back()) selected.push_back(index);
  }
  return selected;
}

std::vector<Color> robot_colors(const Scenario& scenario, std::size_t views) {
  const std::size_t count = scenario.robots.size() / views;
  const std::span<const RobotSetup> robots(scenario.robots.data(), count);
  std::vector<Color> colors;
  if (count <= kFew.size()) {
    colors.assign(kFew.begin(), kFew.begin() + static_cast<std::ptrdiff_t>(count));
  } else {
    Vec2 middle;
    for (const RobotSetup& robot : robots) middle = middle + robot.position;
    middle = middle / static_cast<double>(count);
    for (const RobotSetup& robot : robots) {
      const Vec2 from = robot.position - middle;
      colors.push_back(direction_color(std::atan2(from.y, from.x) * 180.0 / std::numbers::pi));
    }
  }
  for (std::size_t k = count; k < scenario.robots.size(); ++k) colors.push_back(colors[k - count]);
  return colors;
}

Box covered(const Scenario& scenario, std::span<const TrajectoryFrame> frames, std::size_t first,
            std::size_t last) {
  const auto disc_box = [](Vec2 center, double radius) { return enclosing(Disc{center, radius}); };
  Box box;
  bool empty = true;
  const auto add = [&](const Box& part) {
    box = empty ? part : enclosing(box, part);
    empty = false;
  };
  if (const auto walls = covered(scenario.obstacles)) add(*walls);
  for (const RobotSetup& robot : scenario.robots) add(disc_box(robot.goal, 0.0));
  for (std::size_t k = first; k <= last; ++k) {
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      add(disc_box(frames[k].position[i], scenario.robots[i].radius));
    }
    for (std::size_t i = 0; i < scenario.moving_obstacles.size(); ++i) {
      add(disc_box(frames[k].mover_position[i], scenario.moving_obstacles[i].radius));
    }
  }
  return box;
}

}  // namespace avo::figures
