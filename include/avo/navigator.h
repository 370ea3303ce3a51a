// SPDX-License-Identifier: Apache-2.0
// One robot on board: its route, the right of way at passages, its goal, and at each cycle the
// decision of Planner::plan() (docs/on_board.md).
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/execution.h"
#include "avo/explanation.h"
#include "avo/export.h"
#include "avo/planner.h"
#include "avo/scenario.h"
#include "avo/simulation.h"

namespace avo {

/// Options of a navigator. Robots of a fleet agree on those that a Planner shares, on the map, and
/// on fleet_radii.
struct NavigatorOptions {
  PlannerOptions planner = {};
  std::optional<double> preferred_speed = {};  ///< m/s, >= 0; unset: Robot::max_speed
  /// Its number among the robots. It breaks ties, so consecutive robots have consecutive numbers
  /// (docs/arrival.md, rule 1). Sentences name the robot by it.
  RobotId id = {};
  LayerSet layers{1};      ///< that it is in: of the map it heeds the obstacles of these layers
  bool navigation = true;  ///< routes lead around the obstacles of the map
  RightOfWay right_of_way = RightOfWay::seen;  ///< at passages, with navigation
  /// m, > 0: the radii of all robots of the fleet. Robots that know the same radii find the same
  /// passages. Empty: the radius of this robot.
  std::vector<double> fleet_radii = {};
  /// m, > 0: the goal is reached within this distance; unset: PlannerOptions::arrival_distance
  std::optional<double> xy_goal_tolerance = {};
  double yaw_goal_tolerance = 0.25;  ///< rad, > 0: and within this angle of the goal's heading
  /// m, > 0: the robot makes progress if it moves that far within movement_time_allowance
  double required_movement_radius = 0.5;
  double movement_time_allowance = 10.0;  ///< s, > 0
  /// m, > 0: the corners of a given route are cut by as much, and most robots follow it within this
  /// distance, except where others stand there. Unset: 0.3 of the robot's radius
  std::optional<double> route_tolerance = {};
  /// How the base executes commands; unset: exactly. If set, `robot` of step() is the measured
  /// body. The decision is about its reference, and NavigatorDecision::command is for the base
  /// (docs/on_board.md, "Bases that do not execute exactly"). For holonomic robots and differential
  /// drives, with held motion.
  std::optional<ExecutionModel> execution = {};
};

/// A place on a mission: the robot passes it, or it rests there for a while.
struct Stage {
  Vec2 position = {};  ///< m
  /// s, >= 0: so long it rests there; 0: it passes. Infinite: until Navigator::go_on()
  double wait = 0.0;
  friend bool operator==(const Stage&, const Stage&) = default;
};

/// What a navigator is about.
enum class NavigatorStatus : std::uint8_t {
  idle,         ///< it has no goal: it stays where it is, and lets others pass
  under_way,    ///< it moves on its route
  waiting,      ///< at a stage
  reached,      ///< the goal is within the tolerances, or as near as others at rest leave room
  stuck,        ///< moving to its goal, and without progress for movement_time_allowance
  unreachable,  ///< the map leaves no route: it goes to the nearest place that it can reach
};
AVO_API const char* to_string(NavigatorStatus status);

/// The neighbor for which a navigator waits at a passage of one lane: see Simulation::Wait.
struct NavigatorWait {
  Vec2 passage = {};    ///< m: the middle of its axis
  int neighbor = 0;     ///< index into the neighbors given
  bool inside = false;  ///< whether that neighbor is in the passage
  Vec2 a = {}, b = {};  ///< m: the two sides of the passage where it is narrowest
};

/// One decision of a navigator.
struct NavigatorDecision {
  Plan plan;  ///< send it to the base, as docs/on_board.md says
  /// Send this in place of the plan, where NavigatorOptions::execution is set; else unset.
  std::optional<BaseCommand> command = {};
  NavigatorStatus status = NavigatorStatus::idle;
  Guide guide = Guide::route;    ///< what the preferred velocity leads to
  Vec2 preferred_velocity = {};  ///< m/s, given to the planner
  /// m, of the route that is left; 0 without a goal. From its end to the goal it may be
  /// distance_left farther.
  double route_left = 0.0;
  /// m, from the end of the route to the goal: 0, unless the map keeps the robot from its goal
  double distance_left = 0.0;
  double stopping_distance = 0.0;  ///< m, that it needs to brake from its present velocity
  /// s, since it last made progress; 0 while it does not move to a goal
  double without_progress = 0.0;
  std::optional<NavigatorWait> wait = {};  ///< where it waits at a passage
};

/// Guides one robot, by the functions by which a Simulation guides all. It needs no goals of
/// others, and sends nothing to them. Use one per robot, and one thread at a time.
class AVO_API Navigator {
 public:
  /// obstacles: the map; none: the robot knows no walls. Throws Error on options or obstacles out
  /// of range.
  explicit Navigator(const NavigatorOptions& options, std::vector<StaticObstacle> obstacles = {});
  ~Navigator();
  Navigator(Navigator&&) noexcept;
  Navigator& operator=(Navigator&&) noexcept;

