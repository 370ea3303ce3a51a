// SPDX-License-Identifier: Apache-2.0
// What is said of bad scenes of space, and of rows of space that are not what a verb needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "bad_scenes.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using testing::HasSubstr;

// Two robots, the second of a group; more lines follow from line 5 on.
const std::string kSpaceHead =
    "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [9, 0, 0]}\n";
const std::string kKinds =
    "floor, ceiling, box, polyline, polygon, disc, wkt, wkt_file, geojson, map, ros_map";
const std::string kKeys =
    "floor, ceiling, box, polyline, polygon, disc, wkt, wkt_file, geojson, map, ros_map, height, "
    "cell, origin";

BadScene bad(const char* name, const std::string& more, const std::string& message) {
  return {name, kSpaceHead + more + "\n", message};
}

BadScene obstacle(const char* name, const std::string& text, const std::string& message) {
  return bad(name, "obstacles:\n  - " + text, message);
}

const std::vector<BadScene> kScenes{
    obstacle(
        "typo", "{flor: 0}",
        "6:6: obstacles.0: found the unknown key \"flor\", did you mean \"floor\"? Allowed are " +
            kKeys),
    obstacle("no_kind", "{}", "6:5: obstacles.0: found 0 kinds, must be one of " + kKinds),
    obstacle("height_number", "{polyline: [[3, 0], [3, 9]], height: 3}",
             "6:42: obstacles.0.height: found 3, must be [low, high] in m"),
    obstacle("height_inverted", "{polyline: [[3, 0], [3, 9]], height: [3, 1]}",
             "6:42: obstacles.0.height: found [3, 1], must be [low, high], low must not exceed "
             "high"),
    obstacle("layers", "{polyline: [[3, 0], [3, 9]], layers: [2]}",
             "6:42: obstacles.0.layers: found a list, must be left out in a scene of space"),
    obstacle("solid", "{polygon: [[-3, -3], [3, -3], [0, 9]], solid: true}",
             "6:51: obstacles.0.solid: found \"true\", must be left out in a scene of space"),
    obstacle("as", "{wkt: \"LINESTRING (3 0, 3 9)\", as: solid}",
             "6:40: obstacles.0.as: found \"solid\", must be left out in a scene of space"),
    bad("group_box",
        "groups:\n  - {count: 2, box: {min: [9, 0, 0], max: [1, 9, 9]}, goal: permuted}",
        "6:21: groups.0.box: found min [9, 0, 0] and max [1, 9, 9], min must not exceed max"),
    bad("mover_max_speed", "moving_obstacles:\n  - {position: [0, 5, 0], max_speed: 1}",
        "6:38: moving_obstacles.0.max_speed: found 1, must be left out without max_deviation: it "
        "keeps its acceleration"),
    bad("mover_trajectory",
        "moving_obstacles:\n  - {position: [0, 5, 0]}\n"
        "  - {trajectory: [[1, 0, 5, 0], [0, 0, 6, 0]]}",
        "7:18: moving_obstacles.1.trajectory: found 0 s after 1 s, must be ascending times"),
    bad("quadrotor",
        "  - {position: [0, 5, 0], goal: [9, 5, 0],\n"
        "     quadrotor: {mass: 1, max_thrust: 9, max_tilt: 0.5, attitude_time: 0.1}}",
        "6:39: robots.1.quadrotor.max_thrust: found 9, must be > 9.80665 N, the weight of its "
        "mass"),
    bad("group",
        "groups:\n  - {count: 2, sphere: {radius: 9}, goal: antipodal,\n"
        "     quadrotor: {mass: 1, max_thrust: 9, max_tilt: 0.5, attitude_time: 0.1}}",
        "7:39: robots.1.quadrotor.max_thrust: found 9, must be > 9.80665 N, the weight of its "
        "mass"),
};

class BadSpace : public testing::TestWithParam<BadScene> {};

TEST_P(BadSpace, is_refused_in_one_line) {
  expect_refused(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Scenes, BadSpace, testing::ValuesIn(kScenes),
                         [](const auto& test) { return std::string(test.param.name); });

// A robot at rest, and what is said of other rows.
std::string judged(const std::string& rows) {
  write_file(path_of("two.yaml"), kSpaceHead + "  - {position: [0, 5, 0], goal: [9, 5, 0]}\n");
  write_file(path_of("two.csv"), "time,robot,x,y,z,vx,vy,vz\n" + rows);
  return run_avo({"check", path_of("two.csv"), "--scene", path_of("two.yaml")}).err;
}

const std::string kStart = "0,0,0,0,0,0,0,0\n0,1,0,5,0,0,0,0\n";

TEST(RowsOfSpace, are_refused_by_their_own_lines) {
  EXPECT_THAT(judged(kStart + "0.1,0,0,0,0,0,0,0\n0.1,0,0,0,0,0,0,0\n0.1,1,0,5,0,0,0,0\n0.2,0,0,0,"
                              "0,0,0,0\n"),
              HasSubstr("two.csv:5: robot: found 0 again at 0.1 s, must be once a time (line 4)"));
  EXPECT_THAT(judged(kStart + "0.1,7,0,0,0,0,0,0\n0.1,1,0,5,0,0,0,0\n0.2,0,0,0,0,0,0,0\n"),
              HasSubstr("two.csv:4: robot: found 7, must be 0 to 1, the robots of the scene"));
  EXPECT_THAT(judged(kStart + "0.2,0,0,0,0,0,0,0\n0.1,0,0,0,0,0,0,0\n0.2,1,0,5,0,0,0,0\n"),
              HasSubstr("two.csv:5: time: found 0.1 s, must be >= 0.2 s, the time before"));
}

TEST(RowsOfSpace, of_one_time_may_have_any_order) {
  EXPECT_EQ(judged("0,1,0,5,0,0,0,0\n0,0,0,0,0,0,0,0\n0.1,0,0,0,0,0,0,0\n0.1,1,0,5,0,0,0,0\n"), "");
}

TEST(RowsOfSpace, are_not_judged_as_rows_of_the_plane) {
  const std::string csv = path_of("two.csv"), plane = path_of("plane.yaml");
  judged(kStart + "0.1,0,0,0,0,0,0,0\n0.1,1,0,5,0,0,0,0\n");
  const ProcessResult alone = run_avo({"check", csv, "--radius", "0.4"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_EQ(alone.out, "");
  EXPECT_THAT(alone.err, HasSubstr("--scene: found none with space: 3, must be given: "));
  write_file(plane, "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  EXPECT_EQ(run_avo({"check", csv, "--scene", plane}).exit_code, 2);
  write_file(csv, "robot,time,x,y,z,vx,vy,vz\n0,0,0,0,0,0,0,0\n0,1,0,0,0,0,0,0\n");
  EXPECT_THAT(run_avo({"check", csv, "--radius", "0.4"}).err,
              HasSubstr("two.csv:1: found the columns z and vz of space, must be a recording of"));
}

}  // namespace
}  // namespace avo_test
