// SPDX-License-Identifier: Apache-2.0
// Maps of ROS, as its map_server reads them (modes trinary and scale).
#include "ros_map.h"

#include <cmath>
#include <fmt/format.h>

#include "fields.h"
#include "file_names.h"
#include "graymap.h"
#include "reader.h"

namespace avo_io {
namespace {

RosMap read_settings(const Reader& reader, const YamlNode& root) {
  reader.check_keys(root, "", keys_of(fields<RosMap>()));
  RosMap map;
  reader.read(root, "", fields<RosMap>(), map);
  if (map.free_thresh > map.occupied_thresh)
    reader.fail(*root.find("free_thresh"), "free_thresh", fmt::format("{}", map.free_thresh),
                fmt::format("must be <= occupied_thresh = {}", map.occupied_thresh));
  return map;
}

void read_origin(const Reader& reader, const YamlNode& root, OccupancyGrid& grid) {
  const YamlNode* node = root.find("origin");
  if (node == nullptr)
    reader.fail_missing(root, "", "origin", "[x, y, yaw] of the lower left corner");
  if (node->kind != YamlNode::Kind::list || node->children.size() != 3)
    reader.fail(*node, "origin", shown(*node), "must be [x, y, yaw] in m and rad");
  const auto number = [&](std::size_t i, std::string_view unit) {
    return reader.number(node->children[i], fmt::format("origin.{}", i), avo::kAnyValue, unit);
  };
  grid.origin = {number(0, "m"), number(1, "m")};
  grid.yaw = number(2, "rad");
  constexpr double kLargestAngle = 0x1p40;  // of elementary functions
  if (std::abs(grid.yaw) > kLargestAngle)
    reader.fail(node->children[2], "origin.2", shown(node->children[2]), "must be an angle (rad)");
}

}  // namespace

OccupancyGrid read_ros_map(const SourceText& source, const std::string& folder, SceneFiles& files) {
  Document document;
  document.root = parse_yaml(source.text(), source.name(), document);
  const Reader reader(document);
  const RosMap map = read_settings(reader, document.root);
  OccupancyGrid grid;
  grid.cell = map.resolution;
  read_origin(reader, document.root, grid);
  const std::string path = path_in(folder, map.image);
  const SourceText text =
      read_named_file(reader, *document.root.find("image"), "image", path, files);
  const Graymap image = read_graymap(text);
  grid.width = image.width;
  grid.height = image.height;
  grid.free.reserve(image.values.size());
  for (const std::uint16_t value : image.values) {
    const auto white = static_cast<double>(image.white);
    const double dark = map.negate == 0 ? white - value : value;
    grid.free.push_back(dark / white < map.free_thresh);
  }
  return grid;
}

}  // namespace avo_io
