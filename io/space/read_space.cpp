// SPDX-License-Identifier: Apache-2.0
// Makes a scenario of a scene file with `space: 3`: explicit robots first, then the groups.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <utility>

#include "avo/error.h"
#include "avo_io/space.h"
#include "core/retell.h"
#include "io/files/file_names.h"
#include "io/files/regular_file.h"
#include "io/recording/recorded_scene.h"
#include "io/scene/overrides.h"
#include "io/scene/random.h"
#include "io/scene/read_obstacles.h"
#include "io/scene/read_parts.h"
#include "io/scene/reader.h"
#include "io/scene/scene_files.h"
#include "io/space/placement.h"
#include "io/space/read_mover.h"
#include "io/space/read_robot.h"
#include "io/space/space_boxes.h"
#include "io/text/yaml_tree.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::Box;
using avo::space::RobotSetup;
using avo::space::Scenario;

constexpr std::string_view kSpaceKey = "space";

bool is_text(const YamlNode& node, std::string_view text) {
  return node.kind == YamlNode::Kind::text && !node.quoted && node.text == text;
}

/// Makes a scenario of a tree.
class SpaceBuilder {
 public:
  /// most_robots: the scene may have no more.
  SpaceBuilder(const Document& document, SceneFiles& files,
               std::int64_t most_robots = avo::kMostRobots)
      : document_(document), reader_(document), files_(files), most_robots_(most_robots) {}

  Scenario build(const std::vector<RobotPatch>& patches, const std::string& default_name) {
    const YamlNode& root = document_.root;
    reader_.check_keys(root, "", keys_of(fields<Scenario>()));
    const YamlNode* version = root.find("version");
    if (version == nullptr) reader_.fail_missing(root, "", "version", "version: 1");
    if (!is_text(*version, "1")) reader_.fail(*version, "version", shown(*version), "must be 1");
    scenario_.name = default_name;
    reader_.read(root, "", fields<Scenario>(), scenario_);
    read_sensing(reader_, root, scenario_.sensing, scenario_.sensing_error);
    read_obstacles();
    read_moving_obstacles();
    read_robots();
    read_groups();
    for (const RobotPatch& patch : patches) apply(patch);
    if (scenario_.robots.empty())
      reader_.fail(root, "", "no robots", "must have at least one in robots or groups");
    if (root.find("duration") == nullptr) set_usual_duration();
    validate();
    return std::move(scenario_);
  }

 private:
  const YamlNode* list_of(const char* key) const {
    const YamlNode* list = document_.root.find(key);
    if (list != nullptr) reader_.require_list(*list, key);
    return list;
  }

  void read_moving_obstacles() {
    const YamlNode* list = list_of("moving_obstacles");
    if (list == nullptr) return;
    for (std::size_t k = 0; k < list->children.size(); ++k)
      scenario_.moving_obstacles.push_back(read_moving_obstacle_in_space(
          reader_, list->children[k], fmt::format("moving_obstacles.{}", k)));
  }

  void read_robots() {
    const YamlNode* list = list_of("robots");
    if (list == nullptr) return;
    for (const YamlNode& node : list->children) {
      const std::string path = fmt::format("robots.{}", scenario_.robots.size());
      read_robot(reader_, node, path, scenario_.robots.emplace_back(), false);
    }
  }

  void apply(const RobotPatch& patch) {
    const std::string path = fmt::format("robots.{}", patch.robot);
    if (patch.robot >= scenario_.robots.size())
      reader_.fail(patch.map, "", path,
                   fmt::format("must be robots.0 to robots.{}", scenario_.robots.size() - 1));
    read_robot(reader_, patch.map, path, scenario_.robots[patch.robot], true);
  }

