// SPDX-License-Identifier: Apache-2.0
// Checks that refuse an edit: each throws Error, which names the robot or obstacle.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline sim {

struct World;

std::string name_of(RobotId robot);
std::string name_of(ObstacleId obstacle);
std::string name_of(MovingObstacleId obstacle);
std::string name_of(BodyId body);

/// The world's settings for a scene of these robots.
Scenario settings_for(const World& world, std::span<const RobotSetup> robots);

/// validate() of a scene with one robot or obstacle at `place`.
void validate_as(const Scenario& scene, std::string_view place, const std::string& name);
/// Refuses values that no robot may have; among_walls: beside an obstacle.
void check_values(const World& world, const RobotSetup& setup, RobotId robot, bool among_walls);
/// Checks a robot beside the present ones, wherever it starts; its own kind is not among theirs.
void check_company(const World& world, const RobotSetup& setup, RobotId robot);
/// Checks a robot that is added to the present ones.
void check_newcomer(const World& world, const RobotSetup& setup, RobotId robot);
/// Call it before check_start(): it makes that fast if other robots were added since the last step.
void look_around_starts(World& world);
/// Refuses a start that breaks the assumptions of the certificate, unless the scene allows it.
void check_start(const World& world, const RobotSetup& setup, RobotId robot);
/// Returns whether a robot in motion would not be able to keep clear of this robot, which rests.
bool is_in_the_way(World& world, const RobotSetup& setup, RobotId robot);
/// Refuses a moving obstacle of which some robot could not keep clear, unless the scene allows it.
void check_mover_start(const World& world, const MovingObstacle& obstacle, const PathWalk& start,
                       const std::string& name);
/// m: the sensing radius among these moving obstacles. Refuses obstacles that robots would not see
/// in time, or that move otherwise than the declared error covers.
double sensing_radius_among(const World& world, const std::vector<MovingObstacle>& movers,
                            const std::string& name);
/// m: the sensing radius after this robot has come.
double sensing_radius_with(const World& world, const RobotSetup& setup);
/// Refuses an obstacle if a robot could not keep clear of what does not move from now on. own: the
/// robot that becomes it, if there is one.
void check_newly_static(const World& world, const StaticObstacle& obstacle, const std::string& name,
                        std::optional<RobotId> own = {});

/// The setup of a robot in its present state; its place does not matter for the checks of values.
RobotSetup standing(const World& world, std::size_t slot);

}  // namespace avo::inline sim
