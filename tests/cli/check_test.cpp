// SPDX-License-Identifier: Apache-2.0
// avo check: what is safe and what is not, of all that avo run records.
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "verdicts.h"

namespace avo_test {
namespace {

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
  // the disc is ahead of the position, and without a heading its place is unknown
  const std::string body = "groups.0.car.body={offset: 0.5, radius: 0.9}";
  const ProcessResult unknown =
      check(without_headings(cars.csv), {"--scene", "cars-100", "--set", body});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_EQ(unknown.err, path_of("in.csv") +
                             ":2: robot 0: heading: found none, must be there: its disc, or what "
                             "its velocity is of, is ahead of its position\n");
}

// Two trucks pass each other in a lane that is narrower than the disc that covers one of them.
TEST(Check, judges_each_disc_of_a_footprint) {
  const auto scene = [](const std::string& footprint) {
    const std::string path = path_of("trucks.yaml");
    const std::string own = ", car: {wheelbase: 3.5, max_curvature: 0.2}, footprint: " + footprint;
    write_file(path,
               "version: 1\nname: trucks\nduration: 30\nrobots:\n"
               "  - {position: [-15, -1.8], goal: [15, -1.8]" +
                   own +
                   "}\n"
                   "  - {position: [15, 1.8], goal: [-15, 1.8], heading: 3.141592653589793" +
                   own +
                   "}\nobstacles:\n  - {polyline: [[-25, -3.4], [25, -3.4]]}\n"
                   "  - {polyline: [[-25, 3.4], [25, 3.4]]}\n");
    return path;
  };
  const Recorded trucks = record({scene("{length: 6, width: 2, offset: 1.75}")});
  EXPECT_EQ(trucks.summary["arrived"], 2);
  EXPECT_EQ(trucks.summary["collision_pairs"], 0);
  const ProcessResult result =
      run_avo({"check", trucks.csv, "--scene", path_of("trucks.yaml"), "--require-arrival"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const Json wider = Json::parse(run_avo({"check", trucks.csv, "--json", "--scene",
                                          scene("{length: 6, width: 4, offset: 1.75}")})
                                     .out);
  EXPECT_EQ(wider["overlaps"]["count"], 1) << "as wide as the lane: " << wider;
  EXPECT_EQ(wider["static_contacts"]["count"], 2);
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
const std::string kMixed =
    "version: 1\nname: mixed\nduration: 1\nrobots:\n"
    "  - {position: [0, 0], goal: [9, 0], radius: 0.5, max_speed: 2, max_acceleration: 1,\n"
    "     model: car, heading: 0.5, car: {wheelbase: 1, max_curvature: 0.8}}\n"
    "  - {position: [0, 5], goal: [9, 5], radius: 0.5, max_speed: 2, max_acceleration: 1}\n";

TEST(Check, headings_of_mixed_scenes) {
  write_file(path_of("mixed.yaml"), kMixed);
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

}  // namespace
}  // namespace avo_test