  void read_groups() {
    const YamlNode* list = list_of("groups");
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->children.size(); ++i) {
      const std::string path = fmt::format("groups.{}", i);
      const YamlNode& node = list->children[i];
      const SpaceGroup group = read_group(node, path);
      const std::int64_t total = static_cast<std::int64_t>(scenario_.robots.size()) + group.count;
      if (total > most_robots_)
        reader_.fail(node, path, fmt::format("{} robots in all", total),
                     fmt::format("must be at most {}", most_robots_));
      const std::string trouble = append_group(group, i, scenario_);
      if (!trouble.empty()) document_.fail(node, path_to(path, trouble));
    }
  }

  template <class T>
  T read_map(const YamlNode& node, const std::string& path) const {
    T result;
    reader_.check_keys(node, path, keys_of(fields<T>()));
    reader_.read(node, path, fields<T>(), result);
    return result;
  }

  SpaceGroup read_group(const YamlNode& node, const std::string& path) const {
    SpaceGroup group;
    read_robot_of_group(reader_, node, path, keys_of(fields<SpaceGroup>()), group.robot);
    reader_.read(node, path, fields<SpaceGroup>(), group);
    const YamlNode *sphere = node.find("sphere"), *box = node.find("box"),
                   *grid = node.find("grid");
    const int kinds = (sphere != nullptr) + (box != nullptr) + (grid != nullptr);
    if (kinds != 1)
      reader_.fail(node, path, fmt::format("{} placements", kinds),
                   "must have one of sphere, box, grid");
    if (sphere != nullptr)
      group.placement = read_map<SpherePlacement>(*sphere, path_to(path, "sphere"));
    if (box != nullptr) group.placement = read_map<BoxPlacement>(*box, path_to(path, "box"));
    if (grid != nullptr)
      group.placement = read_map<SpaceGridPlacement>(*grid, path_to(path, "grid"));
    read_goal(*node.find("goal"), path_to(path, "goal"), group);
    return group;
  }

  void read_goal(const YamlNode& node, const std::string& path, SpaceGroup& group) const {
    if (node.kind == YamlNode::Kind::map) {
      reader_.check_keys(node, path, {"offset"});
      const YamlNode* offset = node.find("offset");
      if (offset == nullptr) reader_.fail_missing(node, path, "offset", "{by: [x, y, z]}");
      group.goals = SpaceGoals::offset;
      group.offset = read_map<SpaceOffset>(*offset, path_to(path, "offset"));
      return;
    }
    constexpr std::array<std::pair<std::string_view, SpaceGoals>, 2> kGoals{
        {{"antipodal", SpaceGoals::antipodal}, {"permuted", SpaceGoals::permuted}}};
    group.goals = reader_.choice(node, path, kGoals);
  }

  void read_obstacles() {
    const YamlNode* list = list_of("obstacles");
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->children.size(); ++i) {
      read_obstacle(list->children[i], fmt::format("obstacles.{}", i));
      scenario_.obstacle_of_box.resize(scenario_.boxes.size(), static_cast<std::int64_t>(i));
    }
  }

  void read_obstacle(const YamlNode& node, const std::string& path) {
    const auto alone = [&](const char* key) {
      const YamlNode* value = node.kind == YamlNode::Kind::map ? node.find(key) : nullptr;
      if (value != nullptr) reader_.check_keys(node, path, {key});
      return value;
    };
    if (const YamlNode* floor = alone("floor")) {
      Box box;
      box.max.z = reader_.number(*floor, path_to(path, "floor"), avo::kAnyValue, "m");
      scenario_.boxes.push_back(box);
    } else if (const YamlNode* ceiling = alone("ceiling")) {
      Box box;
      box.min.z = reader_.number(*ceiling, path_to(path, "ceiling"), avo::kAnyValue, "m");
      scenario_.boxes.push_back(box);
    } else if (const YamlNode* bounds = alone("box")) {
      const std::string inside = path_to(path, "box");
      const SpaceBox box = read_map<SpaceBox>(*bounds, inside);
      if (!(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z))
        reader_.fail(*bounds, inside,
                     fmt::format("min [{}, {}, {}] and max [{}, {}, {}]", box.min.x, box.min.y,
                                 box.min.z, box.max.x, box.max.y, box.max.z),
                     "min must not exceed max");
      scenario_.boxes.push_back(box_of(box));
    } else {
      read_walls(node, path);
    }
  }

  // An obstacle of the plane, with `height: [low, high]`; without it, at all heights.
  void read_walls(const YamlNode& node, const std::string& path) {
    YamlNode plane = node;
    double low = -Box::kFar, high = Box::kFar;
    if (node.kind == YamlNode::Kind::map) {
      for (std::size_t k = 0; k + 1 < plane.children.size(); k += 2) {
        if (plane.children[k].text != "height") continue;
        const avo::Vec2 heights =
            reader_.point(plane.children[k + 1], path_to(path, "height"), avo::kAnyValue, "m");
        if (heights.x > heights.y)
          reader_.fail(plane.children[k + 1], path_to(path, "height"), shown(plane.children[k + 1]),
                       "must be [low, high]");
        low = heights.x, high = heights.y;
        const auto first = plane.children.begin() + static_cast<std::ptrdiff_t>(k);
        plane.children.erase(first, first + 2);
        break;
      }
    }
    const avo::StaticObstacle obstacle = read_static_obstacle(reader_, plane, path, files_, maps_);
    for (const avo::Wall& wall : walls_of(std::span(&obstacle, 1)))
      scenario_.boxes.push_back(box_of(wall, low, high));
  }

  // 60 s and twice the longest straight line, as in the plane.
  void set_usual_duration() {
    double longest = 0.0;
    for (const RobotSetup& robot : scenario_.robots) {
      const double along = std::min(robot.vertical, 1.0);
      if (robot.preferred_speed > 0.0)
        longest =
            std::max(longest, norm(robot.goal - robot.position) / (along * robot.preferred_speed));
    }
    scenario_.duration = std::min(60.0 + 2.0 * longest, avo::kLargest);
  }

  void validate() const {
    avo::retelling<avo::Error>(
        [this] { avo::space::validate(scenario_); },
        [this](const avo::Error& error) { document_.fail(document_.root, error.what()); });
  }

  const Document& document_;
  Reader reader_;
  SceneFiles& files_;
  std::int64_t most_robots_;
  std::vector<NamedMap> maps_;
  Scenario scenario_;
};

