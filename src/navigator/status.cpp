// SPDX-License-Identifier: Apache-2.0
// How far a navigator's robot is: what is left of its route, and whether it makes progress.
#include <cmath>

#include "core/plane.h"
#include "navigator/state.h"
#include "robots/model.h"

namespace avo::inline navigator {
namespace {

// Goes on from a stage where the robot has rested for long enough.
bool is_waiting(const NavigatorState& state, Memory& memory, const Robot& robot, double time) {
  OnRoute& on = memory.on;
  if (!on.is_given() || on.is_last()) return false;
  const double tolerance =
      state.options.xy_goal_tolerance.value_or(state.planner.options().arrival_distance);
  const double along = on.next().along;
  const bool is_there = along - on.along <= tolerance &&
                        norm(on.route->rounded.at(along) - robot.position) <= tolerance;
  if (!is_there || (on.waited == 0.0 && robot.velocity != Vec2{})) return false;
  on.waited += time;
  if (on.waited <= on.next().wait) return true;
  on.along = on.next().along;
  ++on.stop, on.waited = 0.0;
  return false;
}

void note_progress(const NavigatorOptions& options, Vec2 position, double time, bool is_under_way,
                   Progress& progress) {
  const bool moves = !progress.from || !is_under_way ||
                     norm(position - *progress.from) > options.required_movement_radius;
  if (moves)
    progress.from = position, progress.time = 0.0;
  else
    progress.time += time;
}

// Returns whether the robot has come to the end of its route. A route may pass its end before.
bool is_at_end(const NavigatorState& state, const Memory& memory, const Robot& robot,
               double tolerance) {
  if (!memory.on.is_given()) return true;
  if (!memory.on.is_last()) return false;
  if (state.mission.kind == Mission::Kind::goal) return true;
  const double off = norm(led_point(robot) - place_of(robot));
  return memory.on.route->rounded.length() - memory.on.along <= tolerance + off;
}

}  // namespace

Simulation::Route route_left(const NavigatorState& state, const Memory& memory,
                             const Robot& robot) {
  if (!state.mission.has_goal()) return {0.0, robot.position};
  const Vec2 goal = state.mission.goal();
  if (!memory.on.is_given()) {
    if (memory.routes->empty()) return {norm(goal - robot.position), goal};
    return rest_of_route(memory.travel, robot.position, goal);
  }
  const bool is_short = memory.travel.ends == RouteEnd::short_of;
  return {is_short ? kInfinity : left_of(memory.on, robot.position), memory.on.end(),
          is_short ? norm(goal - memory.travel.place) : 0.0};
}

bool is_reached(const NavigatorState& state, const Memory& memory, const Robot& robot) {
  const Mission& mission = state.mission;
  if (!mission.has_goal()) return false;
  const Vec2 p = place_of(robot), goal = mission.goal();
  const bool is_beside = memory.travel.ends == RouteEnd::beside;
  const double tolerance =
      state.options.xy_goal_tolerance.value_or(state.planner.options().arrival_distance);
  const double slack = is_beside ? kBesideSlack * robot.radius : 0.0;
  const bool is_turned =
      is_holonomic(robot.model) || !mission.heading ||
      std::abs(wrapped(robot.heading - *mission.heading)) <= state.options.yaw_goal_tolerance;
  if (is_at_end(state, memory, robot, tolerance + slack) && norm(goal - p) <= tolerance + slack &&
      is_turned && memory.routes->is_in_sight(p, is_beside ? memory.travel.place : goal))
    return true;
  if (memory.on.is_given() && !memory.on.is_last()) return false;
  return memory.travel.ends != RouteEnd::short_of && memory.has_stood && robot.velocity == Vec2{};
}

NavigatorStatus status_of(NavigatorState& state, const Robot& robot, double time) {
  Memory& memory = state.memory;
  const bool has_goal = state.mission.has_goal();
  const bool reached = is_reached(state, memory, robot);
  const bool waits = has_goal && !reached && is_waiting(state, memory, robot, time);
  note_progress(state.options, robot.position, time, has_goal && !reached && !waits,
                memory.progress);
  if (!has_goal) return NavigatorStatus::idle;
  if (reached) return NavigatorStatus::reached;
  if (waits) return NavigatorStatus::waiting;
  if (memory.travel.ends == RouteEnd::short_of) return NavigatorStatus::unreachable;
  return memory.progress.time >= state.options.movement_time_allowance ? NavigatorStatus::stuck
                                                                       : NavigatorStatus::under_way;
}

}  // namespace avo::inline navigator
