// SPDX-License-Identifier: Apache-2.0
// Adds, changes and removes moving obstacles between steps.
#include <new>
#include <string>
#include <utility>

#include "core/ranges.h"
#include "sim/edits.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Where it is now: a trajectory says so itself.
PathWalk start_of(const World& world, const MovingObstacle& obstacle) {
  if (obstacle.trajectory.empty()) return {obstacle.position, obstacle.velocity};
  const double time = world.fleet.has_clocks
                          ? seconds(world.now)
                          : static_cast<double>(world.steps) * world.settings.time_step;
  return on_trajectory(obstacle, time);
}

// The obstacle as a scene lists it, if no scene refuses it.
MovingObstacle checked(const World& world, const MovingObstacle& obstacle, MovingObstacleId id) {
  Scenario scene = settings_for(world, {});
  scene.moving_obstacles = {obstacle};
  start_on_trajectory(scene.moving_obstacles.front());
  validate_as(scene, "moving_obstacles.0.", name_of(id));
  return scene.moving_obstacles.front();
}

void adopt(World& world, ObstacleColumns obstacles) {
  std::vector<Pace> paces = paces_among(world, !obstacles.setup.empty());
  std::swap(world.paces, paces);
  std::swap(world.obstacles, obstacles);
  world.changed = true;
  world.reserve_workers();
}

}  // namespace

MovingObstacleId add_moving_obstacle(World& world, const MovingObstacle& obstacle) {
  const MovingObstacleId id{world.obstacles.next_id};
  catch_up(world);
  const MovingObstacle setup = checked(world, obstacle, id);
  const PathWalk start = start_of(world, setup);
  check_mover_start(world, setup, start, name_of(id));
  ObstacleColumns obstacles = world.obstacles;
  obstacles.add(setup, start);
  adopt(world, std::move(obstacles));
  return id;
}

void change_moving_obstacle(World& world, MovingObstacleId id, const MovingObstacle& obstacle) {
  const std::size_t index = world.obstacles.find(id);
  MovingObstacle setup = checked(world, obstacle, id);
  const PathWalk start = start_of(world, setup);
  ObstacleColumns& obstacles = world.obstacles;
  obstacles.position[index] = start.position, obstacles.velocity[index] = start.velocity;
  obstacles.target[index] = start.target;
  std::swap(obstacles.setup[index], setup);
  obstacles.look_over();
  world.changed = true;
}

void remove_moving_obstacle(World& world, MovingObstacleId id) {
  const std::size_t index = world.obstacles.find(id);
  catch_up(world);
  ObstacleColumns obstacles = world.obstacles;
  obstacles.remove(index);
  adopt(world, std::move(obstacles));
}

}  // namespace avo::inline sim
