// SPDX-License-Identifier: Apache-2.0
// Makes a scenario of a scene file with `space: 3`: explicit robots first, then the groups.
#include "io/space/read_space.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "avo/error.h"
#include "avo_io/space.h"
#include "core/retell.h"
#include "io/files/file_names.h"
#include "io/scene/origins.h"
#include "io/scene/overrides.h"
#include "io/scene/read_parts.h"
#include "io/scene/reader.h"
#include "io/scene/scene_files.h"
#include "io/space/placement.h"
#include "io/space/read_boxes.h"
#include "io/space/read_group.h"
#include "io/space/read_mover.h"
#include "io/space/read_robot.h"
#include "io/text/yaml_tree.h"

namespace avo_io {
namespace {

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
  SpaceBuilder(const Document& document, SceneFiles& files, std::int64_t most_robots)
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
      origins_.push_back(&node);
    }
  }

  void apply(const RobotPatch& patch) {
    const std::string path = fmt::format("robots.{}", patch.robot);
    if (patch.robot >= scenario_.robots.size())
      reader_.fail(patch.map, "", path,
                   fmt::format("must be robots.0 to robots.{}", scenario_.robots.size() - 1));
    read_robot(reader_, patch.map, path, scenario_.robots[patch.robot], true);
    origins_[patch.robot] = &patch.map;
  }

  void read_groups() {
    const YamlNode* list = list_of("groups");
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->children.size(); ++i) {
      const std::string path = fmt::format("groups.{}", i);
      const YamlNode& node = list->children[i];
      const SpaceGroup group = read_group_in_space(reader_, node, path);
      const std::int64_t total = static_cast<std::int64_t>(scenario_.robots.size()) + group.count;
      if (total > most_robots_)
        reader_.fail(node, path, fmt::format("{} robots in all", total),
                     fmt::format("must be at most {}", most_robots_));
      const std::string trouble = append_group(group, i, scenario_);
      if (!trouble.empty()) document_.fail(node, path_to(path, trouble));
      origins_.resize(scenario_.robots.size(), &node);
    }
  }

  void read_obstacles() {
    const YamlNode* list = list_of("obstacles");
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->children.size(); ++i) {
      read_boxes(reader_, list->children[i], fmt::format("obstacles.{}", i), files_, maps_,
                 scenario_.boxes);
      scenario_.obstacle_of_box.resize(scenario_.boxes.size(), static_cast<std::int64_t>(i));
    }
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
        [this](const avo::Error& error) { fail_at_origin(document_, origins_, error.what()); });
  }

  const Document& document_;
  Reader reader_;
  SceneFiles& files_;
  std::int64_t most_robots_;
  std::vector<NamedMap> maps_;
  std::vector<const YamlNode*> origins_;  // of each robot: its own map, its group's, or its patch's
  Scenario scenario_;
};

// Returns whether it is a scene of space. Throws if it has another number of dimensions.
bool is_in_space(const Document& document) {
  if (document.root.kind != YamlNode::Kind::map) return false;
  const YamlNode* space = document.root.find(kSpaceKey);
  if (space == nullptr || is_text(*space, "2")) return false;
  if (!is_text(*space, "3"))
    Reader(document).fail(*space, std::string(kSpaceKey), shown(*space), "must be 2 or 3");
  return true;
}

bool speaks_of_space(const std::string& text) {
  return text.find(kSpaceKey) != std::string::npos;
}

}  // namespace

std::optional<Scenario> scenario_if_in_space(const std::string& yaml, const std::string& file,
                                             const std::vector<std::string>& overrides,
                                             SceneFiles& files, std::int64_t most_robots) {
  if (!speaks_of_space(yaml) && std::none_of(overrides.begin(), overrides.end(), speaks_of_space))
    return std::nullopt;
  Document document;
  document.root = parse_yaml(yaml, file, document);
  const std::vector<RobotPatch> patches = apply_overrides(overrides, document);
  if (!is_in_space(document)) return std::nullopt;
  return SpaceBuilder(document, files, most_robots).build(patches, stem_of(file));
}

std::optional<Scenario> space_scenario_in(const SceneSource& source) {
  SceneFiles files{folder_of(source.name)};
  files.given = &source.files;
  return scenario_if_in_space(source.yaml, source.name, source.overrides, files, avo::kMostRobots);
}

}  // namespace avo_io
