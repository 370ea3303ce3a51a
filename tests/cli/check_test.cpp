// SPDX-License-Identifier: Apache-2.0
// avo check: verdicts by exit code, words and JSON; recordings of anyone, good and bad.
#include <cmath>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "recordings.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;

Json verdict(const std::string& text, Strings more = kLimits) {
  more.push_back("--json");
  const ProcessResult result = check(text, more);
  EXPECT_LE(result.exit_code, 1) << result.err;
  return Json::parse(result.out);
}

/// What `avo run` records, and its summary.
struct Recorded {
  std::string csv = path_of("run.csv");
  Json summary;
};

Recorded record(Strings arguments) {
  Recorded result;
  arguments.insert(arguments.begin(), "run");
  arguments.insert(arguments.end(), {"--record", result.csv, "--summary", path_of("run.json")});
  EXPECT_EQ(run_avo(arguments).exit_code, 0);
  result.summary = Json::parse(read_file(path_of("run.json")));
  return result;
}

TEST(Check, circle_10_is_safe) {
  const Recorded circle = record({"circle-10"});
  const ProcessResult words =
      run_avo({"check", circle.csv, "--scene", "circle-10", "--require-arrival"});
  EXPECT_EQ(words.exit_code, 0) << words.out << words.err;
  EXPECT_TRUE(words.out.starts_with(circle.csv + ": 10 robots, 1000 steps from 0 s to 100 s: "
                                                 "safe\n  overlaps           0 pairs of robots\n"))
      << words.out;
  const Json json =
      Json::parse(run_avo({"check", circle.csv, "--scene", "circle-10", "--json"}).out);
  EXPECT_EQ(json["scene"], "circle-10");
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["robot_steps"], 10'000);
  EXPECT_EQ(json["overlaps"], (Json{{"count", 0}, {"worst", 0.0}, {"first", nullptr}}));
  EXPECT_EQ(json["arrived"], 10);
  EXPECT_EQ(json["last_arrival"], circle.summary["last_arrival"]);
  EXPECT_NEAR(json["least_clearance"], circle.summary["min_clearance"], 1e-6);
  EXPECT_EQ(json["uneven_steps"], 0);
  Strings limits{"check", circle.csv};
  limits.insert(limits.end(), kLimits.begin(), kLimits.end());
  EXPECT_EQ(run_avo(limits).exit_code, 0) << "by the limits alone, too";
}

TEST(Check, circle_100_of_the_paper_alone_is_not) {
  const Strings scene{"circle-100", "--set", "method=avo_paper"};
  const Recorded circle = record(scene);
  const ProcessResult result =
      run_avo({"check", circle.csv, "--scene", scene[0], scene[1], scene[2], "--json"});
  EXPECT_EQ(result.exit_code, 1);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["safe"], false);
  EXPECT_GT(json["overlaps"]["count"], 0);
  EXPECT_EQ(json["overlaps"]["count"], circle.summary["collision_pairs"]);
  EXPECT_NEAR(json["overlaps"]["first"]["time"], circle.summary["first_collision_time"], 1e-9);
  EXPECT_NEAR(json["least_clearance"], circle.summary["min_clearance"], 1e-9);
  for (const char* limit : {"accelerations", "speeds", "jumps"}) EXPECT_EQ(json[limit]["count"], 0);
}

// Velocities change at once: the paths are straight lines, the accelerations beyond all limits.
TEST(Check, judges_orca_on_straight_lines) {
  const Strings scene{"circle-100", "--set", "method=orca", "--set", "duration=30"};
  const Recorded circle = record(scene);
  Strings arguments{"check", circle.csv, "--json", "--scene"};
  arguments.insert(arguments.end(), scene.begin(), scene.end());
  const Json json = Json::parse(run_avo(arguments).out);
  EXPECT_GT(json["overlaps"]["count"], 0);
  EXPECT_EQ(json["overlaps"]["count"], circle.summary["collision_pairs"]);
  EXPECT_NEAR(json["overlaps"]["first"]["time"], circle.summary["first_collision_time"], 1e-9);
  EXPECT_GT(json["accelerations"]["count"], 0);
}

