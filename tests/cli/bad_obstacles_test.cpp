// SPDX-License-Identifier: Apache-2.0
// What is said of bad obstacles, and of the files that a scene names.
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "run_avo.h"
#include "support/bad_scenes.h"

namespace avo_test {
namespace {

const std::string kHead = "version: 1\nrobots:\n  - {position: [50, 50], goal: [51, 50]}\n";

/// The message in full but for the folder: "DIR/" in `message` is that of the test.
struct Bad {
  const char* name;
  std::string obstacles;  ///< from line 4 of the scene
  std::string message;
  std::map<std::string, std::string> files = {};
  int exit_code = 3;
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

Bad entry(const char* name, const std::string& text, const std::string& message) {
  return {name, "obstacles:\n  - " + text + "\n", "DIR/s.yaml:5:" + message};
}

Bad wkt(const char* name, const std::string& text, const std::string& message) {
  return {name, "obstacles:\n  - {wkt_file: p.wkt}\n", "DIR/p.wkt:" + message, {{"p.wkt", text}}};
}

Bad map(const char* name, const std::string& text, const std::string& message) {
  return {name, "obstacles:\n  - {map: a.map}\n", "DIR/a.map:" + message, {{"a.map", text}}};
}

Bad ros(const char* name, const std::string& yaml, const std::string& image,
        const std::string& message) {
  return {name,
          "obstacles:\n  - {ros_map: m.yaml}\n",
          "DIR/" + message,
          {{"m.yaml", yaml}, {"m.pgm", image}}};
}

const std::string kRos =
    "image: m.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.2\n";

Bad pgm(const char* name, const std::string& image, const std::string& message) {
  return ros(name, kRos, image, "m.pgm:" + message);
}

const std::string kMap = "type octile\nheight 2\nwidth 3\nmap\n..@\n...\n";
const std::string kRow = "0\ta.map\t3\t2\t0\t0\t1\t1\t1.41\n";

Bad scen(const char* name, const std::string& text, const std::string& message,
         const std::string& from = "{scen: a.scen, number: 1}") {
  return {name,
          "obstacles: [{map: a.map}]\nrobots_from: " + from + "\n",
          "DIR/" + message,
          {{"a.map", kMap}, {"a.scen", text}}};
}

const std::vector<Bad> kEntries{
    {"not_a_list", "obstacles: {polyline: [[0, 0], [1, 0]]}\n",
     "DIR/s.yaml:4:12: obstacles: found a map, must be a list"},
    {"singular", "obstacle: []\n",
     "DIR/s.yaml:4:1: found the unknown key \"obstacle\", did you mean \"obstacles\"? Allowed are "
     "version, name, time_step, duration, control_time, response_time, comfort_acceleration, "
     "comfort_jerk, margin, never_swerves, time_horizon, sensing_radius, max_neighbors, method, "
     "external_method, certificate, motion, arrival_distance, seed, robots, groups, robots_from, "
     "moving_obstacles, obstacles, navigation, right_of_way, sensing, sensing_error, execution, "
     "execution_error, clock, allow_broken_assumptions"},
    {"navigation_word", "navigation: maybe\n",
     "DIR/s.yaml:4:13: navigation: found \"maybe\", must be true or false"},
    entry("no_map", "7",
          "5: obstacles.0: found 7, must be a map with keys polyline, layers, polygon, solid, "
          "disc, wkt, as, wkt_file, geojson, map, cell, origin, ros_map"),
    entry("misspelled", "{polylin: [[0, 0], [1, 0]]}",
          "6: obstacles.0: found the unknown key \"polylin\", did you mean \"polyline\"? Allowed "
          "are polyline, layers, polygon, solid, disc, wkt, as, wkt_file, geojson, map, cell, "
          "origin, ros_map"),
    entry("no_kind", "{solid: true}",
          "5: obstacles.0: found 0 kinds, must be one of polyline, polygon, disc, wkt, wkt_file, "
          "geojson, map, ros_map"),
    entry("two_kinds", "{polyline: [[0, 0], [1, 0]], disc: {center: [0, 0], radius: 1}}",
          "5: obstacles.0: found 2 kinds, must be one of polyline, polygon, disc, wkt, wkt_file, "
          "geojson, map, ros_map"),
    entry("key_of_another_kind", "{polyline: [[0, 0], [1, 0]], solid: true}",
          "34: obstacles.0: found the unknown key \"solid\", allowed are polyline, layers"),
    entry("one_point", "{polyline: [[0, 0]]}",
          "16: obstacles.0.polyline: found 1 points, must be at least 2"),
    entry("two_corners", "{polygon: [[0, 0], [1, 0]]}",
          "15: obstacles.0.polygon: found 2 points, must be at least 3"),
    entry("point_of_three", "{polyline: [[0, 0], [1, 0, 0]]}",
          "25: obstacles.0.polyline.1: found a list of 3, must be [x, y] in m"),
    entry("not_finite", "{polyline: [[0, 0], [.inf, 0]]}",
          "26: obstacles.0.polyline.1.0: found .inf, must be a finite number"),
    entry("solid_word", "{polygon: [[0, 0], [1, 0], [1, 1]], solid: yes}",
          "48: obstacles.0.solid: found \"yes\", must be true or false"),
    entry("disc_without_radius", "{disc: {center: [0, 0]}}",
          "12: obstacles.0.disc: found no \"radius\", must be given: of the disc"),
    entry("disc_negative", "{disc: {center: [0, 0], radius: -1}}",
          "37: obstacles.0.disc.radius: found -1, must be >= 0 m"),
    entry("disc_misspelled", "{disc: {centre: [0, 0], radius: 1}}",
          "13: obstacles.0.disc: found the unknown key \"centre\", did you mean \"center\"? "
          "Allowed are center, radius"),
    entry("as_word", "{wkt: \"POLYGON ((0 0, 1 0, 1 1, 0 0))\", as: bound}",
          "49: obstacles.0.as: found \"bound\", did you mean \"bounds\"? Must be one of solid, "
          "bounds"),
    entry("bounds_of_lines", "{wkt: \"LINESTRING (0 0, 1 0)\", as: bounds}",
          "40: obstacles.0.as: found bounds without a polygon, must have one, no robot may start "
          "outside of it"),
    entry("wkt_list", "{wkt: [0, 0]}",
          "11: obstacles.0.wkt: found a list, must be a text such as LINESTRING (0 0, 1 0)"),
    entry("wkt_here", "{wkt: \"LINESTRING (0 0, 1)\"}",
          "11: obstacles.0.wkt: 1:19: found \")\", must be a number from -1e+12 to 1e+12 (m)"),
    entry("cell_zero", "{map: a.map, cell: 0}", "24: obstacles.0.cell: found 0, must be > 0 m"),
    {"file_missing",
     "obstacles:\n  - {map: a.map}\n",
     "DIR/s.yaml:5:11: obstacles.0.map: DIR/a.map: No such file or directory",
     {},
     4},
    {"file_a_directory",
     "obstacles:\n  - {wkt_file: .}\n",
     "DIR/s.yaml:5:16: obstacles.0.wkt_file: DIR/.: found a directory, must be a regular file",
     {},
     4},
    {"file_a_device",
     "obstacles:\n  - {ros_map: /dev/zero}\n",
     "DIR/s.yaml:5:15: obstacles.0.ros_map: /dev/zero: found a device, must be a regular file",
     {},
     4},
};

const std::vector<Bad> kWkts{
    wkt("empty", "",
        "1:1: found the end, must be one of LINESTRING, LINEARRING, POLYGON, MULTILINESTRING, "
        "MULTIPOLYGON, "
        "GEOMETRYCOLLECTION"),
    wkt("point", "POINT (0 0)",
        "1:1: found \"POINT\", a point has no size; a pillar is {disc: {center: [x, y], radius: "
        "r}}"),
    wkt("polygn", "LINESTRING (0 0, 1 0)\n POLYGN ((0 0, 1 0, 1 1, 0 0))",
        "2:2: found \"POLYGN\", did you mean \"POLYGON\"? Must be one of LINESTRING, LINEARRING, "
        "POLYGON, MULTILINESTRING, MULTIPOLYGON, GEOMETRYCOLLECTION"),
    wkt("srid", "SRID=4326;POLYGON ((0 0, 1 0, 1 1, 0 0))",
        "1:1: found \"SRID=4326;POLYGON\", must be one of LINESTRING, LINEARRING, POLYGON, "
        "MULTILINESTRING, "
        "MULTIPOLYGON, GEOMETRYCOLLECTION"),
    wkt("z", "LINESTRING Z (0 0 0, 1 0 0)", "1:12: found \"Z\", coordinates must be x y alone"),
    wkt("z_without_a_word", "LINESTRING (0 0 5, 1 0 5)",
        "1:17: found \"5\", coordinates must be x y alone"),
    wkt("half_empty", "POLYGON (EMPTY", "1:15: found the end, must be \",\" or \")\""),
    wkt("empty_coordinate", "LINESTRING (EMPTY, 1 0)",
        "1:13: found \"EMPTY\", must be a number from -1e+12 to 1e+12 (m)"),
    wkt("z_of_points", "POINT Z (0 0 0)", "1:7: found \"Z\", coordinates must be x y alone"),
    wkt("nan", "LINESTRING (0 nan, 1 0)",
        "1:15: found \"nan\", must be a number from -1e+12 to 1e+12 (m)"),
    wkt("beyond", "LINESTRING (0 1e13, 1 0)",
        "1:15: found \"1e13\", must be a number from -1e+12 to 1e+12 (m)"),
    wkt("overflow", "LINESTRING (0 1e999, 1 0)",
        "1:15: found \"1e999\", must be a number from -1e+12 to 1e+12 (m)"),
    wkt("ring_open", "POLYGON ((0 0, 1 0, 1 1, 0 1))",
        "1:10: found a ring from [0, 0] to [0, 1], must end where it begins"),
    wkt("ring_flat", "POLYGON ((0 0, 1 0, 0 0))",
        "1:10: found a ring of 2 points, must be at least 3"),
    wkt("line_of_one", "LINESTRING (0 0)",
        "1:12: found a line of one point, must have at least two"),
    wkt("truncated", "POLYGON ((0 0, 1 0", "1:19: found the end, must be \",\" or \")\""),
    wkt("garbage", std::string("\xFF\0\x1B[2J", 6),
        "1:1: found \"\\xff\\x00\\x1b[2J\", must be one of LINESTRING, LINEARRING, POLYGON, "
        "MULTILINESTRING, "
        "MULTIPOLYGON, GEOMETRYCOLLECTION"),
};

const std::vector<Bad> kMaps{
    map("empty", "", "1:1: found the end, must be \"type\""),
    map("garbage",
        "\x7F"
        "ELF",
        "1:1: found \"\\x7fELF\", must be \"type\""),
    map("huge", "type octile\nheight 1000000000\nwidth 1000000000\nmap\n...\n",
        "5:1: found a row of 3 cells, must be 1000000000, the width"),
    map("huger", "type octile\nheight 99999999999999999999\nwidth 3\nmap\n...\n",
        "2:8: found \"99999999999999999999\", the height must be 1 to 1000000000"),
    map("negative", "type octile\nheight 2\nwidth -3\nmap\n...\n",
        "3:7: found \"-3\", the width must be 1 to 1000000000"),
    map("no_number", "type octile\nheight two\n",
        "2:8: found \"two\", the height must be a whole number"),
    map("truncated_header", "type octile\nheight 2\n", "3:1: found the end, must be \"width\""),
    map("truncated", "type octile\nheight 3\nwidth 3\nmap\n...\n.@.\n",
        "7:1: found 2 rows, must be 3, the height"),
    map("row_cut", "type octile\nheight 2\nwidth 3\nmap\n...\n.@",
        "6:1: found a row of 2 cells, must be 3, the width"),
    map("too_many_rows", kMap + "...\n", "7:1: found \"...\", must end after 2 rows, the height"),
    map("unknown_cell", "type octile\nheight 1\nwidth 3\nmap\n.#.\n",
        "5:2: found \"#\", must be one of . G S (free), @ O T W (blocked)"),
    {"beyond_all",
     "obstacles:\n  - {map: a.map, cell: 1e12}\n",
     "DIR/s.yaml:5:11: obstacles.0.map: found a corner at [3e+12, 0], must be within 1e+12 m of "
     "[0, "
     "0]",
     {{"a.map", kMap}}},
    {"nothing_free",
     "obstacles:\n  - {map: a.map}\n",
     "DIR/s.yaml:5:11: obstacles.0.map: found no free cell in DIR/a.map, must have at least one",
     {{"a.map", "type octile\nheight 1\nwidth 3\nmap\n@@@\n"}}},
};

const std::vector<Bad> kRosMaps{
    ros("empty", "", "",
        "m.yaml:1:1: found nothing, must be a map with keys image, resolution, origin, "
        "occupied_thresh, free_thresh, negate, mode"),
    ros("twice", kRos + "negate: 1\n", "",
        "m.yaml:7:1: found the key \"negate\" twice, allowed is once, the first is in line 4"),
    ros("mode", kRos + "mode: raws\n", "",
        "m.yaml:7:7: mode: found \"raws\", did you mean \"raw\"? Must be one of trinary, scale, "
        "raw"),
    ros("negate",
        "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 2\n"
        "occupied_thresh: 0.6\nfree_thresh: 0.2\n",
        "", "m.yaml:4:9: negate: found 2, must be <= 1"),
    ros("no_negate",
        "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n",
        "", "m.yaml:1:1: found no \"negate\", must be given: 1 or true: white is occupied"),
    ros("thresholds",
        "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.2\nfree_thresh: 0.6\n",
        "", "m.yaml:6:14: free_thresh: found 0.6, must be <= occupied_thresh = 0.2"),
    ros("origin",
        "image: m.pgm\nresolution: 1\norigin: [0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.6\nfree_thresh: 0.2\n",
        "", "m.yaml:3:9: origin: found a list, must be [x, y, yaw] in m and rad"),
    {"image_missing",
     "obstacles:\n  - {ros_map: m.yaml}\n",
     "DIR/m.yaml:1:8: image: DIR/m.pgm: No such file or directory",
     {{"m.yaml", kRos}},
     4},
    pgm("png", "\x89PNG\r\n", "1:1: found a damaged PNG (it ends too early), must be whole"),
    pgm("no_image", "",
        "1:1: found the end, must be a PNG, a BMP, or a portable graymap, P2 or P5"),
    pgm("huge", "P5\n1000000000 1000000000\n255\nabc",
        "4:4: found 3 values, must be 1000000000 x 1000000000"),
    pgm("huge_plain", "P2\n1000000000 1000000000\n255\n1 2 3",
        "4:6: found 3 values, must be 1000000000 x 1000000000"),
    pgm("truncated", "P5 2 2 255\nabc", "2:4: found 3 values, must be 2 x 2"),
    pgm("header_only", "P5 2 2 255", "1:11: found 0 values, must be 2 x 2"),
    pgm("too_long", "P5 2 2 255\nabcde", "2:6: found 5 values, must be 2 x 2"),
    pgm("too_many", "P2 2 2 255\n0 0 0 0 0", "2:9: found more values, must be 2 x 2"),
    pgm("too_white", "P2 1 1 100\n101", "2:1: found the value 101, must be <= 100"),
    pgm("not_a_number", "P2 1 1 255\nx", "2:1: found \"x\", the value must be a whole number"),
    pgm("zero_wide", "P5 0 1 255\n", "1:4: found \"0\", the width must be 1 to 1000000000"),
};

const std::vector<Bad> kScens{
    scen("no_version", kRow, "a.scen:1:1: found \"0\", must be \"version\""),
    scen("version", "version 2\n" + kRow, "a.scen:1:9: found \"2\", must be 1"),
    scen("truncated", "version 1\n0\ta.map\t3\t2\t0\t0",
         "a.scen:2:16: found the end, the goal's x must be a whole number"),
    scen("outside", "version 1\n0\ta.map\t3\t2\t3\t0\t1\t1\t1.4\n",
         "a.scen:2:13: found \"3\", the start's x must be 0 to 2"),
    scen("blocked", "version 1\n0\ta.map\t3\t2\t2\t0\t1\t1\t1.4\n",
         "a.scen:2:1: found the start 2 0, a blocked cell, must be free"),
    scen("of_another_size", "version 1\n0\ta.map\t3\t9\t2\t0\t1\t1\t1.4\n",
         "a.scen:2:1: found a map of 3 x 9 cells, must be 3 x 2"),
    scen("length", "version 1\n0\ta.map\t3\t2\t0\t0\t1\t1\tnan\n",
         "a.scen:2:21: found \"nan\", the optimal length must be a number"),
    scen("too_few_rows", "version 1\n" + kRow,
         "s.yaml:5:37: robots_from.number: found 2, must be <= 1, the rows of DIR/a.scen",
         "{scen: a.scen, number: 2}"),
    scen("starts_overlap", "version 1\n" + kRow + "0\ta.map\t3\t2\t1\t0\t1\t1\t1\n",
         "a.scen:3:1: found the start of robots.2, 1 m from that of robots.1, must be at least 1.2 "
         "m",
         "{scen: a.scen, number: 2, radius: 0.6}"),
    scen("unknown_key", "",
         "s.yaml:5:29: robots_from: found the unknown key \"numbr\", did you mean \"number\"? "
         "Allowed are scen, number, " +
             kGroupRobotKeys,
         "{scen: a.scen, numbr: 2}"),
    {"no_map",
     "robots_from: {scen: a.scen, number: 1}\n",
     "DIR/s.yaml:4:21: robots_from.scen: found no map in obstacles, must have the scenario's",
     {{"a.scen", "version 1\n" + kRow}}},
};

void expect_refusal(const Bad& bad) {
  for (const auto& [name, text] : bad.files) write_file(path_of(name), text);
  const std::string path = path_of("s.yaml");
  write_file(path, kHead + bad.obstacles);
  const ProcessResult result = run_avo({"validate", path});
  std::string expected = bad.message;
  for (std::size_t at = 0; (at = expected.find("DIR/", at)) != std::string::npos;)
    expected.replace(at, 4, folder() + "/");
  EXPECT_EQ(result.exit_code, bad.exit_code);
  EXPECT_EQ(result.err, expected + "\n");
  EXPECT_EQ(result.out, "");
}

class BadObstaclesTest : public testing::TestWithParam<Bad> {};

TEST_P(BadObstaclesTest, are_refused_in_one_line) {
  expect_refusal(GetParam());
}

const auto kName = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(Entries, BadObstaclesTest, testing::ValuesIn(kEntries), kName);
INSTANTIATE_TEST_SUITE_P(Wkt, BadObstaclesTest, testing::ValuesIn(kWkts), kName);
INSTANTIATE_TEST_SUITE_P(Maps, BadObstaclesTest, testing::ValuesIn(kMaps), kName);
INSTANTIATE_TEST_SUITE_P(RosMaps, BadObstaclesTest, testing::ValuesIn(kRosMaps), kName);
INSTANTIATE_TEST_SUITE_P(Scens, BadObstaclesTest, testing::ValuesIn(kScens), kName);

// Two megabytes: as a parameter, each start of this program would copy them ten times.
TEST(BadObstacles, collections_nest_at_most_16_deep) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "GEOMETRYCOLLECTION(";
  expect_refusal(
      wkt("nested_too_deep", text, "1:323: found \"(\", collections must nest at most 16 deep"));
}

/// A map of one cell free, one blocked, and so on: four corners for each free one.
std::string chessboard(int side) {
  std::string text =
      "type octile\nheight " + std::to_string(side) + "\nwidth " + std::to_string(side) + "\nmap\n";
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) text += (x + y) % 2 == 0 ? '.' : '@';
    text += '\n';
  }
  return text;
}

