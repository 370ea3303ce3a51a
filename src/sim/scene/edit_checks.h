// SPDX-License-Identifier: Apache-2.0
// What refuses an edit: each of these throws Error, which calls robot or obstacle by its name.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "avo/simulation.h"

namespace avo::inline sim {

struct World;

std::string name_of(RobotId robot);
std::string name_of(ObstacleId obstacle);

/// The world's settings for a scene of these robots.
Scenario settings_for(const World& world, std::span<const RobotSetup> robots);

/// validate(), of a scene with one robot or obstacle at `place`.
void validate_as(const Scenario& scene, std::string_view place, const std::string& name);
/// Values that no robot may have; among_walls: beside an obstacle.
void check_values(const World& world, const RobotSetup& setup, RobotId robot, bool among_walls);
/// A robot that comes beside those that are there.
void check_newcomer(const World& world, const RobotSetup& setup, RobotId robot);
/// Before check_start(): makes it fast where there have been others since the last step.
void look_around_starts(World& world);
/// A start that breaks what the certificate assumes, unless the scene allows for that.
void check_start(const World& world, const RobotSetup& setup, RobotId robot);
/// m: how far robots sense once this one has come.
double sensing_radius_with(const World& world, const RobotSetup& setup);
/// Where somebody could not keep clear of what does not move from now on.
void check_newly_static(const World& world, const StaticObstacle& obstacle,
                        const std::string& name);

/// A robot as it is now; where it is matters to nobody whose values are checked.
RobotSetup standing(const World& world, std::size_t slot);

}  // namespace avo::inline sim
