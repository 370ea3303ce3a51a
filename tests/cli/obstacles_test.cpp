// SPDX-License-Identifier: Apache-2.0
// Obstacles that do not move, in every form that a scene may give them.
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using avo::Fill;
using avo::Scenario;
using avo::StaticObstacle;
using avo::Vec2;
using Points = std::vector<Vec2>;

const std::string kHead =
    "version: 1\nrobots: [{position: [100, 100], goal: [101, 100]}]\nobstacles:\n";

/// Returns the scenario of a scene file in the test's folder.
Scenario with_obstacles(const std::string& obstacles) {
  return avo_io::parse_scenario(kHead + obstacles, path_of("scene.yaml"));
}

StaticObstacle only(const std::string& entry) {
  const Scenario scenario = with_obstacles("  - " + entry + "\n");
  EXPECT_EQ(scenario.obstacles.size(), 1U);
  return scenario.obstacles.at(0);
}

void expect_chain(const avo::Chain& chain, const Points& points, bool closed) {
  EXPECT_EQ(chain.closed, closed);
  ASSERT_EQ(chain.points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(chain.points[i], points[i]) << i;
}

TEST(Obstacles, of_every_kind_have_layers) {
  write_file(path_of("plan.wkt"), "LINESTRING (0 0, 1 0)");
  for (const char* entry : {"polyline: [[0, 0], [10, 0]]", "polygon: [[2, 2], [4, 2], [4, 4]]",
                            "disc: {center: [3, 3], radius: 0.5}", "wkt: 'LINESTRING (0 0, 1 0)'",
                            "wkt_file: plan.wkt"}) {
    EXPECT_EQ(only("{" + std::string(entry) + ", layers: [1, 4]}").layers.bits, 18U) << entry;
    EXPECT_EQ(only("{" + std::string(entry) + "}").layers, avo::kAllLayers) << entry;
  }
  try {
    static_cast<void>(only("{polyline: [[0, 0], [10, 0]], layers: [32]}"));
    ADD_FAILURE();
  } catch (const avo::Error& error) {
    EXPECT_NE(std::string(error.what()).find("obstacles.0.layers"), std::string::npos)
        << error.what();
  }
}

// A group that does not heed an obstacle is placed in it too, and goes through it.
TEST(Obstacles, of_other_layers_leave_random_places_free) {
  const auto inside = [](const std::string& layers) {
    const Scenario scene = avo_io::parse_scenario(
        "version: 1\nobstacles:\n  - {polygon: [[-4, -4], [4, -4], [4, 4], [-4, 4]], solid: true, "
        "layers: [0]}\ngroups:\n  - {number: 20, layers: " +
            layers +
            ", placement: {random: {min: [-6, -6], max: [6, 6]}}, goals: {random: {min: [-6, -6], "
            "max: [6, 6]}}}\n",
        "f");
    int count = 0;
    for (const avo::RobotSetup& robot : scene.robots)
      count += std::abs(robot.position.x) < 4.0 && std::abs(robot.position.y) < 4.0 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(inside("[0]"), 0);
  EXPECT_GT(inside("[1]"), 3);
}

TEST(Obstacles, polyline_polygon_and_disc) {
  const Scenario scenario = with_obstacles(R"yaml(
  - {polyline: [[0, 0], [10, 0], [10, 5]]}
  - {polygon: [[2, 2], [4, 2], [4, 4]]}
  - {polygon: [[2, 2], [4, 2], [4, 4]], solid: true}
  - {disc: {center: [3, 3], radius: 0.5}}
)yaml");
  ASSERT_EQ(scenario.obstacles.size(), 4U);
  for (const StaticObstacle& obstacle : scenario.obstacles) ASSERT_EQ(obstacle.chains.size(), 1U);
  expect_chain(scenario.obstacles[0].chains[0], {{0, 0}, {10, 0}, {10, 5}}, false);
  EXPECT_EQ(scenario.obstacles[0].fill, Fill::none);
  expect_chain(scenario.obstacles[1].chains[0], {{2, 2}, {4, 2}, {4, 4}}, true);
  EXPECT_EQ(scenario.obstacles[1].fill, Fill::none);
  EXPECT_EQ(scenario.obstacles[2].fill, Fill::solid);
  expect_chain(scenario.obstacles[3].chains[0], {{3, 3}}, false);
  EXPECT_EQ(scenario.obstacles[3].radius, 0.5);
  EXPECT_EQ(avo::walls_of(scenario.obstacles).size(), 2U + 3U + 3U + 1U);
}

TEST(Obstacles, navigation_is_unset_true_or_false) {
  EXPECT_EQ(with_obstacles("  []\n").navigation, std::nullopt);
  EXPECT_EQ(with_obstacles("  []\nnavigation: true\n").navigation, true);
  EXPECT_EQ(with_obstacles("  []\nnavigation: false\n").navigation, false);
}

TEST(Obstacles, values_can_be_set_beside_the_file) {
  const Scenario scenario =
      avo_io::parse_scenario(kHead + "  - {disc: {center: [3, 3], radius: 0.5}}\n", "f",
                             {"obstacles.0.disc.radius=2", "navigation=false"});
  EXPECT_EQ(scenario.obstacles[0].radius, 2.0);
  EXPECT_EQ(scenario.navigation, false);
}

TEST(Obstacles, wkt_lines_are_open_chains) {
  const StaticObstacle line = only("{wkt: \"LINESTRING (0 0, 1e1 .5, -1.5E+1 2)\"}");
  ASSERT_EQ(line.chains.size(), 1U);
  expect_chain(line.chains[0], {{0, 0}, {10, 0.5}, {-15, 2}}, false);
  const StaticObstacle lines = only("{wkt: \"MultiLineString((0 0,1 0),(2 0,3 0,3 1))\"}");
  ASSERT_EQ(lines.chains.size(), 2U);
  expect_chain(lines.chains[1], {{2, 0}, {3, 0}, {3, 1}}, false);
}

TEST(Obstacles, wkt_polygons_are_closed_chains_holes_too) {
  const std::string ring = "(0 0, 9 0, 9 9, 0 9, 0 0)", hole = "(3 3, 3 6, 6 6, 3 3)";
  const StaticObstacle solid = only("{wkt: \"POLYGON (" + ring + ", " + hole + ")\"}");
  EXPECT_EQ(solid.fill, Fill::solid);
  ASSERT_EQ(solid.chains.size(), 2U);
  expect_chain(solid.chains[0], {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true);
  expect_chain(solid.chains[1], {{3, 3}, {3, 6}, {6, 6}}, true);
  const StaticObstacle bounds = only("{wkt: \"POLYGON (" + ring + ")\", as: bounds}");
  EXPECT_EQ(bounds.fill, Fill::bounds);
  const StaticObstacle many =
      only("{wkt: \"MULTIPOLYGON ((" + ring + ", " + hole + "), ((20 0, 21 0, 21 1, 20 0)))\"}");
  EXPECT_EQ(many.chains.size(), 3U);
  const StaticObstacle mixed = only(
      "{wkt: \"GEOMETRYCOLLECTION (LINESTRING (0 0, 1 0), "
      "GEOMETRYCOLLECTION (POLYGON (" +
      ring + ")))\"}");
  ASSERT_EQ(mixed.chains.size(), 2U);
  EXPECT_FALSE(mixed.chains[0].closed);
  EXPECT_TRUE(mixed.chains[1].closed);
}

TEST(Obstacles, wkt_files_are_relative_to_the_scene) {
  write_file(path_of("plan.wkt"), "LINESTRING (0 0, 1 0)\r\nLINESTRING (0 0,\n0 7)\n");
  const StaticObstacle plan = only("{wkt_file: plan.wkt}");
  ASSERT_EQ(plan.chains.size(), 2U);
  expect_chain(plan.chains[1], {{0, 0}, {0, 7}}, false);
}

// Row 0 is the top. Free are the frame but one corner, and a cell in the middle.
TEST(Obstacles, a_map_becomes_the_contours_of_its_free_cells) {
  write_file(path_of("ring.map"),
             "type octile\nheight 5\nwidth 5\nmap\n"
             "....@\n"
             ".@@T.\n"
             "G@.W.\n"
             ".@O@.\n"
             "...S.\n");
  const StaticObstacle map = only("{map: ring.map, cell: 2, origin: [10, 20]}");
  EXPECT_EQ(map.fill, Fill::bounds) << "outside of the map is blocked";
  ASSERT_EQ(map.chains.size(), 2U);
  // the frame is a C: it begins at the lower left and keeps free cells on its left
  expect_chain(map.chains[0],
               {{10, 20},
                {20, 20},
                {20, 28},
                {18, 28},
                {18, 22},
                {12, 22},
                {12, 28},
                {18, 28},
                {18, 30},
                {10, 30}},
               true);
  expect_chain(map.chains[1], {{14, 24}, {16, 24}, {16, 26}, {14, 26}}, true);
}

TEST(Obstacles, a_map_with_a_hole_has_two_contours) {
  write_file(path_of("hole.map"), "type octile\nheight 4\nwidth 4\nmap\n....\n.@@.\n....\n....\n");
  const StaticObstacle map = only("{map: hole.map}");
  ASSERT_EQ(map.chains.size(), 2U);
  expect_chain(map.chains[0], {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true);
  expect_chain(map.chains[1], {{1, 3}, {3, 3}, {3, 2}, {1, 2}}, true);
}

TEST(Obstacles, cell_and_origin_may_be_left_out) {
  write_file(path_of("one.map"), "type octile\nheight 1\nwidth 3\nmap\n@.@\n");
  expect_chain(only("{map: one.map}").chains.at(0), {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, true);
}

const std::string kRosYaml =
    "image: map.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

// 254 is free, 205 unknown, 0 occupied; only the free cell at the upper left remains.
TEST(Obstacles, a_ros_map_takes_its_own_resolution_and_origin) {
  write_file(path_of("map.yaml"), kRosYaml);
  const Points expected{{-1, 2.5}, {-0.5, 2.5}, {-0.5, 3}, {-1, 3}};
  write_file(path_of("map.pgm"),
             "P5\n# by hand\n3 2\n255\n" + std::string("\xFE\xCD\x00\xCD\x00\xCD", 6));
  const StaticObstacle raw = only("{ros_map: map.yaml}");
  EXPECT_EQ(raw.fill, Fill::bounds);
  ASSERT_EQ(raw.chains.size(), 1U);
  expect_chain(raw.chains[0], expected, true);
  write_file(path_of("map.pgm"), "P2 3 2 # by hand\n255\n254 205 0\n205 0 205\n");
  expect_chain(only("{ros_map: map.yaml}").chains.at(0), expected, true);
  write_file(path_of("map.pgm"),
             "P5 3 2 65535\n" + std::string("\xFE\xFE\xCD\xCD\0\0\xCD\xCD\0\0\xCD\xCD", 12));
  expect_chain(only("{ros_map: map.yaml}").chains.at(0), expected, true);
}

TEST(Obstacles, a_ros_map_may_be_negated_and_turned) {
  write_file(path_of("map.pgm"), "P2 3 2 255\n0 50 255\n50 255 50\n");
  std::string yaml = kRosYaml;
  yaml.replace(yaml.find("negate: 0"), 9, "negate: 1");
  write_file(path_of("map.yaml"), yaml + "mode: scale\n");
  expect_chain(only("{ros_map: map.yaml}").chains.at(0),
               {{-1, 2.5}, {-0.5, 2.5}, {-0.5, 3}, {-1, 3}}, true);
  yaml.replace(yaml.find("2, 0]"), 5, "2, 1.5707963267948966]");
  write_file(path_of("map.yaml"), yaml);
  const Points turned = only("{ros_map: map.yaml}").chains.at(0).points;
  ASSERT_EQ(turned.size(), 4U);
  EXPECT_NEAR(turned[1].x, -1.5, 1e-15);
  EXPECT_NEAR(turned[1].y, 2.5, 1e-15);
}

TEST(Obstacles, the_image_of_a_ros_map_is_relative_to_it) {
  std::filesystem::create_directory(path_of("maps"));
  write_file(path_of("maps/map.yaml"), kRosYaml);
  write_file(path_of("maps/map.pgm"), "P2 1 1 255 254\n");
  EXPECT_EQ(only("{ros_map: maps/map.yaml}").chains.size(), 1U);
}

const std::string kMap = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";
const std::string kScen =
    "version 1\n"
    "0\tarena.map\t4\t3\t0\t0\t3\t2\t5.0\n"
    "0\tarena.map\t4\t3\t3\t0\t3\t2\t2.0\n"
    "1\tarena.map\t4\t3\t0\t2\t1\t1\t4.41421356\n";

Scenario with_scen(const std::string& from, const std::string& more = "") {
  write_file(path_of("arena.map"), kMap);
  write_file(path_of("arena.scen"), kScen);
  return avo_io::parse_scenario(
      "version: 1\nobstacles: [{map: arena.map, cell: 2, origin: [10, 20]}]\nrobots_from: " + from +
          "\n" + more,
      path_of("scene.yaml"));
}

TEST(Obstacles, robots_come_from_a_scenario) {
  const Scenario scenario = with_scen("{scen: arena.scen, number: 2}");
  ASSERT_EQ(scenario.robots.size(), 2U);
  EXPECT_EQ(scenario.robots[0].position, (Vec2{11, 25}));
  EXPECT_EQ(scenario.robots[0].goal, (Vec2{17, 21}));
  EXPECT_EQ(scenario.robots[1].goal, (Vec2{17, 21})) << "goals may touch";
  EXPECT_EQ(scenario.robots[0].radius, 0.9) << "0.45 cells";
  const Scenario three = with_scen("{scen: arena.scen, number: 3, radius: 0.4, max_speed: 1}");
  ASSERT_EQ(three.robots.size(), 3U) << "a goal in a blocked cell is nobody's fault";
  EXPECT_EQ(three.robots[2].radius, 0.4);
  EXPECT_EQ(three.robots[2].max_speed, 1.0);
  EXPECT_EQ(three.robots[2].preferred_speed, 1.0);
}

TEST(Obstacles, robots_of_a_scenario_stand_between_robots_and_groups) {
  const Scenario scenario = with_scen(
      "{scen: arena.scen, number: 1}",
      "robots: [{position: [17, 25], goal: [17, 21], radius: 0.3}]\n"
      "groups: [{number: 1, radius: 0.2, placement: {random: {min: [10, 20], max: [12, 26]}}, "
      "goals: antipodal}]\n");
  ASSERT_EQ(scenario.robots.size(), 3U);
  EXPECT_EQ(scenario.robots[0].radius, 0.3);
  EXPECT_EQ(scenario.robots[1].radius, 0.9);
  EXPECT_EQ(scenario.robots[2].radius, 0.2);
}

TEST(Obstacles, the_scenario_says_which_of_several_maps_it_is_of) {
  write_file(path_of("arena.map"), kMap);
  write_file(path_of("other.map"), "type octile\nheight 1\nwidth 1\nmap\n.\n");
  write_file(path_of("arena.scen"), kScen);
  const Scenario scenario = avo_io::parse_scenario(
      "version: 1\nobstacles: [{map: other.map, origin: [50, 50]}, {map: ./arena.map, origin: [5, "
      "0]}]\nrobots_from: {scen: arena.scen, number: 1}\n",
      path_of("scene.yaml"));
  EXPECT_EQ(scenario.robots[0].position, (Vec2{5.5, 2.5}));
}

TEST(Obstacles, validate_counts_walls) {
  write_file(path_of("s.yaml"), kHead + "  - {polyline: [[0, 0], [10, 0], [10, 5]]}\n");
  const ProcessResult result = run_avo({"validate", path_of("s.yaml")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("1 robots, 0 moving obstacles, 2 walls, "), std::string::npos)
      << result.out;
}

TEST(Obstacles, an_output_that_is_a_file_of_the_scene_is_refused) {
  write_file(path_of("arena"), kMap);
  write_file(path_of("s.yaml"), kHead + "  - {map: arena, cell: 200}\n");
  const ProcessResult result = run_avo({"run", path_of("s.yaml"), "--record", path_of("arena")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "avo: the scene's " + path_of("arena") + " and --record " +
                            path_of("arena") + ": found to be one file, must differ\n");
  EXPECT_EQ(read_file(path_of("arena")), kMap);
}

TEST(Obstacles, the_schema_knows_every_form) {
  const auto schema = nlohmann::ordered_json::parse(avo_io::scenario_schema());
  std::vector<std::string> kinds;
  for (const auto& kind : schema["$defs"]["obstacle"]["oneOf"]) {
    EXPECT_EQ(kind["additionalProperties"], false);
    kinds.push_back(kind["required"][0]);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"polyline", "polygon", "disc", "wkt", "wkt_file",
                                             "geojson", "map", "ros_map"}));
  EXPECT_EQ(schema["else"]["properties"]["navigation"]["type"], "boolean");
  EXPECT_EQ(schema["else"]["properties"]["robots_from"]["required"],
            nlohmann::ordered_json({"scen", "number"}));
  EXPECT_TRUE(schema["else"]["properties"]["robots_from"]["properties"].contains("radius"));
}

TEST(Obstacles, built_in_scenes_have_walls_and_start_clear_of_them) {
  for (const auto& [name, robots] : {std::pair{"doorway", 20},
                                     {"doorway-narrow", 20},
                                     {"corridor", 20},
                                     {"corridor-one-lane", 20},
                                     {"bottleneck", 40},
                                     {"office", 20},
                                     {"warehouse", 30},
                                     {"maze", 30},
                                     {"arena", 20}}) {
    const Scenario scenario = avo_io::load_scenario(name);
    EXPECT_EQ(scenario.robots.size(), static_cast<std::size_t>(robots)) << name;
    EXPECT_GE(avo::walls_of(scenario.obstacles).size(), 6U) << name;
    const ProcessResult result = run_avo({"validate", name});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
}

}  // namespace
}  // namespace avo_test
