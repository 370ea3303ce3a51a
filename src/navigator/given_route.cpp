// SPDX-License-Identifier: Apache-2.0
#include "navigator/given_route.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/plane.h"
#include "core/ranges.h"
#include "navigation/path_map.h"
#include "walls/segment.h"

namespace avo::inline navigator {
namespace {

// A robot aims at a point ahead, farther by this factor than the distance that it covers in its
// lag. With 2 the chord to that point leads the tangent of an arc by the lag. With less it cuts
// corners less, and comes back to a straight line with a damping of √1.3/2 = 0.57.
constexpr double kLags = 1.3;
constexpr double kBackOn = 4.0;  // times the look-ahead: so far on it searches for its place
constexpr double kFaster = 0.7;  // of a_max, to become faster
// Radii. At first the robot takes its place on a stretch of the route. It is the first stretch that
// is at most so much farther off than the nearest one. A closed route thus begins at its start.
constexpr double kBegins = 2.0;
constexpr double kOfDistance = 1e-9;  // rounding

CornerGraph graph_of(const std::vector<Vec2>& points, double radius, std::span<const Wall> walls) {
  CornerGraph graph;
  graph.radius = radius;
  if (!walls.empty()) graph.grid = corner_grid(walls, radius);
  graph.points = points;
  return graph;
}

// Its entries lead from each point to the next one.
std::shared_ptr<const PathMap> map_of(const std::vector<Vec2>& points) {
  PathMap map;
  map.goal = points.back();
  map.is_free = true;
  for (std::uint32_t k = 0; k + 1 < points.size(); ++k)
    map.next.push_back(k + 2 == points.size() ? PathMap::kGoal : k + 1);
  map.length.assign(map.next.size(), 0.0);
  for (std::size_t k = map.next.size(); k-- > 0;)
    map.length[k] =
        norm(points[k + 1] - points[k]) + (k + 1 < map.next.size() ? map.length[k + 1] : 0.0);
  map.top.assign(map.next.size(), kInfinity);
  return std::make_shared<const PathMap>(std::move(map));
}

// Returns whether the robot has room all along the straight line, as far as movers at rest say. A
// robot that is nearer to one than its radius allows may leave it.
bool passes_resting(const Routes& routes, double radius, Vec2 from, Vec2 to) {
  if (!routes.goes_around_movers()) return true;
  return std::all_of(routes.resting().begin(), routes.resting().end(), [&](const Wall& disc) {
    const double near = std::min(radius + disc.radius, (1.0 - kOfDistance) * norm(from - disc.a));
    return distance(disc.a, Segment{from, to}) >= near;
  });
}

// The heading around the walls and movers at rest that hide the route, back to it.
std::optional<Heading> route_back(Routes& routes, const Follower& robot, Vec2 aim, OnRoute& on) {
  const double radius = robot.traits.route_radius;
  const auto leads_on = [&](Vec2 from) {
    return routes.is_in_sight(from, aim) && passes_resting(routes, radius, from, aim);
  };
  if (leads_on(robot.place)) {
    on.back.reset();
    return std::nullopt;
  }
  if (!on.back || !leads_on(on.back_to)) {
    on.back = routes.plan(radius, robot.place, aim, 0.0);
    on.back_to = aim;
  }
  return follow(*on.back, robot.place, on.back_to, robot.traits, robot.own_path, robot.looks_around,
                routes.scratch());
}

// m/s: the speed that the corners ahead leave the robot, and from which it can still turn. More of
// a change would leave nothing of a_max for the direction.
double speed_of(const Follower& robot, double speed, const Pursuit& pursuit, const OnRoute& on) {
  const Cornering& cornering = pursuit.cornering;
  const double seen = std::min(on.along + cornering.lag * speed, on.next().along);
  const double wished = robot.traits.preferred_speed;
  return std::min(on.route->rounded.top_speed(seen, wished, cornering),
                  speed + kFaster * cornering.acceleration * cornering.lag);
}

// m: how far ahead the robot aims. Movers at rest may stand on the route up to where the robot can
// stop: then it aims behind them. Where one stands at its end, it comes as near as it can.
double past_resting(const Routes& routes, const Follower& robot, double ahead, const OnRoute& on) {
  if (!routes.goes_around_movers()) return ahead;
  const RobotTraits& traits = robot.traits;
  const double radius = traits.route_radius, left = on.next().along - on.along;
  const auto has_room = [&](double to) {
    const Vec2 place = on.route->rounded.at(on.along + to);
    return std::none_of(routes.resting().begin(), routes.resting().end(), [&](const Wall& disc) {
      return norm(place - disc.a) < radius + disc.radius;
    });
  };
  const double stop = 0.5 * traits.max_speed * (traits.max_speed / traits.max_acceleration);
  const double seen = ahead + stop + 2.0 * radius;
  double to = ahead;
  while (to < std::min(seen, left) && has_room(to)) to += 0.5 * radius;
  if (!(to < std::min(seen, left))) return ahead;
  while (to < left && !has_room(to)) to += 0.5 * radius;
  return to < left ? to : ahead;
}

// The heading along the route, towards a point that is so far ahead, m. Where the robot comes to
// the end in a direction of its own, that point may be beyond the end.
Heading heading_along(const Follower& robot, double speed, double ahead, Vec2 end_direction,
                      const OnRoute& on) {
  const double until = on.next().along, beyond = std::max(on.along + ahead - until, 0.0);
  const bool is_directed = on.is_last() && end_direction != Vec2{};
  Vec2 aim = on.route->rounded.at(std::min(on.along + ahead, until));
  if (is_directed) aim = aim + beyond * end_direction;
  const Vec2 to_aim = aim - robot.place;
  const double distance = norm(to_aim), to_stop = until - on.along;
  const bool is_last = !(distance > 0.0) || (beyond > 0.0 && !is_directed);
  const double left = is_directed ? to_stop : std::max(to_stop, distance);
  return {.goal = is_last ? aim : robot.place + (left / distance) * to_aim,
          .preferred_speed = speed,
          .next = aim};
}

}  // namespace

std::shared_ptr<const GivenRoute> given_route(std::span<const Waypoint> listed,
                                              const Rounding& rounding, double radius,
                                              std::span<const Wall> walls) {
  std::vector<Waypoint> points;
  for (const Waypoint& point : listed) {
    if (points.empty() || norm(point.place - points.back().place) > kSmallest) {
      points.push_back(point);
      continue;
    }
    points.back().wait = std::max(points.back().wait, point.wait);
    points.back().stages += point.stages;
  }
  std::vector<RoutePoint> corners;
  std::vector<Vec2> places;
  for (const Waypoint& point : points) {
    corners.push_back({point.place, point.wait > 0.0});
    places.push_back(point.place);
  }
  GivenRoute route{RoundedRoute(corners, rounding), places,        {}, {},
                   graph_of(places, radius, walls), map_of(places)};
  const std::span<const double> along = route.rounded.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool is_end = k + 1 == points.size();
    if (points[k].wait > 0.0 && !is_end) route.stops.push_back({along[k], points[k].wait});
    route.marks.insert(route.marks.end(), points[k].stages, {along[k], route.stops.size()});
  }
  route.stops.push_back({route.rounded.length(), 0.0});
  return std::make_shared<const GivenRoute>(std::move(route));
}

