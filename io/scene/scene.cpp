// SPDX-License-Identifier: Apache-2.0
// Makes a scenario of a scene file: explicit robots first, then the groups.
#include "avo_io/scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "avo/assumptions.h"
#include "core/retell.h"
#include "io/files/file_names.h"
#include "io/maps/stairs.h"
#include "io/recording/recorded_scene.h"
#include "io/scene/coincident.h"
#include "io/scene/origins.h"
#include "io/scene/overrides.h"
#include "io/scene/placement.h"
#include "io/scene/read_obstacles.h"
#include "io/scene/read_parts.h"
#include "io/scene/removed.h"
#include "io/scene/scene_text.h"
#include "io/text/yaml_tree.h"

namespace avo_io {
namespace {

using avo::Scenario;

/// Makes a scenario of a tree; knows the value that each robot comes from.
class SceneBuilder {
 public:
  SceneBuilder(const Document& document, SceneFiles& files)
      : document_(document), reader_(document), files_(files) {}

  /// `robots`: the required number of robots.
  Scenario build(const std::vector<RobotPatch>& patches, const std::string& default_name,
                 std::optional<std::int64_t> robots) {
    const YamlNode& root = document_.root;
    if (root.kind == YamlNode::Kind::nothing)
      reader_.fail(root, "", "nothing",
                   "must be a map with at least version and robots, robots_from or groups");
    refuse_removed(reader_, root);
    reader_.check_keys(root, "", keys_of(fields<Scenario>()));
    reader_.require_version(root);
    scenario_.name = default_name;
    reader_.read(root, "", fields<Scenario>(), scenario_);
    read_sensing(reader_, root, scenario_.sensing, scenario_.sensing_error);
    read_execution(reader_, root, scenario_.execution);
    if (robots) require_robots(*robots);
    add_moving_obstacles();
    add_obstacles();
    add_robots();
    add_robots_from();
    restore_large_stairs(scenario_.obstacles, smallest_radius());  // before any place is drawn
    add_groups();
    if (scenario_.robots.empty() && !files_.may_lack_robots)
      reader_.fail(root, "", "no robots",
                   "must have at least one in robots, robots_from or groups");
    apply(patches);
    restore_large_stairs(scenario_.obstacles, smallest_radius());
    if (root.find("duration") == nullptr) set_usual_duration();
    refuse_coincident();
    validate();
    return std::move(scenario_);
  }

 private:
  // Returns the smallest radius of the robots so far and of all groups; 0 if there are no robots.
  [[nodiscard]] double smallest_radius() const {
    double radius = std::numeric_limits<double>::infinity();
    for (const avo::RobotSetup& robot : scenario_.robots) radius = std::min(radius, robot.radius);
    const YamlNode* groups = document_.root.find("groups");
    const bool has_maps =
        std::any_of(scenario_.obstacles.begin(), scenario_.obstacles.end(),
                    [](const avo::StaticObstacle& one) { return !one.measured.empty(); });
    if (has_maps && groups != nullptr && groups->kind == YamlNode::Kind::list)
      for (std::size_t i = 0; i < groups->children.size(); ++i)
        radius = std::min(
            radius,
            read_group(reader_, groups->children[i], fmt::format("groups.{}", i)).robot.radius);
    return std::isfinite(radius) ? radius : 0.0;
  }

  // Checks the number before any robot is placed. A value that is not a list is refused later,
  // where it is read.
  void require_robots(std::int64_t robots) const {
    const auto items = [this](const char* key) {
      const YamlNode* list = document_.root.find(key);
      return list != nullptr && list->kind == YamlNode::Kind::list ? std::span(list->children)
                                                                   : std::span<const YamlNode>();
    };
    auto found = static_cast<std::int64_t>(items("robots").size());
    if (const YamlNode* node = document_.root.find("robots_from"))
      found += read_robots_from(reader_, *node, "robots_from").number;
    for (std::size_t i = 0; i < items("groups").size(); ++i)
      found += read_group(reader_, items("groups")[i], fmt::format("groups.{}", i)).number;
    if (found != robots)
      throw RecordingError(
          fmt::format("found {} robots, must be {}, those of its scene", robots, found));
  }

