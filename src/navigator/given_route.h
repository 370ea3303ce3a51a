// SPDX-License-Identifier: Apache-2.0
// A route that is given: by another planner, or from stage to stage.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "guidance/follower.h"
#include "navigator/rounded_route.h"

namespace avo::inline navigator {

/// A place of the route at which the robot comes to rest.
struct Stop {
  double along = 0.0;  // m, from the start
  double wait = 0.0;   // s; infinite: until the host says so
};

/// Where a stage of the host is.
struct Mark {
  double along = 0.0;     // m, from the start
  std::size_t stops = 0;  // number of stops up to there, with its own
};

/// What does not change while the robot follows the route.
struct GivenRoute {
  RoundedRoute rounded;
  std::vector<Vec2> points;  // m
  std::vector<Stop> stops;   // ascending; the last one is the end
  std::vector<Mark> marks;   // ascending
  CornerGraph graph;         // of the points, for the rules at passages
  std::shared_ptr<const PathMap> map;
};

/// A point of a route that is to be given.
struct Waypoint {
  Vec2 place = {};         // m
  double wait = 0.0;       // s, see Stop; 0: the robot passes it
  std::size_t stages = 0;  // number of stages that the host has named there
};

/// A point that repeats the one before it, within kSmallest, is left out. walls: of the map.
std::shared_ptr<const GivenRoute> given_route(std::span<const Waypoint> points,
                                              const Rounding& rounding, double radius,
                                              std::span<const Wall> walls);

/// The same of pieces from a pose on.
std::shared_ptr<const GivenRoute> given_route(const Pose& from, std::span<const PathPiece> pieces,
                                              double radius, std::span<const Wall> walls);

/// How far a robot is on its given route.
struct OnRoute {
  std::shared_ptr<const GivenRoute> route = {};
  double along = 0.0;               // m, from the start
  std::size_t stop = 0;             // index of the next stop
  double waited = 0.0;              // s, there
  bool has_begun = false;           // the robot has its place on the route
  std::optional<Travel> back = {};  // around the walls between the robot and the route
  Vec2 back_to = {};                // m, of the route

  [[nodiscard]] bool is_given() const { return route != nullptr; }
  [[nodiscard]] const Stop& next() const { return route->stops[stop]; }
  [[nodiscard]] bool is_last() const { return stop + 1 == route->stops.size(); }
  [[nodiscard]] Vec2 end() const { return route->points.back(); }
};

/// How a robot follows its route.
struct Pursuit {
  Cornering cornering = {};
  double least_ahead = 0.0;  // m, at least so far ahead is the point at which it aims
  // unit, in which the robot comes to the end of its route; 0: any
  Vec2 end_direction = {};
};

/// The heading of a robot with that velocity, m/s. It updates how far the robot is.
Headings follow_given(Routes& routes, const Claims& claims, const Follower& robot, Vec2 velocity,
                      const Pursuit& pursuit, OnRoute& on);

/// The route as passages know it: straight pieces from its next point on.
Travel as_travel(const OnRoute& on);

/// Returns how many of the route's stages are behind the robot; the last one never is. A stage with
/// a wait is behind the robot once the wait has ended.
std::size_t stages_passed(const OnRoute& on);

/// m, of the route that is left, from the robot's place.
double left_of(const OnRoute& on, Vec2 position);

}  // namespace avo::inline navigator
