// SPDX-License-Identifier: Apache-2.0
#include "space/routes/route.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "space/own_space.h"
#include "space/routes/tighten.h"

namespace avo::space {
namespace {

constexpr double kCarried = 0.3;      // radii that others may carry a robot off its route at a bend
constexpr double kBraking = 1.6;      // twice the part of its braking that it plans with
constexpr double kCutsCorners = 0.5;  // of the room of routes, that a robot keeps on its route
constexpr double kScrapes = 0.9;      // radii: a robot that touches a box sees past it like this
constexpr double kSlidesWithin = 6.0;  // radii: nearer to a bend it looks round the bend
constexpr double kAtBend = 0.5;        // radii: there it has to see past the bend
constexpr int kBisections = 5;
constexpr int kGoesBack = 3;      // bends
constexpr double kReturns = 8.0;  // radii: to a bend that is farther it does not go back

// The robot's place, and what it keeps from boxes on its route.
SpaceRoutePoint start_of(const Solids& solids, Vec3 position, double radius) {
  return {position, room_at(solids, position, radius + kCutsCorners * kRouteRoom)};
}

// |sin φ| of the turn from one piece to the next, 1 beyond 90 degrees.
double turn_of(Vec3 a, Vec3 b) {
  const double lengths = norm(a) * norm(b);
  if (!(lengths > 0.0)) return 0.0;
  return dot(a, b) <= 0.0 ? 1.0 : norm(cross(a, b)) / lengths;
}

// A straight piece of a route.
struct RouteLeg {
  SpaceRoutePoint from, to;
  [[nodiscard]] SpaceRoutePoint at(double part) const {
    return {from.place + part * (to.place - from.place), std::min(from.room, to.room)};
  }
};

// The farthest place of the leg that the robot sees, if it sees the place at that part.
std::optional<SpaceRoutePoint> farthest_seen(const Solids& solids, const SpaceRoutePoint& start,
                                             const RouteLeg& leg, double seen) {
  if (!is_free_between(solids, start, leg.at(seen))) return std::nullopt;
  double hidden = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double part = 0.5 * (seen + hidden);
    (is_free_between(solids, start, leg.at(part)) ? seen : hidden) = part;
  }
  return leg.at(seen);
}

// m/s: from which the robot can make all turns ahead (docs/navigation.md, "Speed").
double speed_before_turns(const Robot& robot, const std::vector<SpaceRoutePoint>& points) {
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
std::size_t seen_from(const Solids& solids, const SpaceRoutePoint& start,
                      const std::vector<SpaceRoutePoint>& points) {
  std::size_t seen = 0;
  while (seen + 1 < points.size() && is_free_between(solids, start, points[seen + 1])) ++seen;
  return seen;
}

// Moves the next point on along the leg behind it.
bool moves_on(const Solids& solids, const SpaceRoutePoint& start, SpaceRoute& route) {
  const RouteLeg leg{route.points[0], route.points[1]};
  const auto next = farthest_seen(solids, start, leg, 0.0);
  if (!next || next->place == leg.from.place) return false;
  if (!route.is_moved) route.passed.push_back(leg.from);
  route.points.front() = *next, route.is_moved = true;
  return true;
}

// Puts a point before the others. It replaces a point that has moved on from the last bend.
void put_first(SpaceRoute& route, const SpaceRoutePoint& point) {
  if (route.is_moved)
    route.points.front() = point;
  else
    route.points.insert(route.points.begin(), point);
}

// Heads for the leg that the robot is beside, behind the last bend, where it sees that leg.
bool returns_to_leg(const Solids& solids, const SpaceRoutePoint& start, SpaceRoute& route) {
  const RouteLeg leg{route.passed.back(), route.points[route.is_moved ? 1 : 0]};
  const Vec3 line = leg.to.place - leg.from.place;
  const double squared = norm_squared(line);
  if (!(squared > 0.0)) return false;
  const double beside = std::clamp(dot(start.place - leg.from.place, line) / squared, 0.0, 1.0);
  const auto next = farthest_seen(solids, start, leg, beside);
  if (!next) return false;
  put_first(route, *next);
  route.is_moved = true;
  return true;
}

void go_back(SpaceRoute& route) {
  const SpaceRoutePoint last = route.passed.back();
  put_first(route, last);
  route.passed.pop_back();
  route.is_moved = false;
}

// Returns whether the robot sees its route again, by a few bends at most.
bool returns(const Solids& solids, const SpaceRoutePoint& start, double radius, SpaceRoute& route) {
  for (int k = 0; k < kGoesBack && !route.passed.empty(); ++k) {
    if (returns_to_leg(solids, start, route)) return true;
    go_back(route);
    const SpaceRoutePoint& bend = route.points.front();
    if (norm(bend.place - start.place) < kReturns * radius && is_free_between(solids, start, bend))
      return true;
  }
  return false;
}

}  // namespace

void pass(SpaceRoute& route, std::size_t count) {
  if (count == 0) return;
  const auto begin = route.points.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
  route.passed.insert(route.passed.end(), begin + (route.is_moved ? 1 : 0), end);
  route.points.erase(begin, end);
  route.is_moved = false;
}

bool advance(const Solids& solids, Vec3 position, double radius, SpaceRoute& route) {
  if (route.points.empty()) return false;
  const SpaceRoutePoint start = start_of(solids, position, radius);
  pass(route, seen_from(solids, start, route.points));
  const SpaceRoutePoint nearer{position, std::min(start.room, kScrapes * radius)};
  const auto is_within = [&](double radii) {
    return route.points.size() > 1 && norm(route.points[0].place - position) < radii * radius;
  };
  const bool moves = is_within(kSlidesWithin) && moves_on(solids, start, route);
  if (!moves && is_within(kAtBend) && !moves_on(solids, nearer, route)) return false;
  return is_free_between(solids, nearer, route.points.front()) ||
         returns(solids, nearer, radius, route);
}

SpaceHeading heading_on(const Robot& robot, double preferred_speed, const SpaceRoute& route) {
  const Vec3 position = robot.position;
  const std::vector<SpaceRoutePoint>& points = route.points;
  SpaceHeading heading{points.back().place, preferred_speed, route_length(position, points)};
  if (points.size() == 1) return heading;
  const Vec3 line = points.front().place - position;
  const double distance = norm(line);
  if (!(distance > 0.0)) return heading;
  heading.goal = position + (heading.left / distance) * line;
  heading.speed = std::min(preferred_speed, speed_before_turns(robot, points));
  return heading;
}

}  // namespace avo::space
