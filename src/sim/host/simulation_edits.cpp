// SPDX-License-Identifier: Apache-2.0
// Edits of a simulation: each changes the world, and then forgets the views that it spoils.
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "sim/host/edits.h"
#include "sim/simulation_state.h"

namespace avo {

RobotId Simulation::add_robot(const RobotSetup& setup) {
  const RobotId robot = avo::add_robot(state_->to_change(), setup);
  state_->forget_robots();
  return robot;
}

void Simulation::remove_robot(RobotId robot) {
  avo::remove_robot(state_->to_change(), robot);
  state_->forget_robots();
}

void Simulation::move_robot(RobotId robot, Vec2 position) {
  avo::move_robot(state_->to_change(), robot, position);
  state_->forget_discs();
  state_->forget_views_of(robot);
}

void Simulation::set_goal(RobotId robot, Vec2 goal) {
  avo::set_goal(state_->to_change(), robot, goal);
  state_->forget_views_of(robot);
}

void Simulation::change_robot(RobotId robot, const RobotSetup& setup) {
  avo::change_robot(state_->to_change(), robot, setup);
  state_->forget_robots();
}

std::span<Team> Simulation::teams() {
  return state_->to_change().settings.teams;
}

void Simulation::set_preferred_velocity(RobotId robot, std::optional<Vec2> velocity) {
  avo::set_preferred_velocity(state_->to_change(), robot, velocity);
  state_->forget_views_of(robot);
}

void Simulation::set_velocity(RobotId robot, std::optional<Vec2> velocity) {
  if (avo::set_velocity(state_->to_change(), robot, velocity)) state_->forget_robots();
}

void Simulation::set_goals(std::span<const RobotId> robots, std::span<const Vec2> goals) {
  avo::set_goals(state_->to_change(), robots, goals);
  state_->forget_views();
}

void Simulation::set_preferred_velocities(std::span<const RobotId> robots,
                                          std::span<const Vec2> velocities) {
  avo::set_preferred_velocities(state_->to_change(), robots, velocities);
  state_->forget_views();
}

std::vector<RobotId> Simulation::add_robots(std::span<const RobotSetup> setups) {
  std::vector<RobotId> added = avo::add_robots(state_->to_change(), setups);
  state_->forget_robots();
  return added;
}

void Simulation::remove_robots(std::span<const RobotId> robots) {
  avo::remove_robots(state_->to_change(), robots);
  state_->forget_robots();
}

MovingObstacleId Simulation::add_moving_obstacle(const MovingObstacle& obstacle) {
  const MovingObstacleId id = avo::add_moving_obstacle(state_->to_change(), obstacle);
  state_->forget_discs();
  state_->forget_views();
  return id;
}

void Simulation::change_moving_obstacle(MovingObstacleId id, const MovingObstacle& obstacle) {
  avo::change_moving_obstacle(state_->to_change(), id, obstacle);
  state_->forget_discs();
  state_->forget_views();
}

void Simulation::remove_moving_obstacle(MovingObstacleId id) {
  avo::remove_moving_obstacle(state_->to_change(), id);
  state_->forget_discs();
  state_->forget_views();
}

ObstacleId Simulation::add_obstacle(const StaticObstacle& obstacle) {
  const ObstacleId id = avo::add_obstacle(state_->to_change(), obstacle);
  state_->forget_views();
  state_->nearby.has_walls = false;
  return id;
}

void Simulation::remove_obstacle(ObstacleId obstacle) {
  avo::remove_obstacle(state_->to_change(), obstacle);
  state_->forget_views();
  state_->nearby.has_walls = false;
}

}  // namespace avo
