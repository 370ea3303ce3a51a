// SPDX-License-Identifier: Apache-2.0
// Scenes of space with sensing and moving obstacles on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string kMoverScene = R"(version: 1
space: 3
duration: 20
sensing:
  noise: {position: 0.01, velocity: 0.02}
  delay: 1
  dropped: 0.05
moving_obstacles:
  - {trajectory: [[0, -20, 1, 0], [10, 20, -1, 0]], radius: 1}
  - {position: [0, 0, 25], velocity: [0, 0, -3], radius: 0.4, max_deviation: 0.2, max_speed: 4}
groups:
  - {count: 8, sphere: {radius: 6}, goal: antipodal, jitter: 0.1}
)";

// A robot stands on the course of a ball.
const std::string kInTheWay = R"(version: 1
space: 3
duration: 3
moving_obstacles:
  - {position: [-6, 0, 0], velocity: [4, 0, 0], radius: 0.4}
robots:
  - {position: [0, 0, 0], goal: [0, 0, 0]}
)";

ProcessResult judged_beside(const std::string& scene, const std::string& csv,
                            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"check", csv, "--scene", scene};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_avo(arguments);
}

std::string refused_with(const std::string& what, const std::string& instead) {
  std::string text = kMoverScene;
  text.replace(text.find(what), what.size(), instead);
  write_file(path_of("bad.yaml"), text);
  const ProcessResult result = run_avo({"validate", path_of("bad.yaml")});
  EXPECT_NE(result.exit_code, 0);
  return result.err;
}

TEST(SpaceMovers, are_run_drawn_and_judged_with_the_scene) {
  const std::string scene = path_of("movers.yaml"), csv = path_of("movers.csv");
  write_file(scene, kMoverScene);
  const ProcessResult run = run_avo({"run", scene, "--record", csv, "--summary", path_of("s.json"),
                                     "--figure", path_of("f.svg")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json summary = Json::parse(read_file(path_of("s.json")));
  EXPECT_EQ(summary["collision_pairs"], 0);
  EXPECT_EQ(summary["mover_collisions_in_motion"], 0);
  const ProcessResult check = judged_beside(scene, csv, {"--movers-at-rest", "ok"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, HasSubstr("moving obstacles   0 hit by a robot in motion"));
}

TEST(SpaceMovers, are_named_where_a_robot_makes_room_for_them) {
  const std::string scene = path_of("way.yaml");
  write_file(scene, kInTheWay + "sensing: {noise: {position: 0.01, velocity: 0.01}, delay: 1}\n");
  const std::vector<std::string> words{"explain", scene, "--robot", "0", "--time", "0.7"};
  const ProcessResult told = run_avo(words);
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("sees                0 robots, 0 boxes and 1 moving obstacle\n"));
  EXPECT_THAT(told.out, HasSubstr(", of moving obstacle 0"));
  std::vector<std::string> as_json = words;
  as_json.emplace_back("--json");
  const Json json = Json::parse(run_avo(as_json).out);
  EXPECT_EQ(json["half_spaces"][0]["neighbor"], "moving_obstacles.0");
  EXPECT_EQ(json["neighbors"][0]["behavior"], "moves_on");
  EXPECT_THAT(json["sentence"].get<std::string>(), HasSubstr("moving obstacle 0"));
}

TEST(SpaceMovers, a_hit_at_rest_is_judged_as_asked) {
  const std::string scene = path_of("hit.yaml"), csv = path_of("hit.csv");
  write_file(scene, kInTheWay);
  std::string rows = "time,robot,x,y,z,vx,vy,vz\n";  // it does not move
  for (int step = 0; step <= 30; ++step) rows += std::to_string(0.1 * step) + ",0,0,0,0,0,0,0\n";
  write_file(csv, rows);
  const ProcessResult strict = judged_beside(scene, csv);
  EXPECT_NE(strict.exit_code, 0);
  EXPECT_THAT(strict.out, HasSubstr("1 hit a robot at rest"));
  EXPECT_EQ(judged_beside(scene, csv, {"--movers-at-rest", "ok"}).exit_code, 0);
}

TEST(SpaceMovers, mistakes_in_scenes_are_named) {
  EXPECT_THAT(refused_with("[0, -20, 1, 0]", "[0, -20, 1]"),
              HasSubstr("moving_obstacles.0.trajectory.0: found"));
  EXPECT_THAT(refused_with("radius: 1}", "radius: 1, velocity: [1, 0, 0]}"),
              HasSubstr("moving_obstacles.0.velocity: found"));
  EXPECT_THAT(refused_with("max_deviation: 0.2, ", ""),
              HasSubstr("moving_obstacles.1.max_speed: found 4, must be left out"));
  EXPECT_THAT(refused_with("dropped: 0.05", "localization: {position: -0.1}"),
              HasSubstr("sensing.localization.position: found -0.1, must be >= 0 m"));
}

}  // namespace
}  // namespace avo_test
