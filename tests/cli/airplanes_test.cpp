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
  ASSERT_EQ(json["neighbors"].size(), 1U);
  EXPECT_EQ(json["neighbors"][0]["neighbor"], 2);
  const avo::LoiterCircle circle = simulation.perceive({1}).robot.loiter.value();
  EXPECT_EQ(json["loiter"]["center"], (Json{circle.center.x, circle.center.y}));
  EXPECT_EQ(json["neighbors"][0]["loiter"]["radius"], circle.radius);  // it is as fast
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

// 1.5 m a step, between two of which it passes its goal.
TEST(Airplanes, check_sees_arrivals_between_rows) {
  for (const char* after : {"loiter", "leave"}) {
    const std::string scene = path_of("passing.yaml");
    write_file(scene,
               std::string("version: 1\nname: passing\nduration: 30\nsensing_radius: 200\n") +
                   "arrival_distance: 0.3\nrobots:\n  - {position: [0, 9], goal: [99.75, 9], " +
                   "heading: 0, radius: 3, max_speed: 15, max_acceleration: 2, airplane: " +
                   "{min_speed: 15, lateral_acceleration: 5, after_goal: " + after + "}}\n");
    const Recorded run = record({scene});
    ASSERT_EQ(run.summary["arrived"], 1);
    const ProcessResult result =
        run_avo({"check", run.csv, "--scene", scene, "--require-arrival", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["arrived"], 1);
    EXPECT_EQ(json["last_arrival"], run.summary["last_arrival"]);
    EXPECT_EQ(json["at_goal_at_end"], 0);
    const ProcessResult off = run_avo({"check", run.csv, "--scene", scene, "--require-arrival",
                                       "--set", "robots.0.goal=[99.75, 9.31]"});
    EXPECT_EQ(off.exit_code, 1) << off.out;
  }
}

TEST(Airplanes, explain_says_that_a_circle_keeps_clear) {
  const std::string scene = leaving();
  const auto said = [&](const Strings& more) {
    Strings words{"explain", scene, "--robot", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run_avo(words).out;
  };
  EXPECT_NE(said({}).find("  state               safe: its circle keeps clear of all others\n"),
            std::string::npos);
  // a robot that brakes, beside airplanes
  const std::string standing = "robots.1={position: [0, 20], goal: [60, 20]}";
  EXPECT_NE(said({"--set", standing}).find("safe: braking avoids contact\n"), std::string::npos)
      << said({"--set", standing});
}

/// An airplane that circles, and what passes over its circle.
std::string crossed_circle() {
  const std::string path = path_of("crossed_circle.yaml");
  write_file(
      path, "version: 1\nduration: 30\nsensing_radius: 60\nrobots:\n" +
                plane("[0, 0]", "goal: [0, 0], airplane: {min_speed: 1, lateral_acceleration: 1}") +
                "moving_obstacles:\n"
                "  - {position: [-11.4, -8], velocity: [2, 0], radius: 1}\n"
                "  - {position: [-3.8, 17], velocity: [0, -2], radius: 1}\n");
  return path;
}

TEST(Airplanes, evade_what_passes_over_their_circle) {
  const std::string scene = crossed_circle();
  const std::string said = run_avo({"explain", scene, "--robot", "0", "--time", "5"}).out;
  EXPECT_NE(said.find("evades              moving obstacle 0: towards"), std::string::npos) << said;
  EXPECT_NE(said.find("and then it could circle\n"), std::string::npos) << said;
  EXPECT_NE(
      said.find(
          "safe: its circle keeps clear of all that decide, and it has an evasive maneuver\n"),
      std::string::npos)
      << said;
  for (const bool evades : {true, false}) {
    const std::string certificate = evades ? "braking_trajectories" : "none";
    const Recorded run = record({scene, "--set", "certificate=" + certificate});
    EXPECT_EQ(run.summary["mover_collisions"], evades ? 0 : 2);
    EXPECT_EQ(run_avo({"check", run.csv, "--scene", scene}).exit_code, evades ? 0 : 1);
  }
}

/// What is said of two airplanes in a refused scene, the second one at that place.
std::string refusal_of_two(const std::string& place, const Strings& options = {}) {
  const std::string path = path_of("near.yaml");
  write_file(path, "version: 1\nname: near\nsensing_radius: 60\nrobots:\n" +
                       plane("[0, 0]", "goal: [50, 0], " + kLeaves) +
                       plane(place, "goal: [50, 9], " + kLeaves));
  Strings words{"validate", path};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_avo(words);
  EXPECT_EQ(result.exit_code, 3);
  const std::string said = lines_of(result.err).back();
  EXPECT_TRUE(said.starts_with(path + ": ")) << said;
  return said.substr(std::min(path.size() + 2, said.size()));
}

TEST(Airplanes, starts_that_circles_do_not_keep_apart) {
  // 2 m/s make circles of 4 m, 1 m/s those of 1 m
  EXPECT_EQ(refusal_of_two("[0, 8.5]"),
            "robot 0 and robot 1 start too fast for their distance: found 0.5 m of overlap when "
            "both circle at once, must be none; slow down, move apart, or --start-at-rest");
  EXPECT_EQ(run_avo({"validate", path_of("near.yaml"), "--start-at-rest"}).exit_code, 0);
  EXPECT_EQ(refusal_of_two("[0, 2.5]", {"--start-at-rest"}),
            "robot 0 and robot 1 start too near each other: found 0.5 m of overlap when both "
            "circle at once, must be none; move apart");
  EXPECT_EQ(refusal_of_two("[0, -8]", {"--set", "robots.1={position: [2, -4], goal: [9, 9]}"}),
            "robot 0 and robot 1 start too fast for their distance: found 1 m of overlap when "
            "robot 0 circles and robot 1 brakes at once, must be none; slow down, move apart, or "
            "--start-at-rest");
}

TEST(Airplanes, start_at_rest_and_limit_speed_keep_the_least_speed) {
  const std::string scene = leaving();
  const ProcessResult rest = run_avo(
      {"run", scene, "--start-at-rest", "--set", "duration=0.1", "--record", path_of("rest.csv")});
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(rest.err,
            "--start-at-rest: 3 of 3 robots start at rest, or at their min_speed, instead "
            "of moving faster\n");
  EXPECT_EQ(lines_of(read_file(path_of("rest.csv")))[1], "0,0,0,0,1,0,0,1");
  const ProcessResult slow =
      run_avo({"validate", scene, "--limit-speed", "--set", "sensing_radius=5"});
  EXPECT_EQ(slow.exit_code, 3);
  EXPECT_NE(slow.err.find("must be >= 17.4001 m for robot 0 and robot 1 to see each other in time, "
                          "8.70001 + 8.70001 m with one step and braking or circling at their "
                          "highest speeds; sense farther, no max_speed is low enough\n"),
            std::string::npos)
      << slow.err;
}

}  // namespace
}  // namespace avo_test
