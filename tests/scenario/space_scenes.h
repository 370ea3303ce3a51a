// SPDX-License-Identifier: Apache-2.0
// Scenes of space for explanations of decisions.
#pragma once
#include <string>
#include <vector>

#include "avo_io/space.h"

namespace avo_test::in_space {

struct SpaceRun {
  std::string name;
  avo::space::Scenario scenario;
};

inline avo::space::Scenario parsed(const std::string& yaml) {
  return avo_io::parse_space_scenario("version: 1\nspace: 3\n" + yaml, "scene.yaml");
}

inline avo::space::Scenario example(const std::string& name) {
  const std::string folder = std::string(AVO_TEST_DATA) + "/../../examples/space/";
  return avo_io::load_space_scenario(folder + name + ".yaml").value();
}

inline const std::string kSphere =
    "groups:\n  - {count: 30, sphere: {radius: 5}, goal: antipodal, jitter: 0.2}\n";
inline const std::string kBalls = R"(moving_obstacles:
  - {trajectory: [[0, -12, 1, 0], [8, 12, -1, 0]], radius: 1}
  - {position: [0, 0, 25], velocity: [0, 0, -3], radius: 0.4, max_deviation: 0.2, max_speed: 4}
)";
inline const std::string kSenses =
    "sensing: {noise: {position: 0.02, velocity: 0.04}, delay: 1, dropped: 0.1}\n";

// Spheres with all that robots can sense, and the examples.
inline std::vector<SpaceRun> space_runs() {
  std::vector<SpaceRun> all{
      {"antipodal", parsed(kSphere)},
      {"at once", parsed("response_time: 0\nmax_neighbors: 8\n" + kSphere)},
      {"uncertified", parsed("certificate: none\n" + kSphere)},
      {"boxes", parsed("obstacles:\n  - {floor: -6}\n  - {box: {min: [-1, -1, -1], max: [1, 1, 1]}}"
                       "\n" +
                       kSphere)},
      {"movers", parsed(kBalls + kSphere)},
      {"errors", parsed(kSenses + kSphere)},
      {"errors beside movers", parsed(kSenses + kBalls + kSphere)},
      {"unequal limits",
       parsed("groups:\n  - {count: 24, sphere: {radius: 6}, goal: antipodal, vertical: 0.6, "
              "climb: 1, sink: 0.8, downwash: 0.7, jitter: 0.2}\n")}};
  for (const char* name : {"balls", "helicopter", "window", "shaft-one-lane", "building"})
    all.push_back({name, example(name)});
  return all;
}

}  // namespace avo_test::in_space
