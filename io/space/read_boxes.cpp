// SPDX-License-Identifier: Apache-2.0
#include "io/space/read_boxes.h"

#include <fmt/format.h>
#include <span>

#include "io/space/space_boxes.h"

namespace avo_io {
namespace {

using avo::space::Box;

struct Heights {
  double low = -Box::kFar, high = Box::kFar;  // m
};

// Takes `height: [low, high]` out of an obstacle; without it the obstacle has all heights.
Heights take_heights(const Reader& reader, YamlNode& obstacle, const std::string& path) {
  if (obstacle.kind != YamlNode::Kind::map) return {};
  for (std::size_t k = 0; k + 1 < obstacle.children.size(); k += 2) {
    if (obstacle.children[k].text != "height") continue;
    const YamlNode& given = obstacle.children[k + 1];
    const std::string key = path_to(path, "height");
    const avo::Vec2 heights = reader.point(given, key, avo::kAnyValue, "m");
    if (heights.x > heights.y) reader.fail(given, key, shown(given), "must be [low, high]");
    const auto first = obstacle.children.begin() + static_cast<std::ptrdiff_t>(k);
    obstacle.children.erase(first, first + 2);
    return {heights.x, heights.y};
  }
  return {};
}

SpaceBox read_box(const Reader& reader, const YamlNode& node, const std::string& path) {
  SpaceBox box;
  reader.read_map(node, path, box);
  if (!(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z))
    reader.fail(node, path,
                fmt::format("min [{}, {}, {}] and max [{}, {}, {}]", box.min.x, box.min.y,
                            box.min.z, box.max.x, box.max.y, box.max.z),
                "min must not exceed max");
  return box;
}

}  // namespace

void read_boxes(const Reader& reader, const YamlNode& node, const std::string& path,
                SceneFiles& files, std::vector<NamedMap>& maps, std::vector<Box>& boxes) {
  const auto alone = [&](const char* key) {
    const YamlNode* value = node.kind == YamlNode::Kind::map ? node.find(key) : nullptr;
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
