// SPDX-License-Identifier: Apache-2.0
// Scenes with airplanes, which leave and cannot stop, from the command line.
#include <gtest/gtest.h>
#include <string>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "verdicts.h"

namespace avo_test {
namespace {

std::string plane(const std::string& place, const std::string& rest) {
  return "  - {position: " + place + ", model: airplane, heading: 0, radius: 0.5, max_speed: 2,\n" +
         "     max_acceleration: 1, " + rest + "}\n";
}

const std::string kLeaves = "airplane: {min_speed: 1, lateral_acceleration: 1, after_goal: leave}";

/// The first of three is gone early; the others fly on side by side.
std::string leaving() {
  const std::string path = path_of("leaving.yaml");
  write_file(path, "version: 1\nname: leaving\nduration: 20\nsensing_radius: 60\nrobots:\n" +
                       plane("[0, 0]", "goal: [3, 0], " + kLeaves) +
                       plane("[0, 20]", "goal: [60, 20], " + kLeaves) +
                       plane("[0, 30]", "goal: [60, 30], " + kLeaves));
  return path;
}

TEST(Airplanes, explain_finds_a_robot_after_others_have_left) {
  const std::string scene = leaving();
  avo::Simulation simulation(avo_io::load_scenario(scene), 1);
  for (int k = 0; k < 100; ++k) simulation.step();
  ASSERT_FALSE(simulation.index_of({0}));
  const std::size_t index = simulation.index_of({1}).value();
  ASSERT_EQ(index, 0U);
  const ProcessResult result =
      run_avo({"explain", scene, "--robot", "1", "--time", "10", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["robot"], 1);
  EXPECT_EQ(json["position"][1], simulation.fleet().position[index].y);
  EXPECT_EQ(json["goal"], (Json{60.0, 20.0}));
  ASSERT_EQ(json["obstacles"].size(), 1U);
  EXPECT_EQ(json["obstacles"][0]["neighbor"], 2);
  simulation.step();
  EXPECT_EQ(json["new_velocity"][0], simulation.fleet().plan[index].new_velocity.x);
  // the last one of the scene is beyond the end of the fleet
  const ProcessResult last =
      run_avo({"explain", scene, "--robot", "2", "--time", "10", "--figure", path_of("why.svg")});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_TRUE(last.out.starts_with("leaving, robot 2 at 10 s\n")) << last.out;
  EXPECT_EQ(last.out.find("robot 0"), std::string::npos) << last.out;
}

TEST(Airplanes, explain_refuses_one_that_has_left) {
  const std::string scene = leaving();
  const auto explained_at = [&](const char* time) {
    const ProcessResult result = run_avo({"explain", scene, "--robot", "0", "--time", time});
    EXPECT_EQ(result.out == "", result.exit_code == 2);
    return result.err;
  };
  EXPECT_EQ(explained_at("1.2"), "");
  // it has passed its goal then, and decides no more
  EXPECT_EQ(explained_at("1.3"), "avo: --time: found 1.3 s, must be < 1.3 s, when robot 0 left\n");
  EXPECT_EQ(explained_at("10"), "avo: --time: found 10 s, must be < 1.3 s, when robot 0 left\n");
}

}  // namespace
}  // namespace avo_test
