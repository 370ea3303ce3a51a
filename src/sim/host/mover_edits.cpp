// SPDX-License-Identifier: Apache-2.0
// Adds, changes and removes moving obstacles between steps.
#include <new>
#include <string>
#include <utility>

#include "core/ranges.h"
#include "sim/host/edits.h"
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

// Robots go around movers at rest, so that routes may change.
void replace(World& world, MoverColumns movers) {
  std::swap(world.movers, movers);
  try {
    go_around_resting(world);
  } catch (...) {
    std::swap(world.movers, movers);
    throw;
  }
}

// The same where robots may count on other limits, or on the first mover.
void adopt(World& world, MoverColumns movers, double sensing_radius) {
  std::vector<Pace> paces = paces_among(world, !movers.setup.empty());
  replace(world, std::move(movers));
  std::swap(world.paces, paces);
  world.sensing_radius = sensing_radius;
  world.changed = true;
  world.reserve_workers();
}

// Returns whether only the place and the velocity are others, and robots count on no more than
// before.
bool only_moves(const MovingObstacle& now, const MovingObstacle& changed) {
  return changed.path.empty() && changed.trajectory.empty() && now.path.empty() &&
         now.trajectory.empty() && changed.acceleration == now.acceleration &&
         changed.radius == now.radius && changed.max_deviation == now.max_deviation &&
         changed.max_speed && changed.max_speed == now.max_speed &&
         norm(changed.velocity) <= *changed.max_speed;
}

}  // namespace

MovingObstacleId add_moving_obstacle(World& world, const MovingObstacle& obstacle) {
  const MovingObstacleId id{world.movers.next_id};
  catch_up(world);
  const MovingObstacle setup = checked(world, obstacle, id);
  const PathWalk start = start_of(world, setup);
  if (!world.kinds) world.kinds.emplace(world.fleet);
  MoverColumns movers = world.movers;
  movers.add(setup, start);
  const double sensing_radius = sensing_radius_among(world, movers.setup, name_of(id));
  check_mover_start(world, setup, start, name_of(id));
  adopt(world, std::move(movers), sensing_radius);
  return id;
}

void change_moving_obstacle(World& world, MovingObstacleId id, const MovingObstacle& obstacle) {
  const std::size_t index = world.movers.find(id);
  const MovingObstacle setup = checked(world, obstacle, id);
  PathWalk start = start_of(world, setup);
  const MovingObstacle& now = world.movers.setup[index];
  if (setup.path == now.path) start.next_point = world.movers.next_point[index];
  const bool is_simple = only_moves(now, setup);
  MoverColumns movers = world.movers;
  movers.position[index] = start.position, movers.velocity[index] = start.velocity;
  movers.next_point[index] = start.next_point, movers.setup[index] = setup;
  if (is_simple) return replace(world, std::move(movers));
  movers.look_over();
  if (!world.kinds) world.kinds.emplace(world.fleet);
  const double radius = sensing_radius_among(world, movers.setup, name_of(id));
  adopt(world, std::move(movers), radius);
}

void remove_moving_obstacle(World& world, MovingObstacleId id) {
  const std::size_t index = world.movers.find(id);
  catch_up(world);
  MoverColumns movers = world.movers;
  movers.remove(index);
  adopt(world, std::move(movers), world.sensing_radius);
}

}  // namespace avo::inline sim
