// SPDX-License-Identifier: Apache-2.0
#include "io/space/read_mover.h"

#include <fmt/format.h>
#include <vector>

#include "io/fields/fields.h"

namespace avo_io {
namespace {

using avo::space::MovingObstacle;
using avo::space::TimedPoint;

std::vector<TimedPoint> read_points(const Reader& reader, const YamlNode& node,
                                    const std::string& path) {
  reader.require_list(node, path);
  std::vector<TimedPoint> points;
  for (const YamlNode& child : node.children) {
    const std::string place = path_to(path, fmt::format("{}", points.size()));
    if (child.kind != YamlNode::Kind::list || child.children.size() != 4)
      reader.fail(child, place, shown(child), "must be [time, x, y, z] in s and m");
    const auto number = [&](std::size_t k, const char* unit) {
      return reader.number(child.children[k], path_to(place, fmt::format("{}", k)), avo::kAnyValue,
                           unit);
    };
    points.push_back({number(0, "s"), {number(1, "m"), number(2, "m"), number(3, "m")}});
  }
  if (points.empty()) reader.fail(node, path, shown(node), "must have at least one place");
  return points;
}

}  // namespace

MovingObstacle read_moving_obstacle_in_space(const Reader& reader, const YamlNode& node,
                                             const std::string& path) {
  MovingObstacle obstacle;
  reader.read_map(node, path, obstacle);
  const YamlNode* trajectory = node.find("trajectory");
  if (trajectory == nullptr) {
    if (node.find("position") == nullptr)
      reader.fail_missing(node, path, "position", "where it starts, or a trajectory");
    return obstacle;
  }
  for (const char* key : {"position", "velocity", "acceleration"})
    if (const YamlNode* said = node.find(key))
      reader.fail(*said, path_to(path, key), shown(*said), "must be left out beside a trajectory");
  obstacle.trajectory = read_points(reader, *trajectory, path_to(path, "trajectory"));
  return obstacle;
}

}  // namespace avo_io
