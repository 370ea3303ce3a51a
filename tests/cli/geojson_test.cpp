// SPDX-License-Identifier: Apache-2.0
// Obstacles from GeoJSON, and the kinds of well-known text that programs write for nothing.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using avo::Chain;
using avo::Vec2;

const std::string kOneRobot = "version: 1\nrobots: [{position: [5, 5], goal: [6, 5]}]\n";

avo::StaticObstacle plan(const std::string& text, const std::string& as = "solid") {
  write_file(path_of("plan.geojson"), text);
  return avo_io::parse_scenario(
             kOneRobot + "obstacles: [{geojson: plan.geojson, as: " + as + "}]\n",
             path_of("s.yaml"))
      .obstacles.at(0);
}

void expect_points(const Chain& chain, const std::vector<Vec2>& points, bool closed) {
  EXPECT_EQ(chain.closed, closed);
  EXPECT_EQ(chain.points, points);
}

const std::string kRing = "[[0,0],[9,0],[9,9],[0,9],[0,0]]";

TEST(Geojson, features_of_every_kind_become_chains) {
  const avo::StaticObstacle obstacle = plan(R"({"type": "FeatureCollection", "name": "floor",
    "features": [
      {"type": "Feature", "properties": {"layer": "walls"},
       "geometry": {"type": "LineString", "coordinates": [[1, 2], [3, 4, 0], [-0.5e1, 6]]}},
      {"type": "Feature", "properties": null,
       "geometry": {"type": "Polygon", "coordinates": [)" +
                                                kRing + R"(, [[3,3],[3,4],[4,4],[3,3]]]}},
      {"type": "Feature", "geometry": null},
      {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
        {"type": "MultiLineString", "coordinates": [[[0,0],[1,0]], [[2,0],[3,0]]]},
        {"type": "MultiPolygon", "coordinates": [[[[20,0],[21,0],[21,1],[20,0]]], []]},
        {"type": "LineString", "coordinates": []}]}}]})",
                                            "bounds");
  EXPECT_EQ(obstacle.fill, avo::Fill::bounds);
  ASSERT_EQ(obstacle.chains.size(), 6U);
  expect_points(obstacle.chains[0], {{1, 2}, {3, 4}, {-5, 6}}, false);
  expect_points(obstacle.chains[1], {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true);
  expect_points(obstacle.chains[2], {{3, 3}, {3, 4}, {4, 4}}, true);
  expect_points(obstacle.chains[4], {{2, 0}, {3, 0}}, false);
  expect_points(obstacle.chains[5], {{20, 0}, {21, 0}, {21, 1}}, true);
}

TEST(Geojson, a_feature_or_a_geometry_alone_will_do) {
  const std::string geometry = R"({"type": "Polygon", "coordinates": [)" + kRing + "]}";
  EXPECT_EQ(plan(geometry, "bounds").chains.size(), 1U);
  EXPECT_EQ(plan("\xEF\xBB\xBF{\"type\": \"Feature\", \"geometry\": " + geometry + "}", "bounds")
                .chains.size(),
            1U);
}

TEST(Geojson, points_and_degrees_are_noted) {
  write_file(path_of("plan.geojson"), R"({"type": "FeatureCollection",
    "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}},
    "features": [{"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 1]}},
                 {"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": [[1, 1]]}}]})");
  const std::string scene = path_of("s.yaml");
  write_file(scene, kOneRobot + "obstacles: [{geojson: plan.geojson}]\n");
  const ProcessResult result = run_avo({"validate", scene});
  EXPECT_EQ(result.exit_code, 0);
  const std::string name = "warning: " + path_of("plan.geojson");
  EXPECT_EQ(result.err,
            name +
                ": 2 points are left out: a point has no size; a pillar is {disc: {center: [x, "
                "y], radius: r}}\n" +
                name + ": \"crs\" speaks of degrees; its numbers are taken as m\n");
}

struct BadGeojson {
  const char* name;
  std::string text, message;  ///< behind the name of the file
};

void PrintTo(const BadGeojson& bad, std::ostream* out) {
  *out << bad.name;
}

std::string of_kind(const std::string& type, const std::string& coordinates) {
  return R"({"type": ")" + type + R"(", "coordinates": )" + coordinates + "}";
}

