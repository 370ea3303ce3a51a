// SPDX-License-Identifier: Apache-2.0
#include "io/space/read_robot.h"

#include "io/fields/fields.h"

namespace avo_io {
namespace {

using avo::space::RobotSetup;

// A robot's quadrotor, or changes of it; the quadrotor gives the limit of acceleration.
void read_quadrotor(const Reader& reader, const YamlNode& node, const std::string& path,
                    RobotSetup& robot) {
  if (const YamlNode* quadrotor = node.find("quadrotor")) {
    const bool is_changed = robot.quadrotor.has_value();
    if (!is_changed) robot.quadrotor.emplace();
    reader.read_map(*quadrotor, path_to(path, "quadrotor"), *robot.quadrotor, is_changed);
  }
  const YamlNode* given = node.find("max_acceleration");
  if (robot.quadrotor && given != nullptr)
    reader.fail(*given, path_to(path, "max_acceleration"), shown(*given),
                "must be left out: the quadrotor gives it");
}

}  // namespace

void read_robot(const Reader& reader, const YamlNode& node, const std::string& path,
                RobotSetup& robot, bool patch) {
  reader.read_map(node, path, robot, patch);
  read_quadrotor(reader, node, path, robot);
  if (!patch && node.find("preferred_speed") == nullptr) robot.preferred_speed = robot.max_speed;
}

void read_robot_of_group(const Reader& reader, const YamlNode& node, const std::string& path,
                         std::vector<std::string_view> keys, RobotSetup& robot) {
  std::vector<Field<RobotSetup>> table = fields<RobotSetup>();
  std::erase_if(table, [](const auto& f) { return f.key == "position" || f.key == "goal"; });
  for (const std::string_view key : keys_of(table)) keys.push_back(key);
  reader.check_keys(node, path, keys);
  reader.read(node, path, table, robot);
  read_quadrotor(reader, node, path, robot);
  if (node.find("preferred_speed") == nullptr) robot.preferred_speed = robot.max_speed;
}

}  // namespace avo_io
