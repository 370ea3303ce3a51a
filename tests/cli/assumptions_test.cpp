// SPDX-License-Identifier: Apache-2.0
// Scenes that break what their certificate assumes: one line each, exit code 3, nothing written;
// the remedies.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "run_avo.h"

namespace avo_test {
namespace {

// Two robots head-on, at 2 m/s where `speed` is 2.
std::string head_on(double distance, const std::string& speed, const std::string& more = "") {
  return "version: 1\nduration: 20\n" + more +
         "robots:\n"
         "  - {position: [0, 0], velocity: [" +
         speed +
         ", 0], goal: [20, 0]}\n"
         "  - {position: [" +
         std::to_string(distance) + ", 0], velocity: [-" + speed + ", 0], goal: [-20, 0]}\n";
}

std::vector<std::string> with_scene(std::vector<std::string> words, const std::string& yaml) {
  const std::string path = path_of("scene.yaml");
  write_file(path, yaml);
  words.insert(words.begin() + 1, path);
  return words;
}

// What is said to be wrong, less the name of the file; by all three verbs alike.
std::vector<std::string> refusal(const std::string& yaml,
                                 const std::vector<std::string>& options = {}) {
  std::vector<std::string> said;
  for (std::vector<std::string> words :
       {std::vector<std::string>{"validate"}, {"explain", "--robot", "0"}, {"run"}}) {
    words.insert(words.end(), options.begin(), options.end());
    const ProcessResult result = run_avo(with_scene(words, yaml));
    EXPECT_EQ(result.exit_code, 3) << words[0];
    EXPECT_EQ(result.out, "") << words[0];
    std::vector<std::string> lines = lines_of(result.err);
    const std::string place = path_of("scene.yaml") + ": ";
    for (std::string& line : lines) {
      if (line.starts_with(place)) line.erase(0, place.size());
    }
    if (!said.empty()) {
      EXPECT_EQ(lines, said) << words[0];
    }
    said = lines;
  }
  return said;
}

using Lines = std::vector<std::string>;

TEST(Assumptions, too_fast_for_their_distance) {
  EXPECT_EQ(run_avo(with_scene({"validate"}, head_on(5.0, "2"))).exit_code, 0);
  EXPECT_EQ(
      refusal(head_on(4.9, "2")),
      Lines{"robot 0 and robot 1 start too fast for their distance: found 0.1 m of overlap when "
            "both brake at once, must be none; slow down, move apart, or --start-at-rest"});
  EXPECT_EQ(
      refusal(head_on(3.0, "0", "moving_obstacles: [{position: [0, 3], velocity: [0, -1]}]\n"),
              {"--set", "robots.0.velocity=[0, 2]"}),
      Lines{"robot 0 and moving obstacle 0 start too fast for their distance: found 1 m of "
            "overlap when robot 0 brakes at once, must be none; slow down, move apart, or "
            "--start-at-rest"});
}

TEST(Assumptions, overlap) {
  EXPECT_EQ(
      refusal(head_on(0.75, "0")),
      Lines{"robot 0 and robot 1 overlap at the start: found 0.75 m between the centers, must be "
            ">= 0.5 + 0.5 = 1 m; move them apart"});
  EXPECT_EQ(
      refusal(head_on(3.0, "0", "moving_obstacles: [{position: [0, 1], radius: 0.6}]\n")),
      Lines{"robot 0 and moving obstacle 0 overlap at the start: found 1 m between the centers, "
            "must be >= 0.5 + 0.6 = 1.1 m; move them apart"});
}

TEST(Assumptions, faster_than_max_speed) {
  EXPECT_EQ(
      refusal(head_on(14.0, "2"), {"--set", "robots.1.velocity=[0, 2.5]"}),
      Lines{"velocity of robot 1: found 2.5 m/s at the start, must be <= its max_speed = 2 m/s; "
            "slow down, or --limit-speed or --start-at-rest"});
}

TEST(Assumptions, sensing_too_short) {
  EXPECT_EQ(run_avo(with_scene({"validate"}, head_on(9.0, "0", "sensing_radius: 5.4\n"))).exit_code,
            0);
  EXPECT_EQ(
      refusal(head_on(9.0, "0", "sensing_radius: 5.3999999\n")),
      Lines{"sensing_radius: found 5.3999999 m, must be >= 5.4 m for robot 0 and robot 1 to see "
            "each other in time, 2.7 + 2.7 m with one step and braking from their highest "
            "speeds; sense farther, or lower max_speed to 1.99999 m/s (--limit-speed)"});
  EXPECT_EQ(
      refusal(head_on(9.0, "0", "sensing_radius: 0.9\n"), {"--limit-speed"}),
      (Lines{"--limit-speed: max_speed of 0 of 2 robots lowered",
             "sensing_radius: found 0.9 m, must be >= 5.4 m for robot 0 and robot 1 to see each "
             "other in time, 2.7 + 2.7 m with one step and braking from their highest speeds; "
             "sense farther, no max_speed is low enough"}));
}

// What the message tells to type is accepted, a little less is not.
TEST(Assumptions, the_numbers_told_are_good) {
  const std::string yaml = head_on(30.0, "0", "sensing_radius: 4\n");
  const std::string line = refusal(yaml, {"--set", "robots.0.max_speed=1.7"}).at(0);
  const auto number_after = [&](const std::string& word) {
    const std::size_t at = line.find(word);
    return at == std::string::npos
               ? ""
               : line.substr(at + word.size(), line.find(' ', at + word.size()) - at - word.size());
  };
  const std::string range = number_after("must be >= "), speed = number_after("max_speed to ");
  EXPECT_EQ(range.substr(0, 4), "4.81");  // 2.7 + 0.5 + 0.17 + 1.445
  const auto code = [&](const std::string& key, const std::string& value) {
    return run_avo(with_scene(
                       {"validate", "--set", "robots.0.max_speed=1.7", "--set", key + "=" + value},
                       yaml))
        .exit_code;
  };
  EXPECT_EQ(code("sensing_radius", range), 0) << range;
  EXPECT_EQ(code("sensing_radius", std::to_string(std::stod(range) - 2e-5)), 3);
  const auto code_at = [&](const std::string& limit) {
    return run_avo(with_scene({"validate", "--set", "robots.0.max_speed=" + limit, "--set",
                               "robots.1.max_speed=" + limit},
                              yaml))
        .exit_code;
  };
  EXPECT_EQ(code_at(speed), 0) << speed;
  EXPECT_EQ(code_at(std::to_string(std::stod(speed) + 2e-5)), 3);
}

TEST(Assumptions, all_that_is_broken_the_worst_first) {
  const std::string yaml =
      "version: 1\nduration: 5\nsensing_radius: 5\nrobots:\n"
      "  - {position: [0, 0], goal: [0, 9]}\n  - {position: [0.9, 0], goal: [0, 9]}\n"
      "  - {position: [1.7, 0], goal: [0, 9]}\n  - {position: [2.4, 0], goal: [0, 9]}\n"
      "  - {position: [3, 0], goal: [0, 9]}\n  - {position: [90, 0], velocity: [3, 0], goal: [0, "
      "9]}\n"
      "  - {position: [90, 40], velocity: [3, 0], goal: [0, 9]}\n"
      "  - {position: [90, 80], velocity: [3.5, 0], goal: [0, 9]}\n"
      "  - {position: [90, 120], velocity: [3, 0], goal: [0, 9]}\n"
      "  - {position: [90, 160], velocity: [3, 0], goal: [0, 9]}\n";
  const Lines lines = refusal(yaml);
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_TRUE(lines[0].starts_with("robot 3 and robot 4 overlap at the start: found 0.6 m"));
  EXPECT_TRUE(lines[1].starts_with("robot 2 and robot 3 overlap at the start: found 0.7 m"));
  EXPECT_TRUE(lines[2].starts_with("robot 1 and robot 2 overlap at the start: found 0.8 m"));
  EXPECT_EQ(lines[3], "1 further pairs overlap or start too fast for their distance");
  EXPECT_TRUE(lines[4].starts_with("velocity of robot 7: found 3.5 m/s"));
  EXPECT_TRUE(lines[5].starts_with("velocity of robot 5: found 3 m/s"));
  EXPECT_TRUE(lines[6].starts_with("velocity of robot 6: found 3 m/s"));
  EXPECT_EQ(lines[7], "2 further robots start faster than their max_speed");
  EXPECT_TRUE(lines[8].starts_with("sensing_radius: found 5 m"));
}

TEST(Assumptions, nothing_is_written) {
  const std::vector<std::string> words =
      with_scene({"run", "--record", path_of("a.csv"), "--summary", path_of("a.json"), "--figure",
                  path_of("a.svg")},
                 head_on(4.9, "2"));
  EXPECT_EQ(run_avo(words).exit_code, 3);
  EXPECT_EQ(files_in(folder()), Lines{"scene.yaml"});
}

TEST(Assumptions, remedies_are_told_and_suffice) {
  const std::string yaml = head_on(4.9, "2", "sensing_radius: 4\n");
  for (const char* verb : {"validate", "run"}) {
    const ProcessResult result =
        run_avo(with_scene({verb, "--start-at-rest", "--limit-speed"}, yaml));
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(
        lines_of(result.err),
        (Lines{"--start-at-rest: 2 of 2 robots start at rest instead of moving",
               "--limit-speed: max_speed of 2 of 2 robots lowered to 1.6342857142868572 m/s"}));
  }
  const ProcessResult explained =
      run_avo(with_scene({"explain", "--robot", "1", "--start-at-rest", "--limit-speed"}, yaml));
  EXPECT_EQ(explained.exit_code, 0);
  EXPECT_NE(explained.out.find("(0, 0) m/s"), std::string::npos) << explained.out;
  // the speeds at the start follow the limit
  const ProcessResult limited = run_avo(with_scene({"run", "--limit-speed"}, yaml));
  EXPECT_EQ(limited.exit_code, 0);
  EXPECT_EQ(lines_of(limited.err),
            Lines{"--limit-speed: max_speed of 2 of 2 robots lowered to 1.6342857142868572 m/s, 2 "
                  "start slower"});
  EXPECT_NE(limited.out.find("0 pairs of robots"), std::string::npos);
}

TEST(Assumptions, without_a_certificate_there_are_warnings) {
  const std::string yaml = head_on(0.75, "2.5", "sensing_radius: 4\n");
  for (const char* setting : {"certificate=none", "method=avo_paper", "method=orca"}) {
    const ProcessResult result = run_avo(with_scene({"validate", "--set", setting}, yaml));
    EXPECT_EQ(result.exit_code, 0) << setting;
    for (const char* part : {"warning: robot 0 and robot 1 overlap at the start",
                             "warning: sensing_radius 4 m is less than",
                             "warning: velocity of robot 0 is 2.5 m/s at the start"}) {
      EXPECT_NE(result.err.find(part), std::string::npos) << setting << ": " << part;
    }
  }
  const ProcessResult result =
      run_avo(with_scene({"validate", "--set", "certificate=none", "--limit-speed"}, yaml));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(lines_of(result.err).at(0), "--limit-speed: max_speed of 0 of 2 robots lowered");
}

TEST(Assumptions, are_told_once) {
  const ProcessResult result =
      run_avo(with_scene({"validate", "--set", "sensing_radius=4"}, head_on(0.75, "2.5")));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err.find("warning"), std::string::npos) << result.err;
  EXPECT_EQ(lines_of(result.err).size(), 4U) << result.err;
}

TEST(Assumptions, a_scene_may_allow_for_breaking_them) {
  const std::string yaml = head_on(0.75, "0", "allow_broken_assumptions: true\n");
  const std::string recording = path_of("a.h5");
  const ProcessResult result = run_avo(with_scene({"run", "--record", recording}, yaml));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("warning: " + path_of("scene.yaml") +
                            ": robot 0 and robot 1 overlap at the start"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(run_avo({"replay", recording}).exit_code, 0);
  EXPECT_EQ(run_avo(with_scene({"validate", "--set", "robots.1.position=[0, 0]"}, yaml)).exit_code,
            0);
}

// The scene has two floors, and some robots go up and down.
TEST(Assumptions, robots_that_do_not_avoid_each_other_may_be_in_one_place) {
  const std::string floors =
      "version: 1\nrobots:\n"
      "  - {position: [-6, 0], goal: [6, 0], layers: [0], avoids: [0]}\n"
      "  - {position: [-6, 0], goal: [6, 0], layers: [1], avoids: [1]}\n";
  for (const char* verb : {"validate", "run"}) {
    const ProcessResult result = run_avo(with_scene({verb}, floors));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find("overlap"), std::string::npos) << result.err;
  }
  const std::string third = "  - {position: [-6, 0], goal: [6, 3], layers: [2], avoids: [1]}\n";
  EXPECT_EQ(lines_of(run_avo(with_scene({"validate"}, floors + third)).err).at(0),
            path_of("scene.yaml") +
                ":5:16: robots.2.position: found [-6, 0], the position of robots.1, must differ "
                "from it");
  // one below the other, at the same places
  const std::string group =
      "  - {number: 12, placement: {random: {min: [0, 0], max: [4, 5]}}, goals: antipodal, ";
  const std::string groups = "version: 1\ngroups:\n" + group + "layers: [0], avoids: [0]}\n";
  EXPECT_EQ(
      run_avo(with_scene({"validate"}, groups + group + "layers: [1], avoids: [1]}\n")).exit_code,
      0);
  EXPECT_EQ(
      run_avo(with_scene({"validate"}, groups + group + "layers: [1], avoids: [0]}\n")).exit_code,
      3);
}

TEST(Assumptions, recordings_are_judged_without_them) {
  const std::string recording = path_of("a.csv");
  const std::vector<std::string> none{"--set", "certificate=none"};
  std::vector<std::string> words = with_scene({"run", "--record", recording}, head_on(0.75, "0"));
  words.insert(words.end(), none.begin(), none.end());
  ASSERT_EQ(run_avo(words).exit_code, 0);
  EXPECT_EQ(run_avo({"check", recording, "--scene", path_of("scene.yaml")}).exit_code, 1);
}

}  // namespace
}  // namespace avo_test
