// SPDX-License-Identifier: Apache-2.0
#include "navigator/plan_routes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "core/elementary.h"
#include "core/plane.h"
#include "navigator/simplified_route.h"
#include "robots/model.h"

namespace avo::inline navigator {
namespace {

constexpr double kTolerance = 0.3;   // radii: corners are cut by as much, see route_tolerance
constexpr double kSimplified = 0.5;  // of the tolerance, for points that are left out
constexpr double kWider = 1.3;       // times the turning circle: arcs of a car that it can drive
constexpr double kLeastAhead = 1.0;  // tolerances
constexpr double kAheadOfCar = 1.2;  // turning circles
// The last piece before a goal with a heading, on which the robot turns into it: radii, turning
// circles, offsets of a drive.
constexpr double kRunInRadii = 3.0, kRunInCircles = 2.5, kRunInOffsets = 5.0;
constexpr double kRunInOfCar = 1.5;  // turning circles, at the end of a path of arcs
constexpr double kShortest = 0.25;   // of that, where there is no more room

Rounding rounding_of(const NavigatorState& state, const Robot& robot) {
  return {state.options.route_tolerance.value_or(kTolerance * robot.radius),
          kWider * turning_radius(robot.model)};
}

double run_in_of(const Robot& robot) {
  return std::max({kRunInRadii * robot.radius, kRunInCircles * turning_radius(robot.model),
                   kRunInOffsets * towed_length(robot.model)});
}

// Appends the corners of the route by the map from one place to another.
void append_route(NavigatorState& state, const Robot& robot, Vec2 to, Memory& memory,
                  std::vector<Waypoint>& points) {
  const Vec2 from = points.back().place;
  Travel travel =
      memory.routes->empty()
          ? Travel{}
          : memory.routes->plan(robot.radius, from, to, state.planner.options().arrival_distance);
  for (std::uint32_t at = travel.target; travel.is_known() && at < PathMap::kNothing;
       at = travel.map->after(at))
    points.push_back({travel.graph->points[at]});
  points.push_back({travel.heads_for(to)});
  memory.travel.ends = travel.ends, memory.travel.place = travel.place;
}

bool is_clear(const NavigatorState& state, const Robot& robot, Vec2 from, Vec2 to) {
  const Segment line{from, to};
  return std::all_of(state.map.begin(), state.map.end(), [&](const Wall& wall) {
    return distance(line, {wall.a, wall.b}) > robot.radius + wall.radius;
  });
}

// The place from which the robot runs in straight to its goal; the goal where there is no room.
Vec2 run_in(const NavigatorState& state, const Robot& robot, Vec2 goal, Vec2 direction) {
  const double longest = run_in_of(robot);
  for (double part = 1.0; part >= kShortest; part *= 0.5) {
    const Vec2 from = goal - (part * longest) * direction;
    if (is_clear(state, robot, from, goal)) return from;
  }
  return goal;
}

// The corners of the mission, from the robot on.
std::vector<Waypoint> corners_of(NavigatorState& state, Memory& memory, const Robot& robot) {
  const Mission& mission = state.mission;
  std::vector<Waypoint> points;
  const bool by_map = mission.kind != Mission::Kind::route;
  if (by_map) points.push_back({led_point(robot)});
  for (std::size_t k = memory.passed; k < mission.stages.size(); ++k) {
    const Stage& stage = mission.stages[k];
    Vec2 to = stage.position;
    const bool is_last = k + 1 == mission.stages.size();
    if (is_last && mission.heading) {
      const Vec2 direction = elementary::direction(*mission.heading);
      if (!moves_along_heading(robot.model))
        to = to + disc_center(robot.model, {}, *mission.heading);
      const Vec2 from = run_in(state, robot, to, direction);
      if (by_map && !(from == to)) append_route(state, robot, from, memory, points);
      if (!by_map && !(from == to)) points.push_back({from, 0.0, 1});
    }
    if (by_map && (points.size() == 1 || memory.travel.ends != RouteEnd::short_of))
      append_route(state, robot, to, memory, points);
    else
      points.push_back({to});
    points.back().wait = is_last ? 0.0 : stage.wait, points.back().stages = by_map ? 1 : 0;
    if (memory.travel.ends == RouteEnd::short_of) break;
  }
  return points;
}

// Appends the piece in parts that turn by 30 degrees at most.
void append_parts(const PathPiece& piece, std::vector<PathPiece>& parts) {
  constexpr double kPart = std::numbers::pi / 6.0;
  if (!(piece.length > 0.0)) return;
  const double count = std::max(1.0, std::ceil(std::abs(piece.curvature) * piece.length / kPart));
  for (double k = 0.0; k < count; k += 1.0)
    parts.push_back({piece.curvature, piece.length / count});
}

// The shortest path of a car with bounded curvature from where it stands to its goal in that
// heading, where no wall is near it.
std::shared_ptr<const GivenRoute> path_of_car(const NavigatorState& state, const Robot& robot) {
  const double turning = turning_radius(robot.model);
  const Mission& mission = state.mission;
  if (turning == 0.0 || mission.kind != Mission::Kind::goal) return nullptr;
  const double run_in = kRunInOfCar * turning;
  const Vec2 direction = elementary::direction(*mission.heading);
  const Pose from{led_point(robot), robot.heading};
  std::vector<PathPiece> parts;
  for (const PathPiece& piece :
       dubins_path(from, {mission.goal() - run_in * direction, *mission.heading}, kWider * turning))
    append_parts(piece, parts);
  parts.push_back({0.0, run_in});
  auto route = given_route(from, parts, robot.radius, state.map);
  for (std::size_t k = 0; k + 1 < route->points.size(); ++k)
    if (!is_clear(state, robot, route->points[k], route->points[k + 1])) return nullptr;
  return route;
}

// The route through the corners of the mission. In a route of another planner, the points left out
// and the arcs together keep within the tolerance.
std::shared_ptr<const GivenRoute> route_of(NavigatorState& state, Memory& memory,
                                           const Robot& robot) {
  Rounding rounding = rounding_of(state, robot);
  std::vector<Waypoint> corners = corners_of(state, memory, robot);
  if (state.mission.kind == Mission::Kind::route) {
    SimplifiedRoute simplified = simplified_route(corners, kSimplified * rounding.tolerance);
    corners = std::move(simplified.points);
    rounding.tolerance -= simplified.deviation;
  }
  return given_route(corners, rounding, robot.radius, state.map);
}

// m, from the start: where the robot is on the same route with other cuts of its corners. Each
// place has moved by at most the difference of the lengths.
double same_place(const OnRoute& before, const RoundedRoute& route) {
  const double moved = std::abs(route.length() - before.route->rounded.length());
  const double to = std::min(before.along + moved, route.length());
  const double from = std::min(std::max(before.along - moved, 0.0), to);
  return route.nearest(before.route->rounded.at(before.along), from, to);
}

}  // namespace

RouteRules route_rules_of(const NavigatorOptions& options) {
  return {.routes = options.navigation, .passages = options.right_of_way != RightOfWay::none};
}

void plan_routes(NavigatorState& state, Memory& memory, const Robot& robot) {
  if (memory.is_planned && memory.radius == robot.radius) return;
  memory.is_planned = true, memory.radius = robot.radius;
  const Mission& mission = state.mission;
  if (mission.kind == Mission::Kind::goal && !mission.heading) {
    memory.on = {}, memory.travel = {};
    if (!memory.routes->empty())
      memory.travel = memory.routes->plan(robot.radius, robot.position, mission.goal(),
                                          state.planner.options().arrival_distance);
    return;
  }
  const OnRoute before = std::exchange(memory.on, {});
  memory.travel = {};
  if (mission.kind == Mission::Kind::route) {
    memory.on.route = route_of(state, memory, robot);
    memory.on.has_begun = before.has_begun;
    if (before.has_begun) memory.on.along = same_place(before, memory.on.route->rounded);
    return;
  }
  if (before.is_given()) memory.passed += stages_passed(before);
  memory.on.waited = before.waited;  // the next stop is the same one
  memory.on.has_begun = true;        // the route begins where the robot is
  if (mission.heading) memory.on.route = path_of_car(state, robot);
  if (!memory.on.is_given()) memory.on.route = route_of(state, memory, robot);
}

Vec2 end_of(const Mission& mission, const Memory& memory) {
  return memory.on.is_given() ? memory.on.end() : memory.travel.heads_for(mission.goal());
}

Pursuit pursuit_of(const NavigatorState& state, const Robot& robot) {
  const PlannerOptions& options = state.planner.options();
  const double response = response_time_of(options, robot.max_speed, robot.max_acceleration);
  const double used =
      std::min(robot.max_acceleration, options.comfort_acceleration.value_or(kInfinity));
  return {.cornering = {.acceleration = used,
                        .braking = std::min(planned_braking(robot), used),
                        .lag = 2.0 * response + 0.5 * options.time_step},
          .least_ahead = std::max(kLeastAhead * rounding_of(state, robot).tolerance,
                                  kAheadOfCar * turning_radius(robot.model)),
          .end_direction =
              state.mission.heading ? elementary::direction(*state.mission.heading) : Vec2{}};
}

}  // namespace avo::inline navigator