// Returns the document with its overrides, and those of robots that groups make.
std::vector<RobotPatch> parse(std::string_view yaml, const std::string& file,
                              const std::vector<std::string>& overrides, Document& document) {
  document.root = parse_yaml(yaml, file, document);
  return apply_overrides(overrides, document);
}

// Returns whether it is a scene of space. Throws if it has another number of dimensions.
bool is_in_space(const Document& document) {
  if (document.root.kind != YamlNode::Kind::map) return false;
  const YamlNode* space = document.root.find(kSpaceKey);
  if (space == nullptr || is_text(*space, "2")) return false;
  if (!is_text(*space, "3"))
    Reader(document).fail(*space, std::string(kSpaceKey), shown(*space), "must be 2 or 3");
  return true;
}

Scenario scenario_of_space(std::string_view yaml, const std::string& file,
                           const std::vector<std::string>& overrides, SceneFiles& files,
                           std::int64_t most_robots) {
  Document document;
  const std::vector<RobotPatch> patches = parse(yaml, file, overrides, document);
  if (!is_in_space(document))
    throw SceneError(file + ": found no space: 3, which scenes of space have");
  return SpaceBuilder(document, files, most_robots).build(patches, stem_of(file));
}

}  // namespace

std::optional<Scenario> load_space_scenario(const std::string& name_or_path,
                                            const std::vector<std::string>& overrides,
                                            SceneSource* source) {
  const std::optional<std::string> builtin = builtin_text(name_or_path);
  const bool is_input = name_or_path == "-";
  if (!builtin && !is_input && is_missing(name_or_path)) return std::nullopt;
  const std::string yaml = builtin    ? *builtin
                           : is_input ? read_standard_input()
                                      : read_regular_file(name_or_path);
  const auto speaks_of_space = [](const std::string& text) {
    return text.find(kSpaceKey) != std::string::npos;
  };
  if (!speaks_of_space(yaml) && std::none_of(overrides.begin(), overrides.end(), speaks_of_space))
    return std::nullopt;
  Document document;
  const std::string file = is_input ? kStandardInput : name_or_path;
  const std::vector<RobotPatch> patches = parse(yaml, file, overrides, document);
  if (!is_in_space(document)) return std::nullopt;
  SceneFiles files{folder_of(name_or_path)};
  files.builtin = builtin    ? BuiltinFiles::first
                  : is_input ? BuiltinFiles::last
                             : BuiltinFiles::none;
  Scenario scenario = SpaceBuilder(document, files).build(patches, stem_of(file));
  if (source != nullptr) *source = {file, yaml, overrides, std::move(files.read)};
  return scenario;
}

Scenario parse_space_scenario(std::string_view yaml, const std::string& file,
                              const std::vector<std::string>& overrides) {
  SceneFiles files{folder_of(file)};
  return scenario_of_space(yaml, file, overrides, files, avo::kMostRobots);
}

Scenario parse_space_scenario(const SceneSource& source) {
  return parse_space_scenario_of(source, avo::kMostRobots);
}

Scenario parse_space_scenario_of(const SceneSource& source, std::int64_t most_robots) {
  SceneFiles files{folder_of(source.name)};
  files.given = &source.files;
  return scenario_of_space(source.yaml, source.name, source.overrides, files, most_robots);
}

}  // namespace avo_io
