// SPDX-License-Identifier: Apache-2.0
#include "space/routes/route.h"

#include <algorithm>
#include <cmath>

#include "space/own_space.h"
#include "space/routes/tighten.h"

namespace avo::space {
namespace {

constexpr double kCarried = 0.3;      // radii that others may carry a robot off its route at a bend
constexpr double kBraking = 1.6;      // twice the part of its braking that it plans with
constexpr double kCutsCorners = 0.5;  // of the room of routes, that a robot keeps on its way
constexpr double kSlidesWithin = 6.0;  // radii: nearer to a bend it looks round the bend
constexpr double kAtBend = 0.5;        // radii: there it has to see past the bend
constexpr int kBisections = 5;
constexpr int kGoesBack = 3;  // bends

// The robot's place, and what it keeps from boxes on its way.
RoutePoint start_of(const Solids& solids, Vec3 position, double radius) {
  return {position, room_at(solids, position, radius + kCutsCorners * kRouteRoom)};
}

// |sin φ| of the turn from one way to the next, 1 beyond 90 degrees.
double turn_of(Vec3 a, Vec3 b) {
  const double lengths = norm(a) * norm(b);
  if (!(lengths > 0.0)) return 0.0;
  return dot(a, b) <= 0.0 ? 1.0 : norm(cross(a, b)) / lengths;
}

// The farthest place of the leg behind the next bend that the robot sees.
RoutePoint past_bend(const Solids& solids, const RoutePoint& start, const RoutePoint& bend,
                     const RoutePoint& next) {
  const auto between = [&](double part) {
    return RoutePoint{bend.place + part * (next.place - bend.place),
                      std::min(bend.room, next.room)};
  };
  if (!is_way(solids, start, bend)) return bend;
  double seen = 0.0, hidden = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double part = 0.5 * (seen + hidden);
    (is_way(solids, start, between(part)) ? seen : hidden) = part;
  }
  return between(seen);
}

// m/s: from which the robot can make all turns ahead (docs/navigation.md, "Speed").
double speed_before_turns(const Robot& robot, const std::vector<RoutePoint>& points) {
  const double acceleration = robot.max_acceleration * std::min(1.0, robot.vertical);
  const double carried = 2.0 * acceleration * kCarried * robot.radius;
  double least = Bounds::kFar, left = 0.0;  // m²/s², m
  Vec3 from = robot.position, at = points.front().place;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec3 next = points[k].place;
    left += norm(at - from);
    const double turn = turn_of(at - from, next - at);
    if (turn > 0.0)
      least = std::min(least, carried / (turn * turn) + kBraking * acceleration * left);
    from = at, at = next;
  }
  return std::sqrt(least);
}

// The number of the last point of the route that the robot sees, or 0.
std::size_t seen_from(const Solids& solids, const RoutePoint& start,
                      const std::vector<RoutePoint>& points) {
  std::size_t seen = 0;
  while (seen + 1 < points.size() && is_way(solids, start, points[seen + 1])) ++seen;
  return seen;
}

void move_on(Route& route, const RoutePoint& next) {
  if (!route.is_moved) route.passed.push_back(route.points.front());
  route.points.front() = next;
  route.is_moved = true;
}

void go_back(Route& route) {
  const RoutePoint last = route.passed.back();
  if (route.is_moved)
    route.points.front() = last;
  else
    route.points.insert(route.points.begin(), last);
  route.passed.pop_back();
  route.is_moved = false;
}

}  // namespace

void pass(Route& route, std::size_t count) {
  if (count == 0) return;
  const auto begin = route.points.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
  route.passed.insert(route.passed.end(), begin + (route.is_moved ? 1 : 0), end);
  route.points.erase(begin, end);
  route.is_moved = false;
}

bool advance(const Solids& solids, Vec3 position, double radius, Route& route) {
  if (route.points.empty()) return false;
  const RoutePoint start = start_of(solids, position, radius);
  pass(route, seen_from(solids, start, route.points));
  const RoutePoint nearer{position, std::min(start.room, radius)};
  const auto is_within = [&](double radii) {
    return route.points.size() > 1 && norm(route.points[0].place - position) < radii * radius;
  };
  const auto moves_on = [&](const RoutePoint& from) {
    const RoutePoint next = past_bend(solids, from, route.points[0], route.points[1]);
    if (next.place == route.points[0].place) return false;
    move_on(route, next);
    return true;
  };
  const bool moves = is_within(kSlidesWithin) && moves_on(start);
  if (!moves && is_within(kAtBend) && !moves_on(nearer)) return false;
  for (int k = 0; k < kGoesBack && !is_way(solids, nearer, route.points.front()); ++k) {
    if (route.passed.empty()) return false;
    go_back(route);
  }
  return is_way(solids, nearer, route.points.front());
}

SpaceHeading heading_on(const Robot& robot, double preferred_speed, const Route& route) {
  const Vec3 position = robot.position;
  const std::vector<RoutePoint>& points = route.points;
  SpaceHeading heading{points.back().place, preferred_speed, route_length(position, points)};
  if (points.size() == 1) return heading;
  const Vec3 way = points.front().place - position;
  const double distance = norm(way);
  if (!(distance > 0.0)) return heading;
  heading.goal = position + (heading.left / distance) * way;
  heading.speed = std::min(preferred_speed, speed_before_turns(robot, points));
  return heading;
}

}  // namespace avo::space