const std::string kNoJson = "found no JSON, must be a file of GeoJSON";
const std::vector<BadGeojson> kBadGeojsons{
    {"empty", "", "1:1: " + kNoJson},
    {"no_json", "LINESTRING (0 0, 1 0)", "1:1: " + kNoJson},
    {"cut", "{\"type\":\n\"LineString\", \"coordinates\": [[0, 0]", "2:37: " + kNoJson},
    {"bytes", "{\"type\": \"\xFF\"}", "1:11: " + kNoJson},
    {"huge_number", of_kind("LineString", "[[0, 1e999], [0, 0]]"),
     "1:1: found a number beyond all, must be a file of GeoJSON"},
    {"nan", of_kind("LineString", "[[0, NaN], [0, 0]]"), "1:44: " + kNoJson},
    {"list", "[]", "1:1: found a list of 0, must be an object with a \"type\""},
    {"no_type", "{}", "1:1: found no \"type\", must be there"},
    {"type_number", R"({"type": 7})", "1:1: type: found 7, must be a text"},
    {"topology", R"({"type": "Topology"})",
     "1:1: type: found \"Topology\", must be one of FeatureCollection, Feature, "
     "GeometryCollection, LineString, MultiLineString, Polygon, MultiPolygon, Point, MultiPoint"},
    {"no_coordinates", R"({"type": "Polygon"})", "1:1: found no \"coordinates\", must be there"},
    {"no_features", R"({"type": "FeatureCollection"})",
     "1:1: found no \"features\", must be there"},
    {"feature", R"({"type": "FeatureCollection", "features": [{"type": "Polygon"}]})",
     "1:1: features.0: found an object, must be an object of the \"type\" Feature"},
    {"geometry", R"({"type": "FeatureCollection", "features": [{"type": "Feature"}]})",
     "1:1: features.0: found no \"geometry\", must be there"},
    {"position", of_kind("MultiLineString", "[[[0, 0], [0]]]"),
     "1:1: coordinates.0.1: found a list of 1, must be [x, y] in m"},
    {"text", of_kind("LineString", "[[0, 0], [\"a\", 0]]"),
     "1:1: coordinates.1: found a list of 2, must be [x, y] in m"},
    {"beyond", of_kind("LineString", "[[0, 0], [1e13, 0]]"),
     "1:1: coordinates.1: found [10000000000000, 0], must be from -1e+12 to 1e+12 m"},
    {"depth", of_kind("LineString", "[[[0, 0], [1, 0]]]"),
     "1:1: coordinates.0: found a list of 2, must be [x, y] in m"},
    {"one_point", of_kind("LineString", "[[0, 0]]"),
     "1:1: coordinates: found a line of one point, must be of at least two"},
    {"open", of_kind("Polygon", "[[[0, 0], [1, 0], [1, 1]]]"),
     "1:1: coordinates.0: found a ring from [0, 0] to [1, 1], must be one that ends where it "
     "begins"},
    {"flat", of_kind("Polygon", "[[[0, 0], [1, 0], [0, 0]]]"),
     "1:1: coordinates.0: found a ring of 2 points, must be of at least 3"},
    {"nested_lists", of_kind("LineString", std::string(100'000, '[')), "1:100039: " + kNoJson},
};

class BadGeojsons : public testing::TestWithParam<BadGeojson> {};

TEST_P(BadGeojsons, are_refused_in_one_line) {
  write_file(path_of("plan.geojson"), GetParam().text);
  write_file(path_of("s.yaml"), kOneRobot + "obstacles: [{geojson: plan.geojson}]\n");
  const ProcessResult result = run_avo({"validate", path_of("s.yaml")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path_of("plan.geojson") + ":" + GetParam().message + "\n");
}

const auto kGeojsonName = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(All, BadGeojsons, testing::ValuesIn(kBadGeojsons), kGeojsonName);

TEST(EmptyWkt, has_no_walls_wherever_it_stands) {
  const auto chains_of = [](const std::string& wkt) {
    return avo_io::parse_scenario(kOneRobot + "obstacles: [{wkt: \"" + wkt + "\"}]\n", "s.yaml")
        .obstacles.at(0)
        .chains.size();
  };
  for (const std::string kind : {"POINT", "MULTIPOINT", "LINESTRING", "LINEARRING", "POLYGON",
                                 "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"})
    for (const std::string dimensions : {"", " Z", " M", " ZM"})
      EXPECT_EQ(chains_of(kind + dimensions + " EMPTY"), 0U) << kind << dimensions;
  const std::string ring = "(0 0, 1 0, 1 1, 0 0)";
  EXPECT_EQ(chains_of("MULTIPOLYGON (EMPTY, (" + ring + ", EMPTY), EMPTY)"), 1U);
  EXPECT_EQ(chains_of("MULTILINESTRING (EMPTY, (0 0, 1 0))"), 1U);
  EXPECT_EQ(chains_of("GEOMETRYCOLLECTION (POINT EMPTY, MULTIPOLYGON ((" + ring +
                      ")), GEOMETRYCOLLECTION EMPTY, LINEARRING " + ring + ")"),
            2U);
}

}  // namespace
}  // namespace avo_test