  /// Sets the goal, m, and the heading in which the robot is to stand there, rad. A heading is for
  /// robots with wheels. A route around the map leads there. Others may have the same goal:
  /// is_shared makes the robot brake within arrival_distance of it (docs/arrival.md, rule 4). The
  /// goal that it has already changes nothing. Throws Error on values out of range.
  void set_goal(Vec2 goal, std::optional<double> heading = {}, bool is_shared = false);
  /// Follows a route of another planner: straight pieces from point to point, m. The robot
  /// comes to rest at the last point, in that heading. Throws Error on values out of range, and on
  /// fewer than two points.
  void set_route(std::vector<Vec2> points, std::optional<double> heading = {});
  /// Goes by the map from stage to stage, and comes to rest at the last one. Throws Error on values
  /// out of range, and on no stage.
  void set_stages(std::vector<Stage> stages, std::optional<double> heading = {});
  void go_on();       ///< ends the wait at a stage
  void clear_goal();  ///< the robot has no goal any more
  /// Another map: a door has closed or opened, or the robot has changed to other layers, as in a
  /// lift. Without `layers` it stays in its layers. The robot keeps its goal. Throws Error as the
  /// constructor does; changes nothing then.
  void set_obstacles(std::vector<StaticObstacle> obstacles, std::optional<LayerSet> layers = {});

  /// One cycle: to be called every time_step, at the times at which all robots decide.
  /// preferred_velocity and distance_to_goal of `robot` are not read. Its limits may change from
  /// cycle to cycle. time: s, of any clock that does not go back. Where a value is out of range,
  /// the plan says invalid_input, and the robot brakes. Throws Error on an airplane, and on a car
  /// where NavigatorOptions::execution is set.
  NavigatorDecision step(const Robot& robot, std::span<const Neighbor> neighbors, double time);

  /// The decision that step() would make now, with its reasons in words. Neighbors are named by
  /// their positions in the list: "robot 2", or "moving obstacle 2" where it moves on. Changes
  /// nothing.
  [[nodiscard]] Explanation explain(const Robot& robot, std::span<const Neighbor> neighbors) const;

  /// m: the corners of the route that is left, to its end; empty without a goal, or before the
  /// first step.
  [[nodiscard]] std::vector<Vec2> route() const;
  /// What the robot remembers, see Detour.
  [[nodiscard]] const Detour& detour() const;
  [[nodiscard]] const Planner& planner() const;
  [[nodiscard]] const NavigatorOptions& options() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// m, between centers: how far a robot with a planner of these options has to sense such others.
/// Nothing farther off changes what its certificate admits, nor what its rules for arriving do
/// (docs/scenes.md, "How far robots sense"). Declared errors and clocks of their own count. Radius,
/// limits, model and priority of all robots count. has_map: with passages, where robots wait for
/// each other. Throws Error on values out of range.
AVO_API double sensing_range(const PlannerOptions& options, const Robot& robot,
                             std::span<const Robot> others, bool has_map = false);

/// m, from the position of a robot with a planner of these options: walls with a surface farther
/// off change no decision. Its radius, limits, model and velocity count. Throws Error on values out
/// of range.
AVO_API double wall_range(const PlannerOptions& options, const Robot& robot);

}  // namespace avo
