// SPDX-License-Identifier: Apache-2.0
// GeoJSON by recursive descent through the tree of the file.
#include "io/maps/geojson.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/ranges.h"
#include "io/scene/scene_files.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

using avo::Chain;
using Geojson = nlohmann::json;

constexpr int kDeepestGeojson = 16;  // depth of nested collections

std::string shown_json(const Geojson& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  if (value.is_null()) return "null";
  return value.dump();
}

/// The file, the result so far, and the position of the reader in the file.
struct GeojsonReader {
  const SourceText& source;
  std::string path = {};  // of the value: "features.3.geometry"
  int depth = 0;          // of collections
  std::vector<Chain> chains = {};
  std::int64_t points_left_out = 0;

  [[noreturn]] void fail(const std::string& found, const std::string& allowed) const {
    source.fail(
        0, fmt::format("{}found {}, must be {}", path.empty() ? "" : path + ": ", found, allowed));
  }
  [[noreturn]] void refuse(const Geojson& found, const std::string& allowed) const {
    fail(shown_json(found), allowed);
  }
  /// Reads a part of a value, and keeps its path.
  template <class Read>
  void within(const std::string& part, const Read& read) {
    const std::size_t before = path.size();
    path += (path.empty() ? "" : ".") + part;
    read();
    path.resize(before);
  }
  template <class Read>
  void each(const Geojson& list, const Read& read) {
    if (!list.is_array()) refuse(list, "a list");
    for (std::size_t i = 0; i < list.size(); ++i) within(std::to_string(i), [&] { read(list[i]); });
  }
  /// Returns the value of a required key.
  template <class Read>
  void member(const Geojson& object, const char* key, const Read& read) {
    const auto found = object.find(key);
    if (found == object.end()) fail("no \"" + std::string(key) + "\"", "there");
    within(key, [&] { read(*found); });
  }

  avo::Vec2 position(const Geojson& value);
  std::vector<avo::Vec2> positions(const Geojson& value);
  void line(const Geojson& value);
  void ring(const Geojson& value);
  void coordinates(std::string_view type, const Geojson& value);
  void geometry(const Geojson& value);
  void any(const Geojson& value);
};

avo::Vec2 GeojsonReader::position(const Geojson& value) {
  if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number())
    refuse(value, "[x, y] in m");
  const avo::Vec2 point{value[0].get<double>() + 0.0, value[1].get<double>() + 0.0};  // no -0
  if (!avo::kAnyValue.contains(point.x) || !avo::kAnyValue.contains(point.y))
    fail(fmt::format("[{}, {}]", point.x, point.y),
         fmt::format("from -{0:g} to {0:g} m", avo::kLargest));
  return point;
}

std::vector<avo::Vec2> GeojsonReader::positions(const Geojson& value) {
  std::vector<avo::Vec2> points;
  each(value, [&](const Geojson& item) { points.push_back(position(item)); });
  return points;
}

void GeojsonReader::line(const Geojson& value) {
  std::vector<avo::Vec2> points = positions(value);
  if (points.empty()) return;
  if (points.size() < 2) fail("a line of one point", "of at least two");
  chains.push_back({std::move(points), false});
}

void GeojsonReader::ring(const Geojson& value) {
  std::vector<avo::Vec2> points = positions(value);
  if (points.empty()) return;
  const avo::Vec2 first = points.front(), last = points.back();
  if (!(first == last))
    fail(fmt::format("a ring from [{}, {}] to [{}, {}]", first.x, first.y, last.x, last.y),
         "one that ends where it begins");
  points.pop_back();
  if (points.size() < 3) fail(fmt::format("a ring of {} points", points.size()), "of at least 3");
  chains.push_back({std::move(points), true});
}

void GeojsonReader::coordinates(std::string_view type, const Geojson& value) {
  const auto to_ring = [this](const Geojson& item) { ring(item); };
  if (type == "LineString")
    line(value);
  else if (type == "MultiLineString")
    each(value, [this](const Geojson& item) { line(item); });
  else if (type == "Polygon")
    each(value, to_ring);
  else  // MultiPolygon
    each(value, [&](const Geojson& item) { each(item, to_ring); });
}

void GeojsonReader::geometry(const Geojson& value) {
  if (!value.is_object()) refuse(value, "an object with a \"type\"");
  std::string type;
  member(value, "type", [&](const Geojson& name) {
    if (!name.is_string()) refuse(name, "a text");
    type = name.get<std::string>();
  });
  constexpr std::string_view kChains[] = {"LineString", "MultiLineString", "Polygon",
                                          "MultiPolygon"};
  if (type == "GeometryCollection") {
    if (++depth > kDeepestGeojson)
      fail(type, fmt::format("nested at most {} deep", kDeepestGeojson));
    member(value, "geometries",
           [&](const Geojson& list) { each(list, [&](const Geojson& item) { geometry(item); }); });
    --depth;
  } else if (type == "Point" || type == "MultiPoint") {
    ++points_left_out;
  } else if (std::find(std::begin(kChains), std::end(kChains), type) != std::end(kChains)) {
    member(value, "coordinates", [&](const Geojson& list) { coordinates(type, list); });
  } else {
    within("type", [&] {
      fail(in_quotes(type),
           "one of FeatureCollection, Feature, GeometryCollection, LineString, MultiLineString, "
           "Polygon, MultiPolygon, Point, MultiPoint");
    });
  }
}

// Reads a geometry, a feature, or features. A feature may have no geometry: "geometry": null.
void GeojsonReader::any(const Geojson& value) {
  const auto read_feature = [this](const Geojson& feature) {
    if (!feature.is_object() || feature.value("type", Geojson()) != "Feature")
      refuse(feature, "an object of the \"type\" Feature");
    member(feature, "geometry", [this](const Geojson& own) {
      if (!own.is_null()) geometry(own);
    });
  };
  const Geojson type = value.is_object() ? value.value("type", Geojson()) : Geojson();
  if (type == "FeatureCollection")
    member(value, "features", [&](const Geojson& features) { each(features, read_feature); });
  else if (type == "Feature")
    read_feature(value);
  else
    geometry(value);
}

/// Returns whether the file names a system of degrees; no plan uses one, but other tools may write
/// it.
bool speaks_of_degrees(const Geojson& root) {
  if (!root.is_object() || !root.contains("crs")) return false;
  const std::string crs = root["crs"].dump(-1, ' ', true, Geojson::error_handler_t::replace);
  return crs.find("CRS84") != std::string::npos || crs.find("4326") != std::string::npos;
}

}  // namespace

std::vector<Chain> read_geojson(const SourceText& source, std::vector<std::string>& notes) {
  Geojson root;
  try {
    root = Geojson::parse(source.text());
  } catch (const Geojson::parse_error& error) {
    const std::size_t at = error.byte > 0 ? error.byte - 1 : 0;
    source.fail(std::min(at, source.text().size()), "found no JSON, must be a file of GeoJSON");
  } catch (const Geojson::exception&) {
    source.fail(0, "found a number beyond all, must be a file of GeoJSON");
  }
  GeojsonReader reader{source};
  reader.any(root);
  if (reader.points_left_out > 0)
    add_note(notes, fmt::format("{}: {} points are left out: a point has no size; a pillar is "
                                "{{disc: {{center: [x, y], radius: r}}}}",
                                source.name(), reader.points_left_out));
  if (speaks_of_degrees(root))
    add_note(notes, fmt::format("{}: \"crs\" speaks of degrees; its numbers are taken as m",
                                source.name()));
  return std::move(reader.chains);
}

}  // namespace avo_io