TEST(Check, exponential_motion_is_known_to_an_error_and_cars_by_their_headings) {
  const Recorded motion = record({"circle-6", "--set", "motion=exponential", "--set",
                                  "control_time=0.5", "--set", "duration=8"});
  const Json exponential =
      Json::parse(run_avo({"check", motion.csv, "--scene", "circle-6", "--set",
                           "motion=exponential", "--set", "control_time=0.5", "--json"})
                      .out);
  EXPECT_NEAR(exponential["interpolation_error"], 1e-4 / 384.0 / 0.25, 1e-15);
  EXPECT_EQ(exponential["safe"], true);
  const Recorded cars = record({"cars-100", "--set", "duration=3"});
  const ProcessResult result = run_avo({"check", cars.csv, "--scene", "cars-100"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_NE(result.out.find("  with headings      3000 robot-steps, no limit of wheels or wings "
                            "broken\n"),
            std::string::npos)
      << result.out;
}

/// The recording without its last two columns, as of cars they once were.
std::string without_headings(const std::string& path) {
  std::string text;
  for (const std::string& line : lines_of(read_file(path)))
    text += line.substr(0, line.rfind(',', line.rfind(',') - 1)) + "\n";
  return text;
}

TEST(Check, recordings_of_cars_without_headings_are_judged_by_their_velocities) {
  const Recorded cars = record({"cars-100", "--set", "duration=3"});
  ASSERT_TRUE(read_file(cars.csv).starts_with("time,robot,x,y,vx,vy,heading,speed\n"));
  const ProcessResult result = check(without_headings(cars.csv), {"--scene", "cars-100"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_NE(result.out.find("  paths known to     0.000625 m\n"), std::string::npos)
      << "a_max Δt²/16, where they start: " << result.out;
  EXPECT_EQ(result.err,
            "warning: 3000 of 3000 robot-steps are of robots without headings in the recording; "
            "their velocities are judged, and not where they face\n");
  // its disc is ahead of its position: nobody knows where
  const std::string body = "groups.0.car.body={offset: 0.5, radius: 0.9}";
  const ProcessResult unknown =
      check(without_headings(cars.csv), {"--scene", "cars-100", "--set", body});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_EQ(unknown.err, path_of("in.csv") +
                             ":101: robot 0: heading: found none, must be there: its disc, or what "
                             "its velocity is of, is ahead of its position\n");
}

// 40 of them on 30 m x 30 m; bodies ahead, behind and about the axle.
TEST(Check, cars_of_all_settings_keep_their_limits) {
  const std::string settings[] = {
      "wheelbase: 1",
      "wheelbase: 1, acceleration_set: exact, reverse: true",
      "wheelbase: 1, max_curvature: 0.8, body: {offset: 0.5, radius: 0.9}",
      "wheelbase: 1, max_curvature: 0.8, body: {offset: 0.5, radius: 0.9}, acceleration_set: exact",
      "wheelbase: 1, max_curvature: 0.5, body: {offset: -0.4, radius: 0.8}, acceleration_set: "
      "exact, reverse: true",
      "wheelbase: 1, body: {offset: 0.5, radius: 0.9}"};
  for (const std::string& car : settings) {
    const std::string box = "{random: {min: [-15, -15], max: [15, 15], clearance: 0.9}}";
    write_file(path_of("cars.yaml"),
               "version: 1\nname: cars\nseed: 1\nduration: 30\ngroups:\n  - number: 40\n"
               "    radius: 0.5\n    max_speed: 2\n    max_acceleration: 1\n    model: car\n"
               "    heading: random\n    placement: " +
                   box + "\n    goals: " + box + "\n    car: {" + car + "}\n");
    const Recorded run = record({path_of("cars.yaml")});
    const ProcessResult result =
        run_avo({"check", run.csv, "--scene", path_of("cars.yaml"), "--json"});
    EXPECT_EQ(result.exit_code, 0) << car << "\n" << result.out;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["with_heading"], 12'000);
    // the summary looks at cubics, which are that near the arcs of slow cars
    EXPECT_NEAR(json["least_clearance"], run.summary["min_clearance"], 1e-4);
  }
}

// A car and a robot without heading, which leaves the fields empty.
const std::string kScene =
    "version: 1\nname: mixed\nduration: 1\nrobots:\n"
    "  - {position: [0, 0], goal: [9, 0], radius: 0.5, max_speed: 2, max_acceleration: 1,\n"
    "     model: car, heading: 0.5, car: {wheelbase: 1, max_curvature: 0.8}}\n"
    "  - {position: [0, 5], goal: [9, 5], radius: 0.5, max_speed: 2, max_acceleration: 1}\n";

TEST(Check, headings_of_mixed_scenes) {
  write_file(path_of("mixed.yaml"), kScene);
  const Recorded run = record({path_of("mixed.yaml")});
  const Strings lines = lines_of(read_file(run.csv));
  EXPECT_EQ(lines[0], "time,robot,x,y,vx,vy,heading,speed");
  EXPECT_EQ(lines[1], "0,0,0,0,0,0,0.5,0");
  EXPECT_EQ(lines[2], "0,1,0,5,0,0,,");
  const Json json =
      Json::parse(run_avo({"check", run.csv, "--scene", path_of("mixed.yaml"), "--json"}).out);
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["with_heading"], 10);
  EXPECT_EQ(json["without_heading"], 0);
  // it slides aside
  const std::string header = "time,robot,x,y,vx,vy,heading,speed\n";
  const ProcessResult slid = check(header + "0,0,0,0,0,1,0,1\n0.1,0,0,0.1,0,1,0,1\n",
                                   {"--scene", path_of("mixed.yaml"), "--json"});
  EXPECT_EQ(slid.exit_code, 1);
  const Json slide = Json::parse(slid.out);
  EXPECT_EQ(slide["headings"]["count"], 2);
  EXPECT_NEAR(slide["headings"]["worst"], std::sqrt(2.0), 1e-12);
  EXPECT_EQ(slide["jumps"]["count"], 1);
  const ProcessResult sharp = check(header + "0,0,0,0,1,0,0,1\n0.1,0,0.1,0,1,0.1,0.1,1\n",
                                    {"--scene", path_of("mixed.yaml")});
  EXPECT_EQ(sharp.exit_code, 1);
  EXPECT_NE(sharp.out.find("  turns              1 robot-steps too sharp, the first at 0 s: robot "
                           "0, by 0.02 rad\n"),
            std::string::npos)
      << sharp.out;
}

TEST(Check, says_what_it_found_in_words) {
  const ProcessResult good = check(kGood);
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

TEST(Check, json_has_all_keys_in_order) {
  const Json json = verdict(kGood);
  Strings keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Strings{"recording",
                           "scene",
                           "passed",
                           "safe",
                           "robots",
                           "rows",
                           "steps",
                           "robot_steps",
                           "gaps",
                           "from",
                           "to",
                           "overlaps",
                           "obstacle_contacts_moving",
                           "obstacle_contacts_at_rest",
                           "one_sided_contacts_moving",
                           "one_sided_contacts_at_rest",
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
  Json expected = verdict(kGood);
  const std::string others[] = {
      // columns in any order, more of them, rows of one time in any order, CR LF
      "id,vy,vx,robot,y,x,time\r\n"
      "a,0,0,7,0,3,0\r\na,0,0,0,0,0,0\r\n"
      "b,0,0.5,0,0,0.125,0.5\r\nc,0,0,7,0,3,0.5\r\n"
      ",0,0,7,0,3,1.5\r\n,0,1.5,0,0,1.125,1.5\r\n",
      // byte order mark, quotes, blanks, other ways to write numbers, no last end of line
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
  const std::string path = recording(kGood);
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
  EXPECT_EQ(resting.exit_code, 0);
  EXPECT_NE(resting.out.find("0 hit by a robot in motion; 1 hit a robot at rest"),
            std::string::npos);
}

TEST(Check, warns_of_steps_that_are_not_those_of_the_scene) {
  const Strings scene{"--scene", recording(kTwoRobots, "two.yaml"), "--set", "time_step=0.25"};
  const ProcessResult result = check(kOneArrives, scene);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "warning: 2 of 2 steps are not the scene's 0.25 s long; they are judged on the cubic "
            "between their rows, which may not be the path\n");
  EXPECT_EQ(check(kOneArrives, {scene[0], scene[1]}).err, "");
}

}  // namespace
}  // namespace avo_test
