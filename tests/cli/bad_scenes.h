// SPDX-License-Identifier: Apache-2.0
// Bad scene files, and what is said of them.
#pragma once
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "run_avo.h"

namespace avo_test {

/// Text with its NUL bytes.
template <std::size_t N>
std::string s(const char (&text)[N]) {
  return {text, N - 1};
}

inline const std::string kGood = "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n";
inline const std::string kSceneKeys =
    "version, name, time_step, duration, control_time, time_horizon, sensing_radius, "
    "max_neighbors, method, certificate, motion, precision, samples, arrival_distance, seed, "
    "robots, groups, robots_from, "
    "moving_obstacles, obstacles, navigation, right_of_way, sensing, sensing_error, clock";
inline const std::string kRobotKeys =
    "position, velocity, goal, radius, max_speed, max_acceleration, preferred_speed, model, "
    "heading, car, drive, airplane, "
    "priority, max_braking, parked, layers, avoids, time_step";

struct BadScene {
  const char* name;
  std::string yaml;
  std::string message;  ///< after the name of the file
};

inline void PrintTo(const BadScene& scene, std::ostream* out) {
  *out << scene.name;
}

/// By `avo validate`, with one line and nothing else.
inline void expect_refused(const BadScene& scene) {
  const std::string path = path_of("bad.yaml");
  write_file(path, scene.yaml);
  const ProcessResult result = run_avo({"validate", path});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path + ":" + scene.message + "\n");
  EXPECT_EQ(result.out, "");
}

}  // namespace avo_test
