// SPDX-License-Identifier: Apache-2.0
#include "io/space/read_group.h"

#include <array>
#include <fmt/format.h>
#include <string_view>
#include <utility>

#include "io/space/read_boxes.h"
#include "io/space/read_robot.h"

namespace avo_io {
namespace {

template <class T>
T read_part(const Reader& reader, const YamlNode& node, const std::string& path) {
  T part;
  reader.read_map(node, path, part);
  return part;
}

SpacePlacement read_space_placement(const Reader& reader, const YamlNode& group,
                                    const std::string& path) {
  const YamlNode *sphere = group.find("sphere"), *box = group.find("box"),
                 *grid = group.find("grid");
  const int kinds = (sphere != nullptr) + (box != nullptr) + (grid != nullptr);
  if (kinds != 1)
    reader.fail(group, path, fmt::format("{} placements", kinds),
                "must have one of sphere, box, grid");
  if (sphere != nullptr)
    return read_part<SpherePlacement>(reader, *sphere, path_to(path, "sphere"));
  if (box != nullptr) {
    const std::string inside = path_to(path, "box");
    const auto placement = read_part<BoxPlacement>(reader, *box, inside);
    require_ascending(reader, *box, inside, placement.min, placement.max);
    return placement;
  }
  return read_part<SpaceGridPlacement>(reader, *grid, path_to(path, "grid"));
}

void read_space_goals(const Reader& reader, const YamlNode& node, const std::string& path,
                      SpaceGroup& group) {
  if (node.kind == YamlNode::Kind::map) {
    reader.check_keys(node, path, {"offset"});
    const YamlNode* offset = node.find("offset");
    if (offset == nullptr) reader.fail_missing(node, path, "offset", "{by: [x, y, z]}");
    group.goals = SpaceGoals::offset;
    group.offset = read_part<SpaceOffset>(reader, *offset, path_to(path, "offset"));
    return;
  }
  constexpr std::array<std::pair<std::string_view, SpaceGoals>, 2> kGoals{
      {{"antipodal", SpaceGoals::antipodal}, {"permuted", SpaceGoals::permuted}}};
  group.goals = reader.choice(node, path, kGoals);
}

}  // namespace

SpaceGroup read_group_in_space(const Reader& reader, const YamlNode& node,
                               const std::string& path) {
  SpaceGroup group;
  read_robot_of_group(reader, node, path, keys_of(fields<SpaceGroup>()), group.robot);
  reader.read(node, path, fields<SpaceGroup>(), group);
  group.placement = read_space_placement(reader, node, path);
  read_space_goals(reader, *node.find("goal"), path_to(path, "goal"), group);
  return group;
}

}  // namespace avo_io
