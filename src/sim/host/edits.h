// SPDX-License-Identifier: Apache-2.0
// Changes by users between steps: robots, goals, obstacles. Each function throws Error on
// bad input, and changes nothing where it throws.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline sim {

struct World;

RobotId add_robot(World& world, const RobotSetup& setup);
void remove_robot(World& world, RobotId robot);
void set_goal(World& world, RobotId robot, Vec2 goal);
void move_robot(World& world, RobotId robot, Vec2 position);
void set_goals(World& world, std::span<const RobotId> robots, std::span<const Vec2> goals);
void set_preferred_velocities(World& world, std::span<const RobotId> robots,
                              std::span<const Vec2> velocities);
std::vector<RobotId> add_robots(World& world, std::span<const RobotSetup> setups);
void remove_robots(World& world, std::span<const RobotId> robots);
/// may_start: where it is now is not checked.
void change_robot(World& world, RobotId robot, const RobotSetup& setup, bool may_start = false);
/// Adds a robot to all data that have an entry for each one, except the routes. If the function
/// throws, nothing has changed.
void join(World& world, const RobotSetup& setup, RobotId robot);
/// Adds a parked robot with checked values, and its wall.
void add_parked(World& world, const RobotSetup& setup, RobotId robot);
/// Removes the wall of a parked robot.
void take_away_parked(World& world, std::size_t slot);
/// Parks a robot at rest where it is, or sets a parked robot free there. changed: its setup then.
void park_or_free(World& world, std::size_t slot, RobotSetup changed);
void set_preferred_velocity(World& world, RobotId robot, std::optional<Vec2> velocity);
/// Returns whether the robot has decided until now, and does not any more.
bool set_velocity(World& world, RobotId robot, std::optional<Vec2> velocity);
MovingObstacleId add_moving_obstacle(World& world, const MovingObstacle& obstacle);
void change_moving_obstacle(World& world, MovingObstacleId id, const MovingObstacle& obstacle);
void remove_moving_obstacle(World& world, MovingObstacleId id);
ObstacleId add_obstacle(World& world, const StaticObstacle& obstacle);
void remove_obstacle(World& world, ObstacleId obstacle);

/// Plans new routes for all robots, where movers have come to rest, or resting movers move again.
void go_around_resting(World& world);

}  // namespace avo::inline sim