  void add_robots() {
    const YamlNode* list = document_.root.find("robots");
    if (list == nullptr) return;
    reader_.require_list(*list, "robots");
    for (const YamlNode& node : list->children) {
      const std::string path = fmt::format("robots.{}", scenario_.robots.size());
      read_robot(reader_, node, path, scenario_.robots.emplace_back(), false);
      origins_.push_back(&node);
    }
  }

  void add_robots_from() {
    const YamlNode* node = document_.root.find("robots_from");
    if (node == nullptr) return;
    append_robots_from(reader_, *node, "robots_from", files_, maps_, scenario_);
    origins_.resize(scenario_.robots.size(), node);
  }

  void add_obstacles() {
    const YamlNode* list = document_.root.find("obstacles");
    if (list == nullptr) return;
    reader_.require_list(*list, "obstacles");
    std::size_t walls = 0;
    for (const YamlNode& node : list->children) {
      const std::string path = fmt::format("obstacles.{}", scenario_.obstacles.size());
      scenario_.obstacles.push_back(read_static_obstacle(reader_, node, path, files_, maps_));
      for (const avo::Chain& chain : scenario_.obstacles.back().chains)
        walls += chain.points.size();
      if (walls > kMostWalls)
        reader_.fail(node, path, fmt::format("{} walls so far", walls),
                     fmt::format("must be at most {}", kMostWalls));
    }
  }

  void add_moving_obstacles() {
    const YamlNode* list = document_.root.find("moving_obstacles");
    if (list == nullptr) return;
    reader_.require_list(*list, "moving_obstacles");
    for (const YamlNode& node : list->children) {
      const std::string path =
          fmt::format("moving_obstacles.{}", scenario_.moving_obstacles.size());
      read_moving_obstacle(reader_, node, path, files_, scenario_.moving_obstacles.emplace_back());
    }
  }

  void add_groups() {
    const YamlNode* list = document_.root.find("groups");
    if (list == nullptr) return;
    reader_.require_list(*list, "groups");
    auto total = static_cast<std::int64_t>(scenario_.robots.size());
    for (std::size_t i = 0; i < list->children.size(); ++i) {
      const YamlNode& node = list->children[i];
      const std::string path = fmt::format("groups.{}", i);
      const Group group = read_group(reader_, node, path);
      total += group.number;
      if (total > avo::kMostRobots)
        reader_.fail(*node.find("number"), path_to(path, "number"),
                     fmt::format("{} robots in all", total),
                     fmt::format("must be at most {}", avo::kMostRobots));
      if (group.task) check_task(group, *node.find("task"), path_to(path, "task"));
      const std::string trouble = append_group(group, i, scenario_);
      if (!trouble.empty()) document_.fail(node, path_to(path, trouble));
      origins_.resize(scenario_.robots.size(), &node);
    }
  }

  void check_task(const Group& group, const YamlNode& node, const std::string& path) const {
    if (is_parked(group.robot))
      reader_.fail(node, path, "one of parked robots", "must be left out, as they do not move");
    avo::retelling<avo::Error>(
        [&] { avo::validate(*group.task); },
        [&](const avo::Error& error) { document_.fail(node, path_to(path, error.what())); });
  }

  void apply(const std::vector<RobotPatch>& patches) {
    for (const RobotPatch& patch : patches) {
      const std::string path = fmt::format("robots.{}", patch.robot);
      if (patch.robot >= scenario_.robots.size())
        reader_.fail(patch.map, "", path,
                     fmt::format("must be robots.0 to robots.{}", scenario_.robots.size() - 1));
      read_robot(reader_, patch.map, path, scenario_.robots[patch.robot], true);
      origins_[patch.robot] = &patch.map;
    }
  }

