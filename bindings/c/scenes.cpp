// SPDX-License-Identifier: Apache-2.0
// Scenes as definitions. scene_files.h loads them.
#include <deque>
#include <memory>
#include <vector>

#include "convert.h"
#include "handles.h"
#include "layouts.h"
#include "scene_files.h"

namespace avo_c {
namespace {

// A scene, and the memory that its definition points to.
struct Scene {
  explicit Scene(avo::Scenario read);

  avo::Scenario scenario;
  std::vector<avo_robot_def> robots;
  std::vector<avo_moving_obstacle_def> moving_obstacles;
  std::vector<avo_obstacle_def> obstacles;
  std::deque<std::vector<avo_chain>> chains;  // of the obstacles
  std::vector<avo_team_def> teams;
  std::deque<std::vector<avo_robot_id>> members;  // of the teams
  avo_simulation_def def;
};

Scene::Scene(avo::Scenario read) : scenario(std::move(read)), def(settings_of(scenario)) {
  for (const avo::RobotSetup& robot : scenario.robots) robots.push_back(avo_c::def_of(robot));
  for (const avo::MovingObstacle& obstacle : scenario.moving_obstacles)
    moving_obstacles.push_back(avo_c::def_of(obstacle));
  for (const avo::StaticObstacle& obstacle : scenario.obstacles)
    obstacles.push_back(avo_c::def_of(obstacle, chains.emplace_back()));
  for (const avo::Team& team : scenario.teams)
    teams.push_back(avo_c::def_of(team, members.emplace_back()));
  def.teams = teams.data();
  def.team_count = teams.size();
  def.robots = robots.data();
  def.robot_count = robots.size();
  def.moving_obstacles = moving_obstacles.data();
  def.moving_obstacle_count = moving_obstacles.size();
  def.obstacles = obstacles.data();
  def.obstacle_count = obstacles.size();
}

AVO_C_CONSTINIT Handles<avo_scene_id, Scene> scenes("scene");

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_load_scene(const char* name_or_path, const char* const* overrides,
                          size_t override_count, avo_scene_id* scene) {
  return guarded([&] {
    avo_scene_id& id = at(scene, "scene");
    const char* name = &at(name_or_path, "name_or_path");
    id = scenes.add(std::make_unique<Scene>(load_scene(name, words_of(overrides, override_count))));
  });
}

avo_result avo_parse_scene(const char* yaml, size_t length, const char* file,
                           const char* const* overrides, size_t override_count,
                           avo_scene_id* scene) {
  return guarded([&] {
    avo_scene_id& id = at(scene, "scene");
    require_array(yaml, length, "yaml");
    id = scenes.add(std::make_unique<Scene>(
        parse_scene({yaml, length}, &at(file, "file"), words_of(overrides, override_count))));
  });
}

avo_result avo_destroy_scene(avo_scene_id scene) {
  return guarded([&] { scenes.take(scene); });
}

bool avo_scene_is_valid(avo_scene_id scene) {
  return scenes.find(scene) != nullptr;
}

avo_result avo_scene_get_def(avo_scene_id scene, avo_simulation_def* def) {
  return guarded([&] { write(def, scenes.at(scene).def, {"def"}); });
}
