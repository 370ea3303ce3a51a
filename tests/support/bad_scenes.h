// SPDX-License-Identifier: Apache-2.0
// Bad scene files, and the messages about them from any reader.
#pragma once
#include <string>
#include <vector>

namespace avo_test {

/// Returns text that includes its NUL bytes.
template <std::size_t N>
std::string s(const char (&text)[N]) {
  return {text, N - 1};
}

inline const std::string kGood = "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n";
inline const std::string kSceneKeys =
    "version, name, time_step, duration, control_time, response_time, "
    "comfort_acceleration, comfort_jerk, margin, never_swerves, time_horizon, sensing_radius, "
    "max_neighbors, method, external_method, certificate, motion, arrival_distance, seed, "
    "robots, groups, robots_from, "
    "moving_obstacles, obstacles, navigation, right_of_way, sensing, sensing_error, clock, "
    "allow_broken_assumptions";
inline const std::string kRobotKeys =
    "position, velocity, goal, radius, max_speed, max_acceleration, preferred_speed, model, "
    "heading, car, drive, airplane, footprint, "
    "priority, max_braking, parked, layers, avoids, behavior, time_step, method, time_horizon, "
    "arrival_distance";

struct BadScene {
  const char* name;
  std::string yaml;
  std::string message;  ///< behind the name of the file
};

/// Returns scenes with values that scenes cannot have.
const std::vector<BadScene>& bad_scenes();
/// Returns texts that are no plain YAML, no text, or too deep.
const std::vector<BadScene>& bad_texts();

}  // namespace avo_test