  /// Sets a duration that suffices to arrive by detours.
  void set_usual_duration() {
    double longest = 0.0;  // s
    for (const avo::RobotSetup& robot : scenario_.robots)
      if (robot.preferred_speed > 0.0)
        longest = std::max(longest, robot.start_time + 2.0 * norm(robot.goal - robot.position) /
                                                           robot.preferred_speed);
    scenario_.duration = std::ceil(60.0 + longest);
    if (scenario_.duration / scenario_.time_step > static_cast<double>(avo::kMostSteps))
      reader_.fail(document_.root, "",
                   fmt::format("no \"duration\", the usual one of {:g} s has more than {} steps",
                               scenario_.duration, avo::kMostSteps),
                   "must be given");
  }

  void refuse_coincident() const {
    if (scenario_.allow_broken_assumptions) return;
    const auto pair = find_coincident(scenario_.robots);
    if (!pair) return;
    const auto [a, b] = *pair;
    const YamlNode* position = origins_[b]->find("position");
    const avo::Vec2 place = scenario_.robots[b].position;
    reader_.fail(position != nullptr ? *position : *origins_[b],
                 fmt::format("robots.{}.position", b),
                 fmt::format("[{}, {}], the position of robots.{}", place.x, place.y, a),
                 "must differ from it");
  }

  void validate() const {
    avo::retelling<avo::Error>(
        [this] { avo::validate(scenario_); },
        [this](const avo::Error& error) { fail_at_origin(document_, origins_, error.what()); });
  }

  const Document& document_;
  Reader reader_;
  SceneFiles& files_;
  std::vector<NamedMap> maps_;
  Scenario scenario_;
  std::vector<const YamlNode*> origins_;  // of each robot: its own map, its group's, or its patch's
};

Scenario made_again(const SceneSource& source, std::optional<std::int64_t> robots) {
  SceneFiles files{folder_of(source.name)};
  files.given = &source.files;
  files.is_recorded = source.recorded;
  Scenario scenario = scenario_of(source.yaml, source.name, source.overrides, files, robots);
  if (source.start_at_rest) avo::start_at_rest(scenario);
  if (source.limit_speed) avo::limit_speed(scenario);
  return scenario;
}

}  // namespace

namespace {

// Takes `space: 2` away, which says nothing. Throws where the scene is one of space.
void require_plane(Document& document) {
  constexpr std::string_view kSpace = "space";
  std::vector<YamlNode>& children = document.root.children;
  const YamlNode* space =
      document.root.kind == YamlNode::Kind::map ? document.root.find(kSpace) : nullptr;
  if (space == nullptr) return;
  if (space->kind != YamlNode::Kind::text || space->text != "2")
    Reader(document).fail(*space, std::string(kSpace), shown(*space),
                          "must be 2 here; scenes of space: avo.space.run and the like in Python, "
                          "avo_c/space.h in C, no generate, no reports of sweeps");
  for (std::size_t k = 0; k + 1 < children.size(); k += 2) {
    if (children[k].text != kSpace) continue;
    children.erase(children.begin() + static_cast<std::ptrdiff_t>(k),
                   children.begin() + static_cast<std::ptrdiff_t>(k) + 2);
    return;
  }
}

}  // namespace

Scenario scenario_of(std::string_view yaml, const std::string& file,
                     const std::vector<std::string>& overrides, SceneFiles& files,
                     std::optional<std::int64_t> robots) {
  Document document;
  document.root = parse_yaml(yaml, file, document);
  const std::vector<RobotPatch> patches = apply_overrides(overrides, document);
  if (files.is_recorded) replace_removed(document.root);
  require_plane(document);
  return SceneBuilder(document, files).build(patches, stem_of(file), robots);
}

Scenario parse_scenario(std::string_view yaml, const std::string& file,
                        const std::vector<std::string>& overrides) {
  SceneFiles files{folder_of(file)};
  files.builtin = BuiltinFiles::last;  // as for text from the standard input
  return scenario_of(yaml, file, overrides, files);
}

Scenario parse_scenario(const SceneSource& source) {
  return made_again(source, {});
}

Scenario parse_scenario_of(const SceneSource& source, std::int64_t robots) {
  return made_again(source, robots);
}

}  // namespace avo_io
