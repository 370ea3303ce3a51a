// SPDX-License-Identifier: Apache-2.0
// The table of fields for static obstacles and maps.
#include "io/fields/fields.h"

namespace avo_io {

using avo::kAnyValue;
using avo::kNotNegative;
using avo::kPositive;
constexpr avo::Range kFile{1.0, 4096.0, false};  // bytes
constexpr avo::Range kShare{0.0, 1.0, false};

namespace {

template <class Kind>
Field<Kind> layers_field() {
  return {"layers",
          &Kind::layers,
          kOptional,
          kLayer,
          "",
          "robots that are in one of these layers heed it",
          "every robot heeds it"};
}

}  // namespace

template <>
const std::vector<Field<RobotsFrom>>& fields() {
  static const std::vector<Field<RobotsFrom>> table{
      {"scen", &RobotsFrom::scen, kRequired, kFile, "", "a MovingAI scenario of the scene's map"},
      {"number", &RobotsFrom::number, kRequired, kNumber, "", "how many of its rows, the first"},
  };
  return table;
}

template <>
const std::vector<Field<PolylineObstacle>>& fields() {
  static const std::vector<Field<PolylineObstacle>> table{
      {"polyline", &PolylineObstacle::points, kRequired, kAnyValue, "m",
       "an open chain of walls, from point to point"},
      layers_field<PolylineObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<PolygonObstacle>>& fields() {
  static const std::vector<Field<PolygonObstacle>> table{
      {"polygon", &PolygonObstacle::points, kRequired, kAnyValue, "m",
       "a closed chain of walls, in any orientation"},
      {"solid", &PolygonObstacle::solid, kOptional, kNoNumber, "", "no robot may start inside"},
      layers_field<PolygonObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<DiscObstacle>>& fields() {
  static const std::vector<Field<DiscObstacle>> table{
      {"disc", kNested, kRequired, kNoNumber, "", "a pillar"},
      layers_field<DiscObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<avo::Disc>>& fields() {
  static const std::vector<Field<avo::Disc>> table{
      {"center", &avo::Disc::center, kRequired, kAnyValue, "m", "where it stands"},
      {"radius", &avo::Disc::radius, kRequired, kNotNegative, "m", "of the disc"},
  };
  return table;
}

constexpr std::string_view kAsText =
    "solid: no robot may start inside its polygons; bounds: no robot may start outside";

template <>
const std::vector<Field<WktObstacle>>& fields() {
  static const std::vector<Field<WktObstacle>> table{
      {"wkt", kNested, kRequired, kNoNumber, "", "well-known text: lines and polygons, in m"},
      {"as", &WktObstacle::as, kOptional, kNoNumber, "", kAsText},
      layers_field<WktObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<WktFileObstacle>>& fields() {
  static const std::vector<Field<WktFileObstacle>> table{
      {"wkt_file", &WktFileObstacle::file, kRequired, kFile, "", "a file of well-known text"},
      {"as", &WktFileObstacle::as, kOptional, kNoNumber, "", kAsText},
      layers_field<WktFileObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<GeojsonObstacle>>& fields() {
  static const std::vector<Field<GeojsonObstacle>> table{
      {"geojson", &GeojsonObstacle::file, kRequired, kFile, "",
       "a file of GeoJSON: lines and polygons, in m"},
      {"as", &GeojsonObstacle::as, kOptional, kNoNumber, "", kAsText},
      layers_field<GeojsonObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<MapObstacle>>& fields() {
  static const std::vector<Field<MapObstacle>> table{
      {"map", &MapObstacle::file, kRequired, kFile, "", "a MovingAI map, all around it blocked"},
      {"cell", &MapObstacle::cell, kOptional, kPositive, "m", "side of a cell"},
      {"origin", &MapObstacle::origin, kOptional, kAnyValue, "m", "lower left corner"},
      layers_field<MapObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<RosMapObstacle>>& fields() {
  static const std::vector<Field<RosMapObstacle>> table{
      {"ros_map", &RosMapObstacle::file, kRequired, kFile, "",
       "a map.yaml of ROS, all around it blocked"},
      layers_field<RosMapObstacle>(),
  };
  return table;
}

template <>
const std::vector<Field<RosMap>>& fields() {
  static const std::vector<Field<RosMap>> table{
      {"image", &RosMap::image, kRequired, kFile, "", "a PGM, PNG or BMP, relative to this file"},
      {"resolution", &RosMap::resolution, kRequired, kPositive, "m", "side of a cell"},
      {"origin", kNested, kRequired, kNoNumber, "", "[x, y, yaw] of the lower left corner"},
      {"occupied_thresh", &RosMap::occupied_thresh, kRequired, kShare, "", "occupied above it"},
      {"free_thresh", &RosMap::free_thresh, kRequired, kShare, "", "free below it"},
      {"negate", kNested, kRequired, kNoNumber, "", "1 or true: white is occupied"},
      {"mode", &RosMap::mode, kOptional, kNoNumber, "", "how values are read"},
  };
  return table;
}

}  // namespace avo_io
