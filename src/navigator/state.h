// SPDX-License-Identifier: Apache-2.0
// What a navigator knows and remembers.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/execution.h"
#include "avo/navigator.h"
#include "guidance/at_goal.h"
#include "guidance/wall_needs.h"
#include "navigator/given_route.h"
#include "robots/motion.h"

namespace avo::inline navigator {

/// Where the robot is sent.
struct Mission {
  enum class Kind : std::uint8_t { none, goal, route, stages };
  Kind kind = Kind::none;
  std::vector<Stage> stages = {};  // of a goal, the goal alone; of a route, its points
  std::optional<double> heading = {};
  bool is_shared = false;
  friend bool operator==(const Mission&, const Mission&) = default;

  [[nodiscard]] bool has_goal() const { return kind != Kind::none; }
  [[nodiscard]] Vec2 goal() const { return stages.back().position; }
};

/// Whether the robot makes progress: see NavigatorOptions::required_movement_radius.
struct Progress {
  std::optional<Vec2> from = {};  // m
  double time = 0.0;              // s, since it was there
};

/// What one robot remembers from cycle to cycle.
struct Memory {
  std::shared_ptr<Routes> routes;  // by the map and the movers at rest
  double passages_for = 0.0;       // m, the radius for which they know the passages
  Detour detour;
  Travel travel;            // to the goal of a mission of kind goal
  OnRoute on;               // of the other kinds
  bool is_planned = false;  // whether one of both has been made for the mission
  double radius = 0.0;      // m, for which it has been made
  std::size_t passed = 0;   // stages that are behind the robot, where the route is made anew
  bool has_stood = false;   // see Seeker::has_stood
  double taken = 0.0;       // s, for which others have been seen at rest on the goal
  std::int64_t decisions = 0;
  std::optional<double> time;  // s, of the last one
  Progress progress;
};

/// What one cycle finds before it plans.
struct SetOut {
  Robot robot;                  // with its preferred velocity and distance to the goal
  std::span<const Wall> walls;  // near it
  Guide guide = Guide::route;
  bool stops = false;  // it brakes until it stands, see AtSharedGoal
  std::optional<Simulation::Wait> wait = {};
};

/// All of it.
struct NavigatorState {
  NavigatorOptions options;
  Planner planner;
  StepResponse response;
  std::vector<Wall> map;
  WallGrid grid;
  std::optional<WallNeeds> needs;  // that the grid serves
  Mission mission;
  Memory memory;
  Claims claims;
  Occupied occupied;
  std::vector<Wall> resting;  // scratch: the movers at rest
  PlanWorkspace workspace;
  std::optional<ReferenceTracker> tracker;  // of a base that does not execute exactly
  std::optional<double> followed;           // s, when it was commanded last

  NavigatorState(const NavigatorOptions& options, std::vector<Wall> walls);
  /// Routes are made anew at the next step.
  void take_map(std::vector<Wall> walls);
  void begin(Mission next);
};

/// Everything that step() does before it plans. time_step: s, since the last decision.
SetOut set_out(NavigatorState& state, Memory& memory, const Robot& robot,
               std::span<const Neighbor> neighbors, double time_step);

/// The rest of the route of a robot with that mission.
Simulation::Route route_left(const NavigatorState& state, const Memory& memory, const Robot& robot);

/// Returns whether the goal is reached, see NavigatorStatus.
bool is_reached(const NavigatorState& state, const Memory& memory, const Robot& robot);

/// Notes where the robot is, `time` s after the last cycle.
NavigatorStatus status_of(NavigatorState& state, const Robot& robot, double time);

/// See Navigator::explain().
Explanation explanation_of(NavigatorState& state, const Robot& robot,
                           std::span<const Neighbor> neighbors);

/// m, the place of a robot that its goal is about: of a car the middle of its rear axle.
inline Vec2 place_of(const Robot& robot) {
  return robot.position - disc_center(robot.model, {}, robot.heading);
}

/// m, the point of a robot that follows a given route: its position where it moves along its
/// heading, and the center of its disc otherwise.
inline Vec2 led_point(const Robot& robot) {
  return moves_along_heading(robot.model) ? place_of(robot) : robot.position;
}

}  // namespace avo::inline navigator
