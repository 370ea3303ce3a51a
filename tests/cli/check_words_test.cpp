// SPDX-License-Identifier: Apache-2.0
// avo check: what it says, in words and JSON, and what it takes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "verdicts.h"

namespace avo_test {
namespace {

TEST(Check, says_what_it_found_in_words) {
  const ProcessResult good = check(kGoodRun);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.err, "");
  EXPECT_EQ(good.out, path_of("in.csv") +
                          ": 2 robots, 2 steps from 0 s to 1.5 s: safe\n"
                          "  overlaps           0 pairs of robots\n"
                          "  acceleration       0 robot-steps beyond the limit; largest 1 m/s^2\n"
                          "  speed              0 rows beyond the limit; largest 1.5 m/s\n"
                          "  jumps              0 robot-steps off their velocities\n"
                          "  least clearance    0.875 m\n");
  // too fast through each other, 4 - t and t + 3/2 t² apart at first; robot 9 comes back
  const ProcessResult bad = check(kHeader +
                                  "0,12,0,0,1,0\n0,4,4,0,-1,0\n0,9,0,50,0,0\n"
                                  "1,12,2.5,0,4,0\n1,4,3,0,-1,0\n"
                                  "2,12,6.5,0,4,0\n2,4,2,0,-1,0\n2,9,9,50,0,0\n");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_EQ(bad.out,
            path_of("in.csv") +
                ": 3 robots, 2 steps from 0 s to 2 s: unsafe\n"
                "  overlaps           1 pairs of robots, the first at 0.896805 s: robots 4 and 12, "
                "by 0.5 m; at most by 1 m\n"
                "  acceleration       1 robot-steps beyond the limit, the first at 0 s: robot 12, "
                "by 2 m/s^2; largest 3 m/s^2\n"
                "  speed              2 rows beyond the limit, the first at 1 s: robot 12, by 2 "
                "m/s; largest 4 m/s\n"
                "  jumps              0 robot-steps off their velocities\n"
                "  least clearance    -1 m\n"
                "  gaps               1 in the rows of a robot, not judged\n");
}

// It is unknown where robot 2 was in the missing row.
TEST(Check, calls_nobody_safe_whose_rows_are_missing) {
  const std::string rows = kHeader +
                           "0,1,0,0,0,0\n0,2,9,0,0,0\n0.1,1,0,0,0,0\n"
                           "0.2,1,0,0,0,0\n0.2,2,9,0,0,0\n0.3,1,0,0,0,0\n0.3,2,9,0,0,0\n";
  const ProcessResult found = check(rows);
  EXPECT_EQ(found.exit_code, 7);
  EXPECT_NE(found.out.find(": incomplete\n"), std::string::npos) << found.out;
  Strings words = kLimits;
  words.push_back("--json");
  const Json json = Json::parse(check(rows, words).out);
  EXPECT_EQ(json["verdict"], "incomplete");
  EXPECT_EQ(json["safe"], false);
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["gaps"], 1);
}

