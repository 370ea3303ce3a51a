// SPDX-License-Identifier: Apache-2.0
// A scene made of a motion, for motions of other programs that have none.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "avo_io/convert.h"
#include "avo_io/errors.h"
#include "avo_io/recording.h"

namespace avo_io {
namespace {

/// What a motion says of one robot.
struct SeenRobot {
  double first_time = 0.0, last_time = 0.0;                // s
  avo::Vec2 first_position, last_position;                 // m
  avo::Vec2 first_velocity, last_velocity;                 // m/s
  double largest_speed = 0.0, largest_acceleration = 0.0;  // m/s, m/s^2
};

struct SeenMotion {
  std::map<std::int64_t, SeenRobot> robots;  // by their numbers in the motion
  std::vector<double> gaps;                  // s, from each time to the next one
  double first_time = 0.0, last_time = 0.0;  // s
  std::int64_t every = 1;                    // see RecordedTime
};

void see(const avo::CheckedState& row, double time, SeenMotion& motion) {
  const auto [entry, is_new] = motion.robots.try_emplace(row.robot);
  SeenRobot& robot = entry->second;
  if (is_new) {
    robot.first_time = time;
    robot.first_position = row.position, robot.first_velocity = row.velocity;
  } else {
    const double change = norm(row.velocity - robot.last_velocity) / (time - robot.last_time);
    robot.largest_acceleration = std::max(robot.largest_acceleration, change);
  }
  robot.last_time = time;
  robot.last_position = row.position, robot.last_velocity = row.velocity;
  robot.largest_speed = std::max(robot.largest_speed, norm(row.velocity));
}

SeenMotion motion_of(const std::string& input) {
  SeenMotion motion;
  RecordingReader reader(input);
  RecordedTime moment;
  for (bool is_first = true; reader.next(moment); is_first = false) {
    if (is_first) motion.first_time = moment.time;
    if (!is_first) motion.gaps.push_back(moment.time - motion.last_time);
    motion.last_time = moment.time, motion.every = moment.every;
    for (const avo::CheckedState& row : moment.rows) see(row, moment.time, motion);
  }
  return motion;
}

double usual_gap(std::vector<double> gaps) {
  const auto middle = gaps.begin() + std::ssize(gaps) / 2;
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

// A robot that never moves has the usual limits.
std::string line_of(const SeenRobot& robot, double first_time, double radius) {
  const auto pair = [](avo::Vec2 v) { return fmt::format("[{}, {}]", v.x, v.y); };
  std::string line = fmt::format("  - {{position: {}, goal: {}, radius: {}",
                                 pair(robot.first_position), pair(robot.last_position), radius);
  if (robot.first_time > first_time)
    line += fmt::format(", start_time: {:.12g}", robot.first_time - first_time);
  else
    line += fmt::format(", velocity: {}", pair(robot.first_velocity));
  if (robot.largest_speed > 0.0) line += fmt::format(", max_speed: {}", robot.largest_speed);
  if (robot.largest_acceleration > 0.0)
    line += fmt::format(", max_acceleration: {}", robot.largest_acceleration);
  return line + "}\n";
}

// Robots are added behind lines of keys; between braces there is no such place.
void require_lines(const SceneSource& surroundings) {
  const std::size_t begin = surroundings.yaml.find_first_not_of(" \t\r\n");
  if (begin != std::string::npos && surroundings.yaml[begin] == '{')
    throw SceneError(surroundings.name +
                     ": found a scene in braces, must have its keys in lines, so that robots can "
                     "be added");
}

}  // namespace

MotionScene scene_of_motion(const std::string& input, const SceneSource& surroundings,
                            double radius) {
  require_lines(surroundings);
  const SeenMotion motion = motion_of(input);
  MotionScene made{.source = surroundings, .first_time = motion.first_time};
  const double step = usual_gap(motion.gaps) / static_cast<double>(motion.every);
  const double duration = std::max(motion.last_time - motion.first_time, step);
  // differences of times, without the digits of their rounding
  const std::vector<std::pair<std::string, std::string>> settings{
      {"time_step", fmt::format("{:.12g}", step)},
      {"duration", fmt::format("{:.12g}", duration)},
      {"allow_broken_assumptions", "true"}};
  if (surroundings.yaml.empty()) {
    made.source.name = input;
    made.source.yaml =
        fmt::format("version: 1\nname: {:?}\n", std::filesystem::path(input).stem().string());
    for (const auto& [key, value] : settings) made.source.yaml += key + ": " + value + "\n";
  } else {
    for (const auto& [key, value] : settings) made.source.overrides.push_back(key + "=" + value);
  }
  if (!made.source.yaml.ends_with('\n')) made.source.yaml += '\n';
  made.source.yaml += "robots:\n";
  for (const auto& [number, robot] : motion.robots) {
    made.robots.push_back(number);
    made.source.yaml += line_of(robot, motion.first_time, radius);
  }
  return made;
}

}  // namespace avo_io
