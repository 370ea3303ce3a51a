// SPDX-License-Identifier: Apache-2.0
#include "io/space/read_boxes.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <span>
#include <string_view>

#include "io/space/space_boxes.h"

namespace avo_io {
namespace {

using avo::space::Box;

struct Heights {
  double low = -Box::kFar, high = Box::kFar;  // m
};

// Takes `height: [low, high]` out of an obstacle; without it the obstacle has all heights.
Heights take_heights(const Reader& reader, YamlNode& obstacle, const std::string& path) {
  for (std::size_t k = 0; k + 1 < obstacle.children.size(); k += 2) {
    if (obstacle.children[k].text != "height") continue;
    const YamlNode& given = obstacle.children[k + 1];
    const std::string key = path_to(path, "height");
    if (given.kind != YamlNode::Kind::list || given.children.size() != 2)
      reader.fail(given, key, shown(given), "must be [low, high] in m");
    const avo::Vec2 heights = reader.point(given, key, avo::kAnyValue, "m");
    if (heights.x > heights.y)
      reader.fail(given, key, fmt::format("[{}, {}]", heights.x, heights.y),
                  "must be [low, high], low must not exceed high");
    const auto first = obstacle.children.begin() + static_cast<std::ptrdiff_t>(k);
    obstacle.children.erase(first, first + 2);
    return {heights.x, heights.y};
  }
  return {};
}

SpaceBox read_box(const Reader& reader, const YamlNode& node, const std::string& path) {
  SpaceBox box;
  reader.read_map(node, path, box);
  require_ascending(reader, node, path, box.min, box.max);
  return box;
}

// Refuses keys of the plane that would have no effect: robots of space have no layers, and only the
// walls of a polygon become boxes.
constexpr std::array<std::string_view, 3> kOfPlane{"layers", "solid", "as"};

void refuse_plane_keys(const Reader& reader, const YamlNode& node, const std::string& path) {
  if (node.kind != YamlNode::Kind::map) return;
  for (const std::string_view key : kOfPlane)
    if (const YamlNode* given = node.find(key))
      reader.fail(*given, path_to(path, key), shown(*given),
                  "must be left out in a scene of space");
}

constexpr std::array<std::string_view, 3> kSpaceKinds{"floor", "ceiling", "box"};

// Refuses what is no obstacle of space, and names all that is.
void check_kind(const Reader& reader, const YamlNode& node, const std::string& path) {
  std::vector<std::string_view> kinds(kSpaceKinds.begin(), kSpaceKinds.end());
  const std::vector<std::string_view> of_plane = obstacle_kinds();
  kinds.insert(kinds.end(), of_plane.begin(), of_plane.end());
  std::vector<std::string_view> keys = kinds;
  keys.emplace_back("height");
  const auto has = [](const auto& list, std::string_view key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  for (const std::string_view key : obstacle_keys()) {
    if (!has(keys, key) && !has(kOfPlane, key)) keys.push_back(key);
  }
  refuse_plane_keys(reader, node, path);
  reader.check_keys(node, path, keys);
  const auto given = std::count_if(kinds.begin(), kinds.end(), [&](std::string_view kind) {
    return node.find(kind) != nullptr;
  });
  if (given != 1)
    reader.fail(node, path, fmt::format("{} kinds", given), "must be one of " + joined(kinds));
}

}  // namespace

void require_ascending(const Reader& reader, const YamlNode& node, const std::string& path,
                       const avo::Vec3& min, const avo::Vec3& max) {
  if (min.x <= max.x && min.y <= max.y && min.z <= max.z) return;
  reader.fail(node, path,
              fmt::format("min [{}, {}, {}] and max [{}, {}, {}]", min.x, min.y, min.z, max.x,
                          max.y, max.z),
              "min must not exceed max");
}

void read_boxes(const Reader& reader, const YamlNode& node, const std::string& path,
                SceneFiles& files, std::vector<NamedMap>& maps, std::vector<Box>& boxes) {
  check_kind(reader, node, path);
  const auto alone = [&](const char* key) {
    const YamlNode* value = node.find(key);
    if (value != nullptr) reader.check_keys(node, path, {key});
    return value;
  };
  const auto height = [&](const YamlNode& value, const char* key) {
    return reader.number(value, path_to(path, key), avo::kAnyValue, "m");
  };
  if (const YamlNode* floor = alone("floor")) {
    boxes.emplace_back().max.z = height(*floor, "floor");
  } else if (const YamlNode* ceiling = alone("ceiling")) {
    boxes.emplace_back().min.z = height(*ceiling, "ceiling");
  } else if (const YamlNode* bounds = alone("box")) {
    boxes.push_back(box_of(read_box(reader, *bounds, path_to(path, "box"))));
  } else {
    YamlNode plane = node;
    const auto [low, high] = take_heights(reader, plane, path);
    const avo::StaticObstacle obstacle = read_static_obstacle(reader, plane, path, files, maps);
    for (const avo::Wall& wall : walls_of(std::span(&obstacle, 1)))
      boxes.push_back(box_of(wall, low, high));
  }
}

}  // namespace avo_io