std::shared_ptr<const GivenRoute> given_route(const Pose& from, std::span<const PathPiece> pieces,
                                              double radius, std::span<const Wall> walls) {
  RoundedRoute rounded(from, pieces);
  std::vector<Vec2> places;
  for (const double along : rounded.points()) places.push_back(rounded.at(along));
  const double length = rounded.length();
  GivenRoute route{std::move(rounded), places, {{length, 0.0}}, {}, graph_of(places, radius, walls),
                   map_of(places)};
  return std::make_shared<const GivenRoute>(std::move(route));
}

Travel as_travel(const OnRoute& on) {
  const GivenRoute& route = *on.route;
  const std::span<const double> points = route.rounded.points();
  const auto next = std::upper_bound(points.begin(), points.end(), on.along);
  Travel travel;
  travel.graph = &route.graph;
  travel.map = route.map;
  travel.target = next == points.end() || next + 1 == points.end()
                      ? PathMap::kGoal
                      : static_cast<std::uint32_t>(next - points.begin());
  return travel;
}

std::size_t stages_passed(const OnRoute& on) {
  std::size_t passed = 0;
  const std::vector<Mark>& marks = on.route->marks;
  while (passed + 1 < marks.size() && marks[passed].stops <= on.stop &&
         marks[passed].along <= on.along)
    ++passed;
  return passed;
}

double left_of(const OnRoute& on, Vec2 position) {
  const RoundedRoute& route = on.route->rounded;
  return route.length() - on.along + norm(route.at(on.along) - position);
}

Headings follow_given(Routes& routes, const Claims& claims, const Follower& robot, Vec2 velocity,
                      const Pursuit& pursuit, OnRoute& on) {
  const RoundedRoute& route = on.route->rounded;
  const double speed = norm(velocity), until = on.next().along;
  const auto ahead_at = [&](double v) {
    return std::max(kLags * pursuit.cornering.lag * v, pursuit.least_ahead);
  };
  const double farthest = std::min(on.along + kBackOn * ahead_at(speed), until);
  on.along = on.has_begun
                 ? route.nearest(robot.place, on.along, farthest)
                 : route.first_near(robot.place, kBegins * robot.traits.route_radius, until);
  on.has_begun = true;
  const double wished = speed_of(robot, speed, pursuit, on);
  const double ahead = past_resting(routes, robot, ahead_at(std::min(speed, wished)), on);
  Heading by_route = heading_along(robot, wished, ahead, pursuit.end_direction, on);
  if (const auto back = route_back(routes, robot, by_route.next, on)) by_route = *back;
  Headings result{by_route, by_route};
  if (routes.passages.empty()) return result;
  result.heading = heed_passages(routes, claims, robot, as_travel(on), by_route, kInfinity);
  result.by_route.yields = result.heading.yields;
  return result;
}

}  // namespace avo::inline navigator