TEST(BadObstacles, the_number_of_walls_is_limited) {
  const std::string scene = path_of("s.yaml");
  write_file(path_of("a.map"), chessboard(1001));
  write_file(scene, kHead + "obstacles: [{map: a.map}]\n");
  EXPECT_EQ(run_avo({"validate", scene}).err,
            scene + ":4:19: obstacles.0.map: found more than 2000000 walls in " + path_of("a.map") +
                ", must be fewer\n");
  write_file(path_of("a.map"), chessboard(801));
  write_file(scene, kHead + "obstacles: [{map: a.map}, {map: a.map}]\n");
  EXPECT_EQ(run_avo({"validate", scene}).err,
            scene + ":4:27: obstacles.1: found 2566408 walls so far, must be at most 2000000\n");
}

TEST(BadObstacles, a_large_file_is_not_read) {
  write_file(path_of("a.map"), "");
  std::filesystem::resize_file(path_of("a.map"), std::uintmax_t{1} << 40U);
  const std::string scene = path_of("s.yaml");
  write_file(scene, kHead + "obstacles: [{map: a.map}]\n");
  const ProcessResult result = run_avo({"validate", scene});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path_of("a.map") + ":1:1: found more than 16 MiB, must be smaller\n");
}

}  // namespace
}  // namespace avo_test
