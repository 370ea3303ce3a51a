// SPDX-License-Identifier: Apache-2.0
// Reads entries of `obstacles`: each kind from its map, by the table of fields.
#include "io/scene/read_obstacles.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <variant>

#include "io/files/file_names.h"
#include "io/maps/geojson.h"
#include "io/maps/moving_ai.h"
#include "io/maps/ros_map.h"
#include "io/maps/stairs.h"
#include "io/maps/wkt.h"

namespace avo_io {
namespace {

using avo::Fill;
using avo::StaticObstacle;

/// The inputs for reading an entry, besides its values.
struct Place {
  const Reader& reader;
  const YamlNode& node;  // the entry
  const std::string& path;
  SceneFiles& files;
  std::vector<NamedMap>& maps;

  [[nodiscard]] const YamlNode& value(std::string_view key) const { return *node.find(key); }
  [[nodiscard]] SourceText file(std::string_view key, const std::string& name) const {
    return read_named_file(reader, value(key), path_to(path, key), name, files);
  }
};

StaticObstacle chain_of(const Place& place, std::string_view key, std::vector<avo::Vec2> points,
                        bool closed) {
  const std::size_t least = closed ? 3 : 2;
  if (points.size() < least)
    place.reader.fail(place.value(key), path_to(place.path, key),
                      fmt::format("{} points", points.size()),
                      fmt::format("must be at least {}", least));
  return {{avo::Chain{std::move(points), closed}}};
}

StaticObstacle filled(const Place& place, std::vector<avo::Chain> chains, Fill as) {
  const auto closed = [](const avo::Chain& chain) { return chain.closed; };
  if (as == Fill::bounds && std::none_of(chains.begin(), chains.end(), closed))
    place.reader.fail(place.value("as"), path_to(place.path, "as"), "bounds without a polygon",
                      "must have one, no robot may start outside of it");
  return {std::move(chains), 0.0, as};
}

/// Returns the obstacle of a map. The space outside it counts as blocked: its free cells are
/// bounds.
StaticObstacle obstacle_of(const Place& place, std::string_view key, const std::string& name,
                           const OccupancyGrid& grid) {
  const auto width = static_cast<double>(grid.width), height = static_cast<double>(grid.height);
  for (const avo::Vec2 corner : {grid.point(0.0, 0.0), grid.point(width, 0.0),
                                 grid.point(0.0, height), grid.point(width, height)})
    if (!avo::kAnyValue.contains(corner.x) || !avo::kAnyValue.contains(corner.y))
      place.reader.fail(place.value(key), path_to(place.path, key),
                        fmt::format("a corner at [{:g}, {:g}]", corner.x, corner.y),
                        fmt::format("must be within {:g} m of [0, 0]", avo::kLargest));
  const auto found = contours(grid, kMostWalls);
  if (!found)
    place.reader.fail(place.value(key), path_to(place.path, key),
                      fmt::format("more than {} walls in {}", kMostWalls, name), "must be fewer");
  if (found->empty())
    place.reader.fail(place.value(key), path_to(place.path, key),
                      fmt::format("no free cell in {}", name), "must have at least one");
  std::vector<Contour> straight;
  for (const Contour& contour : *found) straight.push_back(without_stairs(contour));
  if (straight == *found) return {chains_of(grid, *found), 0.0, Fill::bounds};
  return {chains_of(grid, straight), 0.0, Fill::bounds, chains_of(grid, *found)};
}

StaticObstacle build(const Place& place, PolylineObstacle& entry) {
  return chain_of(place, "polyline", std::move(entry.points), false);
}

StaticObstacle build(const Place& place, PolygonObstacle& entry) {
  StaticObstacle obstacle = chain_of(place, "polygon", std::move(entry.points), true);
  if (entry.solid) obstacle.fill = Fill::solid;
  return obstacle;
}

StaticObstacle build(const Place& place, DiscObstacle& entry) {
  const YamlNode& node = place.value("disc");
  const std::string path = path_to(place.path, "disc");
  place.reader.read_map(node, path, entry.disc);
  return {{avo::Chain{{entry.disc.center}}}, entry.disc.radius};
}

StaticObstacle build(const Place& place, WktObstacle& entry) {
  const YamlNode& node = place.value("wkt");
  const std::string path = path_to(place.path, "wkt");
  if (node.kind != YamlNode::Kind::text)
    place.reader.fail(node, path, shown(node), "must be a text such as LINESTRING (0 0, 1 0)");
  return filled(place, read_wkt(SourceText(place.reader.document(), node, path)), entry.as);
}

StaticObstacle build(const Place& place, WktFileObstacle& entry) {
  return filled(place, read_wkt(place.file("wkt_file", entry.file)), entry.as);
}

StaticObstacle build(const Place& place, GeojsonObstacle& entry) {
  return filled(place, read_geojson(place.file("geojson", entry.file), place.files.notes),
                entry.as);
}

StaticObstacle build(const Place& place, MapObstacle& entry) {
  const SourceText source = place.file("map", entry.file);
  OccupancyGrid grid = read_moving_ai_map(source);
  grid.cell = entry.cell;
  grid.origin = entry.origin;
  StaticObstacle obstacle = obstacle_of(place, "map", source.name(), grid);
  place.maps.push_back({entry.file, std::move(grid)});
  return obstacle;
}

StaticObstacle build(const Place& place, RosMapObstacle& entry) {
  const SourceText source = place.file("ros_map", entry.file);
  const std::string folder = folder_of(entry.file);
  const OccupancyGrid grid = read_ros_map(source, folder, place.files);
  return obstacle_of(place, "ros_map", source.name(), grid);
}

template <class... Kinds>
std::vector<std::string_view> kinds_of(const std::variant<Kinds...>*) {
  return {fields<Kinds>().front().key...};
}

template <class... Kinds>
std::vector<std::string_view> keys_of_all(const std::variant<Kinds...>*) {
  std::vector<std::string_view> keys;
  const auto add_key = [&keys](std::string_view key) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  };
  const auto add_keys = [&](const auto& table) {
    for (const auto& field : table) add_key(field.key);
  };
  (add_keys(fields<Kinds>()), ...);
  return keys;
}

constexpr const ObstacleEntry* kEntry = nullptr;

/// Reads the entry of the only kind with a key that is present.
template <class... Kinds>
StaticObstacle build_any(const Place& place, const std::variant<Kinds...>*) {
  const std::vector<std::string_view> kinds = obstacle_kinds(), keys = obstacle_keys();
  const auto& [reader, node, path, files, maps] = place;
  reader.check_keys(node, path, keys);
  const auto given = std::count_if(kinds.begin(), kinds.end(), [&place](std::string_view kind) {
    return place.node.find(kind) != nullptr;
  });
  if (given != 1)
    reader.fail(node, path, fmt::format("{} kinds", given), "must be one of " + joined(kinds));
  StaticObstacle obstacle;
  const auto build_if_given = [&]<class Kind>(Kind entry) {
    const auto& table = fields<Kind>();
    if (place.node.find(table.front().key) == nullptr) return;
    place.reader.check_keys(place.node, place.path, keys_of(table));
    place.reader.read(place.node, place.path, table, entry);
    obstacle = build(place, entry);
    obstacle.layers = entry.layers;
  };
  (build_if_given(Kinds{}), ...);
  return obstacle;
}

}  // namespace

std::vector<std::string_view> obstacle_kinds() {
  return kinds_of(kEntry);
}

std::vector<std::string_view> obstacle_keys() {
  return keys_of_all(kEntry);
}

StaticObstacle read_static_obstacle(const Reader& reader, const YamlNode& node,
                                    const std::string& path, SceneFiles& files,
                                    std::vector<NamedMap>& maps) {
  return build_any({reader, node, path, files, maps}, kEntry);
}

}  // namespace avo_io