TEST(Check, json_has_all_keys_in_order) {
  const Json json = verdict(kGoodRun);
  Strings keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Strings{"recording",
                           "scene",
                           "passed",
                           "safe",
                           "verdict",
                           "robots",
                           "rows",
                           "steps",
                           "unjudged_steps",
                           "every",
                           "robot_steps",
                           "gaps",
                           "whole",
                           "lacking",
                           "from",
                           "to",
                           "overlaps",
                           "mover_contacts_moving",
                           "mover_contacts_at_rest",
                           "mover_hits",
                           "one_sided_contacts_moving",
                           "one_sided_contacts_at_rest",
                           "one_sided_hits",
                           "movers_at_rest",
                           "static_contacts",
                           "accelerations",
                           "speeds",
                           "jumps",
                           "headings",
                           "turns",
                           "lateral_accelerations",
                           "reversals",
                           "slow_flights",
                           "wheel_speeds",
                           "wheel_accelerations",
                           "with_heading",
                           "without_heading",
                           "changes",
                           "least_clearance",
                           "least_static_clearance",
                           "largest_acceleration",
                           "largest_speed",
                           "with_goal",
                           "arrived",
                           "at_goal_at_end",
                           "last_arrival",
                           "not_arrived",
                           "deviation",
                           "estimated",
                           "tolerance",
                           "interpolation_error",
                           "uneven_steps",
                           "version"}));
  EXPECT_EQ(json["static_contacts"], (Json{{"count", 0}, {"worst", 0.0}, {"first", nullptr}}));
  for (const char* key : {"scene", "last_arrival", "uneven_steps", "least_static_clearance"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_EQ(json["tolerance"], 1e-9);
  const Json alone = verdict(kHeader + "0,3,0,0,3,0\n1,3,3,0,3,0\n");
  EXPECT_TRUE(alone["least_clearance"].is_null());
  EXPECT_EQ(alone["speeds"]["count"], 2);
  EXPECT_EQ(alone["speeds"]["first"], (Json{{"time", 0.0}, {"robot", 3}, {"amount", 1.0}}));
}

// What other simulators write.
TEST(Check, takes_recordings_in_any_dress) {
  Json expected = verdict(kGoodRun);
  const std::string others[] = {
      // columns in any order, more of them, rows of one time in any order, CR LF
      "id,vy,vx,robot,y,x,time\r\n"
      "a,0,0,7,0,3,0\r\na,0,0,0,0,0,0\r\n"
      "b,0,0.5,0,0,0.125,0.5\r\nc,0,0,7,0,3,0.5\r\n"
      ",0,0,7,0,3,1.5\r\n,0,1.5,0,0,1.125,1.5\r\n",
      // byte order mark, quotes, blanks, other forms of numbers, no last end of line
      "\xEF\xBB\xBF\"time\", \"robot\",x ,\ty,vx,vy\n"
      "0.0,0,-0,0,0,1e-999\n0e0,7.0,+3,0,0,0\n"
      "\n5e-1,0,.125,0,\"0.5\",0\n0.5,7,3.,0,0,0\n"
      "15e-1,0,1.125,0,1.5,0\n1.5,7,0.3e+1,0,0,0"};
  for (const std::string& text : others) EXPECT_EQ(verdict(text), expected) << text;
  // large numbers, the larger one first; times before 0
  const Json far = verdict(kHeader +
                           "-1,9223372036854775807,0,0,0,0\n"
                           "0,9223372036854775807,0,0,0,0\n0,5000000000,0.25,0,0,0\n"
                           "1,5000000000,0.25,0,0,0\n1,9223372036854775807,0,0,0,0\n");
  EXPECT_EQ(far["overlaps"]["first"]["robot"], 5000000000);
  EXPECT_EQ(far["overlaps"]["first"]["other"], 9223372036854775807);
}

TEST(Check, reads_the_standard_input) {
  const std::string path = recording(kGoodRun);
  const int before = dup(STDIN_FILENO), file = open(path.c_str(), O_RDONLY);
  dup2(file, STDIN_FILENO);
  Strings arguments{"check", "-", "--json"};
  arguments.insert(arguments.end(), kLimits.begin(), kLimits.end());
  const ProcessResult result = run_avo(arguments);
  dup2(before, STDIN_FILENO);
  close(before);
  close(file);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["rows"], 6);
}

TEST(Check, the_tolerance_can_be_set) {
  const std::string touching =
      kHeader + "0,0,0,0,0,0\n0,1,0.9999,0,0,0\n1,0,0,0,0,0\n1,1,0.9999,0,0,0\n";
  EXPECT_EQ(check(touching).exit_code, 1);
  Strings wide = kLimits;
  wide.insert(wide.end(), {"--tolerance", "1e-3"});
  EXPECT_EQ(check(touching, wide).exit_code, 0);
  Strings unlimited{"--radius", "0.4", "--max-acceleration", "inf", "--max-speed", "inf"};
  EXPECT_EQ(check(kHeader + "0,0,0,0,900,0\n1,0,0,0,0,0\n", unlimited).exit_code, 0);
}

TEST(Check, braking_may_be_stronger_than_acceleration) {
  const std::string stops = kHeader + "0,0,0,0,1.5,0\n0.5,0,0.375,0,0,0\n";
  const std::string starts = kHeader + "0,0,0,0,0,0\n0.5,0,0.375,0,1.5,0\n";
  Strings strong = kLimits;
  strong.insert(strong.end(), {"--max-braking", "3"});
  EXPECT_EQ(check(stops).exit_code, 1);
  EXPECT_EQ(check(stops, strong).exit_code, 0);
  EXPECT_EQ(check(starts, strong).exit_code, 1);
}

