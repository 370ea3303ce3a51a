// SPDX-License-Identifier: Apache-2.0
// Reads robots, moving obstacles and groups of a scene file, each from its map.
#include "io/scene/read_parts.h"

#include <algorithm>
#include <fmt/format.h>
#include <variant>

#include "io/fields/kinds.h"
#include "io/scene/read_model.h"
#include "io/scene/trajectory.h"

namespace avo_io {
namespace {

/// Sets the values that the robot's map does not give.
void complete(const YamlNode& node, avo::RobotSetup& robot) {
  const auto left_out = [&](std::string_view key) { return node.find(key) == nullptr; };
  if (auto* drive = std::get_if<avo::DifferentialDrive>(&robot.model)) {
    const YamlNode* own = node.find("drive");
    if (own == nullptr || own->find("offset") == nullptr)
      drive->offset = avo::usual_offset(robot.radius, drive->track);
    if (left_out("max_speed")) robot.max_speed = drive->wheel_speed;
    if (left_out("max_acceleration")) robot.max_acceleration = 0.5 * most_acceleration(*drive);
  }
  if (left_out("preferred_speed")) robot.preferred_speed = robot.max_speed;
}

/// Reads `parked`, which is short for a behavior.
void read_parked(const Reader& reader, const YamlNode& node, const std::string& path,
                 avo::RobotSetup& robot) {
  const YamlNode* parked = node.find("parked");
  if (parked == nullptr) return;
  const bool is = reader.truth(*parked, path_to(path, "parked"));
  if (node.find("behavior") == nullptr)
    robot.behavior = is ? avo::Behavior::parked : avo::Behavior::decides;
  else if (is != is_parked(robot))
    reader.fail(*parked, path_to(path, "parked"), parked->text,
                fmt::format("must be left out beside behavior: {}", to_string(robot.behavior)));
}

}  // namespace

void take_radius(const YamlNode& node, double radius, avo::RobotSetup& robot) {
  robot.radius = radius;
  complete(node, robot);
}

void read_robot(const Reader& reader, const YamlNode& node, const std::string& path,
                avo::RobotSetup& robot, bool patch) {
  reader.read_map(node, path, robot, patch);
  read_parked(reader, node, path, robot);
  read_model(reader, node, path, robot, nullptr);
  if (!patch) complete(node, robot);
}

namespace {

template <class T>
void check_area(const Reader& reader, const YamlNode& node, const std::string& path,
                const T& area) {
  if (area.min.x > area.max.x || area.min.y > area.max.y)
    reader.fail(node, path,
                fmt::format("min [{}, {}] and max [{}, {}]", area.min.x, area.min.y, area.max.x,
                            area.max.y),
                "min must not exceed max");
}
/// Reads a kind, given by its name alone or as the only key of a map: {circle: {spacing: 2}}.
template <class... Kinds>
void read_kind(const Reader& reader, const YamlNode& node, const std::string& path,
               std::variant<Kinds...>& target) {
  const std::vector<std::string_view> names{kind_text<Kinds>().key...};
  YamlNode alone;  // a name alone stands for a map without keys
  alone.kind = YamlNode::Kind::map;
  alone.line = node.line;
  alone.column = node.column;
  alone.source = node.source;
  const YamlNode* name = &node;
  const YamlNode* map = &alone;
  if (node.kind == YamlNode::Kind::map) {
    reader.check_keys(node, path, names);
    if (node.size() != 1)
      reader.fail(node, path, fmt::format("{} kinds", node.size()),
                  "must be one of " + joined(names));
    name = &node.children[0];
    map = &node.children[1];
  }
  if (name->kind != YamlNode::Kind::text ||
      std::find(names.begin(), names.end(), name->text) == names.end())
    reader.fail_choice(*name, path, names);
  const auto read_if_named = [&]<class Kind>(Kind kind) {
    if (kind_text<Kind>().key != name->text) return;
    const std::string inside = path_to(path, name->text);
    reader.read_map(*map, inside, kind);
    if constexpr (requires { kind.min.x; }) check_area(reader, *map, inside, kind);
    target = kind;
  };
  (read_if_named(Kinds{}), ...);
}

/// Reads the keys of T and the keys that all its robots share.
template <class T>
void read_alike(const Reader& reader, const YamlNode& node, const std::string& path, T& target) {
  std::vector<std::string_view> keys = keys_of(fields<T>());
  for (const std::string_view key : keys_of(group_robot_fields())) keys.push_back(key);
  reader.check_keys(node, path, keys);
  reader.read(node, path, fields<T>(), target);
  reader.read(node, path, group_robot_fields(), target.robot);
  read_parked(reader, node, path, target.robot);
  read_model(reader, node, path, target.robot, &target.heading);
  complete(node, target.robot);
}

}  // namespace

Group read_group(const Reader& reader, const YamlNode& node, const std::string& path) {
  Group group;
  read_alike(reader, node, path, group);
  read_kind(reader, *node.find("placement"), path_to(path, "placement"), group.placement);
  read_kind(reader, *node.find("goals"), path_to(path, "goals"), group.goals);
  if (const YamlNode* task = node.find("task"))
    read_kind(reader, *task, path_to(path, "task"), group.task.emplace());
  return group;
}

RobotsFrom read_robots_from(const Reader& reader, const YamlNode& node, const std::string& path) {
  RobotsFrom from;
  read_alike(reader, node, path, from);
  return from;
}

namespace {

/// Reads the trajectory. Without one, the obstacle must say where it starts; with one, it must not.
void read_its_trajectory(const Reader& reader, const YamlNode& node, const std::string& path,
                         SceneFiles& files, avo::MovingObstacle& obstacle) {
  const YamlNode *places = node.find("trajectory"), *file = node.find("trajectory_file");
  if (places == nullptr && file == nullptr) {
    if (node.find("position") == nullptr)
      reader.fail_missing(node, path, "position", "where it starts, or a trajectory");
    return;
  }
  if (places != nullptr && file != nullptr)
    reader.fail(*file, path_to(path, "trajectory_file"), "one beside a trajectory",
                "must be one of them");
  if (places != nullptr && obstacle.trajectory.empty())
    reader.fail(*places, path_to(path, "trajectory"), shown(*places),
                "must have at least one place");
  for (const char* key : {"position", "velocity", "acceleration"})
    if (const YamlNode* said = node.find(key))
      reader.fail(*said, path_to(path, key), shown(*said), "must be left out beside a trajectory");
  if (file != nullptr) {
    constexpr avo::Range kFileName{1.0, 4096.0, false};  // bytes
    const std::string place = path_to(path, "trajectory_file");
    const std::string name = reader.name(*file, place, kFileName);
    obstacle.trajectory = read_trajectory(read_named_file(reader, *file, place, name, files));
  }
  start_on_trajectory(obstacle);
}

}  // namespace

void read_moving_obstacle(const Reader& reader, const YamlNode& node, const std::string& path,
                          SceneFiles& files, avo::MovingObstacle& obstacle) {
  reader.read_map(node, path, obstacle);
  read_its_trajectory(reader, node, path, files, obstacle);
  const YamlNode* points = node.find("path");
  if (points != nullptr && obstacle.path.empty())
    reader.fail(*points, path_to(path, "path"), shown(*points), "must have at least one point");
}

void read_sensing(const Reader& reader, const YamlNode& scene, avo::SensingModel& sensing,
                  std::optional<avo::SensingError>& error) {
  if (const YamlNode* node = scene.find("sensing")) {
    const std::string path = "sensing";
    reader.read_map(*node, path, sensing);
    if (const YamlNode* noise = node->find("noise"))
      reader.read_map(*noise, path_to(path, "noise"), sensing.noise);
    if (const YamlNode* own = node->find("localization"))
      reader.read_map(*own, path_to(path, "localization"), sensing.localization);
  }
  if (const YamlNode* node = scene.find("sensing_error"))
    reader.read_map(*node, "sensing_error", error.emplace());
}

void read_execution(const Reader& reader, const YamlNode& scene,
                    std::optional<avo::ExecutionModel>& execution) {
  if (const YamlNode* node = scene.find("execution"))
    reader.read_map(*node, "execution", execution.emplace());
}

}  // namespace avo_io
