// SPDX-License-Identifier: Apache-2.0
#include "space/mover_edits.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "core/ranges.h"
#include "space/mover_checks.h"

namespace avo::space {
namespace {

std::string name_of(MovingObstacleId obstacle) {
  return "moving obstacle " + std::to_string(obstacle.value);
}

// What the fleet has with other moving obstacles.
struct Edited {
  std::vector<MovingObstacle> obstacles;
  MoverColumns movers;
  PastStates past;
};

Edited copy_of(const SpaceFleet& fleet) {
  return {fleet.scenario.moving_obstacles, fleet.movers, fleet.senses.movers};
}

bool is_certified(const SpaceFleet& fleet) {
  return fleet.options.certificate != Certificate::none;
}

bool covers(const SensingError& declared, const SensingError& needed) {
  constexpr double kRounded = 1.0 + 1e-9;
  return needed.position <= kRounded * declared.position &&
         needed.velocity <= kRounded * declared.velocity;
}

// Adopts what is edited, with the sensing radius and the options that it needs.
void adopt(SpaceFleet& fleet, Edited edited, const std::string& name) {
  Scenario scene = fleet.scenario;
  const SensingError& declared = fleet.options.sensing_error;
  const bool was_covered = covers(declared, declared_error(scene));
  scene.moving_obstacles = edited.obstacles;
  if (is_certified(fleet) && was_covered && !covers(declared, declared_error(scene)))
    refuse(name, "a max_deviation beyond the sensing_error that all have declared",
           "less, or in the scene from the start");
  if (is_certified(fleet) && scene.sensing_radius && !fleet.robots.empty()) {
    const double needed = mover_range(scene);
    if (needed > fleet.sensing_radius && needed > mover_range(fleet.scenario))
      throw Error(name + ": has to be seen from " + text(needed) + " m, sensing_radius is " +
                  text(fleet.sensing_radius) + " m");
  }
  const double radius = std::max(fleet.sensing_radius, sensing_radius_of(scene));
  SpaceCells cells(radius);
  const double wall_range = planner_options(scene).wall_range;

  fleet.scenario.moving_obstacles = std::move(edited.obstacles);
  std::swap(fleet.movers, edited.movers);
  std::swap(fleet.senses.movers, edited.past);
  if (radius > fleet.sensing_radius) std::swap(fleet.cells, cells);
  fleet.sensing_radius = fleet.senses.radius = radius;
  fleet.options.wall_range = std::max(fleet.options.wall_range, wall_range);
  for (Trip& trip : fleet.trips) trip.box_range = std::max(trip.box_range, wall_range);
}

}  // namespace

MovingObstacleId add_moving_obstacle(SpaceFleet& fleet, const MovingObstacle& obstacle) {
  const MovingObstacleId id{fleet.movers.next_id};
  const std::string name = name_of(id);
  check_moving_obstacle(obstacle, name + ": ");
  Edited edited = copy_of(fleet);
  edited.obstacles.push_back(obstacle);
  edited.movers.add(fleet.steps);
  edited.movers.move_to(fleet.steps, edited.obstacles, fleet.scenario.time_step);
  edited.movers.begin(edited.movers.now.size() - 1);
  edited.past.add(fleet.steps);
  if (is_certified(fleet))
    check_mover_starts(fleet.robots, {&edited.movers.now.back(), 1}, {&id, 1}, fleet.law);
  adopt(fleet, std::move(edited), name);
  return id;
}

void change_moving_obstacle(SpaceFleet& fleet, MovingObstacleId id,
                            const MovingObstacle& obstacle) {
  const std::size_t k = fleet.movers.find(id);
  check_moving_obstacle(obstacle, name_of(id) + ": ");
  Edited edited = copy_of(fleet);
  edited.obstacles[k] = obstacle;
  edited.movers.since[k] = fleet.steps;
  edited.movers.move_to(fleet.steps, edited.obstacles, fleet.scenario.time_step);
  edited.movers.begin(k);
  adopt(fleet, std::move(edited), name_of(id));
}

void remove_moving_obstacle(SpaceFleet& fleet, MovingObstacleId id) {
  const std::size_t k = fleet.movers.find(id);
  Edited edited = copy_of(fleet);
  edited.obstacles.erase(edited.obstacles.begin() + static_cast<std::ptrdiff_t>(k));
  edited.movers.remove(k);
  edited.past.remove(k);
  adopt(fleet, std::move(edited), name_of(id));
}

}  // namespace avo::space