// Two robots with goals 1 m ahead: 0 arrives, 1 does not.
constexpr const char* kTwoRobots =
    "version: 1\nname: two\ntime_step: 0.5\nrobots:\n"
    "  - {position: [0, 0], goal: [1, 0]}\n  - {position: [0, 5], goal: [1, 5]}\n";
const std::string kOneArrives = kHeader +
                                "0,0,0,0,0,0\n0,1,0,5,0,0\n0.5,0,0.125,0,0.5,0\n0.5,1,0,5,0,0\n"
                                "1,0,0.5,0,1,0\n1,1,0,5,0,0\n";

TEST(Check, arrival_counts_where_it_is_required) {
  const Strings scene{"--scene", recording(kTwoRobots, "two.yaml")};
  const ProcessResult result = check(kOneArrives, scene);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("  arrived            1 of 2; 1 at the end; not robot 1\n"),
            std::string::npos)
      << result.out;
  const ProcessResult neither =
      check(kOneArrives, {scene[0], scene[1], "--set", "robots.0.goal=[9, 9]"});
  EXPECT_NE(neither.out.find("  arrived            0 of 2; 0 at the end; not robots 0, 1\n"),
            std::string::npos)
      << neither.out;
  const Strings required{scene[0], scene[1], "--require-arrival"};
  const ProcessResult failed = check(kOneArrives, required);
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_NE(failed.out.find(": safe, but not all arrived\n"), std::string::npos) << failed.out;
  const Json json = verdict(kOneArrives, required);
  EXPECT_EQ(json["safe"], true);
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["not_arrived"], Json::array({1}));
  EXPECT_EQ(check(kOneArrives,
                  {scene[0], scene[1], "--require-arrival", "--set", "robots.1.goal=[0, 5.4]"})
                .exit_code,
            0);
}

TEST(Check, limits_come_from_the_scene) {
  const Strings scene{"--scene", recording(kTwoRobots, "two.yaml")};
  const auto with = [&](const std::string& change) {
    return verdict(kOneArrives, {scene[0], scene[1], "--set", change});
  };
  EXPECT_EQ(with("robots.0.max_acceleration=0.9")["accelerations"]["count"], 2);
  EXPECT_EQ(with("robots.0.max_speed=0.9")["speeds"]["count"], 1);
  EXPECT_EQ(with("robots.0.radius=5")["overlaps"]["count"], 1);
  EXPECT_EQ(with("arrival_distance=2")["arrived"], 2);
}

TEST(Check, moving_obstacles_come_from_the_scene) {
  const Strings scene{"--scene", recording(kTwoRobots, "two.yaml")};
  const auto with = [&](const std::string& obstacle) {
    return check(kOneArrives, {scene[0], scene[1], "--set", "moving_obstacles=[" + obstacle + "]"});
  };
  const ProcessResult moving = with("{position: [4, 0], velocity: [-3, 0], radius: 0.5}");
  EXPECT_EQ(moving.exit_code, 1);
  EXPECT_NE(moving.out.find("  moving obstacles   1 hit by a robot in motion, the first at "
                            "0.872983 s: robot 0 and moving obstacle 0, by 0.5 m; 0 hit a robot "
                            "at rest\n"),
            std::string::npos)
      << moving.out;
  const ProcessResult resting = with("{position: [4, 5], velocity: [-3.5, 0], radius: 0.5}");
  EXPECT_EQ(resting.exit_code, 1);
  EXPECT_NE(resting.out.find("0 hit by a robot in motion; 1 hit a robot at rest"),
            std::string::npos);
}

TEST(Check, warns_of_steps_that_are_not_those_of_the_scene) {
  const Strings scene{"--scene", recording(kTwoRobots, "two.yaml"), "--set", "time_step=0.75"};
  const ProcessResult result = check(kOneArrives, scene);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "warning: 2 of 2 steps are not the scene's 0.75 s long; they are judged on the cubic "
            "between their rows, which may not be the path\n");
  EXPECT_EQ(check(kOneArrives, {scene[0], scene[1]}).err, "");
}

}  // namespace
}  // namespace avo_test
