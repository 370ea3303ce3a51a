// SPDX-License-Identifier: Apache-2.0
// Converts values of the C interface to those of C++, and back.
#pragma once
#include <bit>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/scenario.h"
#include "avo/teams.h"
#include "definitions.h"

namespace avo_c {

inline avo::Vec2 from_c(avo_vec2 v) {
  return {v.x, v.y};
}
inline avo_vec2 to_c(avo::Vec2 v) {
  return {v.x, v.y};
}

/// An array of the caller, which has that name.
inline std::vector<avo::Vec2> points_of(const avo_vec2* points, std::size_t count,
                                        const std::string& name) {
  require_array(points, count, name.c_str());
  std::vector<avo::Vec2> result;
  result.reserve(count);
  for (std::size_t k = 0; k < count; ++k) result.push_back(from_c(points[k]));
  return result;
}

/// The overrides of a scene, an argument of that name.
inline std::vector<std::string> words_of(const char* const* overrides, std::size_t count) {
  require_array(overrides, count, "overrides");
  std::vector<std::string> words;
  for (std::size_t k = 0; k < count; ++k) words.emplace_back(&at(overrides[k], "overrides"));
  return words;
}

/// For numbers that must not be 0: 0 stands for none.
inline std::optional<double> unless_zero(double value) {
  return value == 0.0 ? std::nullopt : std::optional(value);
}
inline std::optional<int> unless_zero(std::int32_t value) {
  return value == 0 ? std::nullopt : std::optional<int>(value);
}

/// The motion model of a definition. Def: avo_robot or avo_robot_def.
template <typename Def>
avo::MotionModel model_of(const Def& def, const Where& where);
template <typename Def>
void set_model(const avo::MotionModel& model, Def& def);

avo::PlannerOptions options_of(const avo_planner_def& def);
avo::Robot robot_of(const avo_robot& robot);
avo::Robot read_robot(const avo_robot* robot);
/// The neighbors of an argument of that name, in memory of this thread until the next call.
std::span<const avo::Neighbor> neighbors_of(const avo_neighbor* neighbors, std::size_t count,
                                            const char* list);
std::vector<avo::StaticObstacle> obstacles_of(const avo_obstacle_def* obstacles, std::size_t count);
avo::Neighbor neighbor_of(const avo_neighbor& neighbor, const Where& where);

inline avo::Footprint from_c(const avo_footprint& footprint) {
  return {footprint.discs, footprint.radius, footprint.first, footprint.spacing};
}
inline avo_footprint to_c(const avo::Footprint& footprint) {
  return {footprint.radius, footprint.first, footprint.spacing, footprint.discs};
}
/// None where the id is null; throws Failure where it is stale.
const avo::Trajectory* trajectory_of(avo_trajectory_id trajectory);

avo::RobotSetup setup_of(const avo_robot_def& def, const Where& where);
avo_robot_def def_of(const avo::RobotSetup& setup);

avo::MovingObstacle obstacle_of(const avo_moving_obstacle_def& def, const Where& where);
/// A definition that points to lists of the obstacle.
avo_moving_obstacle_def def_of(const avo::MovingObstacle& obstacle);
avo::StaticObstacle obstacle_of(const avo_obstacle_def& def, const Where& where);
/// A definition that points to the obstacle and to its `chains`, which are filled if empty.
avo_obstacle_def def_of(const avo::StaticObstacle& obstacle, std::vector<avo_chain>& chains);

avo::Team team_of(const avo_team_def& def, const Where& where);
/// A definition that points to the team and to `robots`, which it fills.
avo_team_def def_of(const avo::Team& team, std::vector<avo_robot_id>& robots);

avo::SensingModel sensing_of(const avo_sensing_model& sensing);
avo::LocalizationNoise localization_of(const avo_localization_noise& noise);
avo_localization_noise to_c(const avo::LocalizationNoise& noise);
avo_sensing_model to_c(const avo::SensingModel& sensing);
/// None where both are NaN.
std::optional<avo::SensingError> error_of(const avo_sensing_error& error);
avo_sensing_error to_c(const std::optional<avo::SensingError>& error);

/// Settings, robots, teams and obstacles; without the threads.
avo::Scenario scenario_of(const avo_simulation_def& def);

/// A scene's settings, without robots and obstacles.
avo_simulation_def settings_of(const avo::Scenario& scenario);

}  // namespace avo_c
