// SPDX-License-Identifier: Apache-2.0
#include "space/routes/routes.h"

#include <algorithm>
#include <cmath>

#include "guidance/routes.h"
#include "space/own_space.h"
#include "space/routes/tighten.h"

namespace avo::space {
namespace {

constexpr double kRoutesAround = 5.0;  // radii: routes lead so far around all boxes
constexpr int kRests = 5;              // steps before a robot searches again for what it lost
// of another route: a clear route that is no longer than it stays
constexpr double kAsShort = 1.01;
constexpr double kLeavesLane = 1.0;  // rad: a robot that has turned off by more is in a jam

void include_finite(const Bounds& bounds, Bounds& within) {
  const auto take = [](double value, double& low, double& high) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  };
  for (const Vec3 a : {bounds.low, bounds.high}) {
    take(a.x, within.low.x, within.high.x);
    take(a.y, within.low.y, within.high.y);
    take(a.z, within.low.z, within.high.z);
  }
}

// A place as far off as the rest of the route, so that no robot brakes for it.
Vec3 beyond(Vec3 position, Vec3 target, double rest) {
  const Vec3 to_target = target - position;
  const double distance = norm(to_target);
  return distance > 0.0 && rest > distance ? position + (rest / distance) * to_target : target;
}

bool is_clear(const Solids& solids, const std::vector<SpaceRoutePoint>& points) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (!is_free_between(solids, points[k], points[k + 1])) return false;
  }
  return true;
}

bool is_in_company(const Robot& robot, std::span<const Neighbor> neighbors) {
  const double range = kClaimRange * robot.radius;
  return std::any_of(neighbors.begin(), neighbors.end(), [&](const Neighbor& other) {
    return norm_squared(other.position - robot.position) <= range * range;
  });
}

}  // namespace

SpaceRoutes::SpaceRoutes(std::span<const Box> boxes, std::span<const Robot> robots,
                         std::span<const Vec3> goals, bool routes)
    : has_routes_(routes), routes_(robots.size()) {
  for (const Robot& robot : robots) {
    radii_.push_back(robot.radius);
    radii_.push_back(radius_class(robot.radius));
  }
  std::sort(radii_.begin(), radii_.end());
  radii_.erase(std::unique(radii_.begin(), radii_.end()), radii_.end());
  set_boxes(boxes, robots, goals);
}

void SpaceRoutes::set_boxes(std::span<const Box> boxes, std::span<const Robot> robots,
                            std::span<const Vec3> goals) {
  for (SpaceRoute& route : routes_) route.is_searched = false, route.rests = 0;
  within_ = {};
  for (const Robot& robot : robots) within_.include(robot.position);
  for (const Vec3 goal : goals) within_.include(goal);
  solids_ = Solids(has_routes_ ? boxes : std::span<const Box>{});
  for (std::size_t k = 0; k < solids_.size(); ++k) include_finite(solids_.bounds(k), within_);
  std::vector<double> radii;
  for (const Robot& robot : robots) radii.push_back(robot.radius);
  std::sort(radii.begin(), radii.end());
  passages_ = SpacePassages(solids_, radii);
  cells_ = Memo<FreeCells>(radii_.size());
}

void SpaceRoutes::include(Vec3 goal) {
  if (within_.contain(goal)) return;
  within_.include(goal);
  cells_ = Memo<FreeCells>(radii_.size());
}

void SpaceRoutes::begin_step(std::span<const Robot> robots) {
  if (passages_.empty()) return;
  claims_.clear(passages_.size());
  for (std::uint32_t k = 0; k < robots.size(); ++k)
    append_claims(passages_, solids_, robots[k].position, robots[k].velocity, k, claims_);
}

const FreeCells& SpaceRoutes::cells(double radius) const {
  const auto at = std::lower_bound(radii_.begin(), radii_.end(), radius) - radii_.begin();
  return cells_.get(static_cast<std::size_t>(at), [&] {
    return FreeCells(solids_, within_.grown(kRoutesAround * radius), radius);
  });
}

// In the cells of its class, or where no route leads there, of its own radius.
FoundRoute SpaceRoutes::find(Vec3 from, Vec3 goal, double radius, HeadingScratch& scratch) const {
  const double rounded = radius_class(radius);
  FoundRoute route = find_route(cells(rounded), solids_, from, goal, radius, scratch.search);
  if (route.reaches || rounded == radius) return route;
  return find_route(cells(radius), solids_, from, goal, radius, scratch.search);
}

void SpaceRoutes::follow(const Robot& robot, Vec3 goal, SpaceRoute& route,
                         HeadingScratch& scratch) const {
  if (!(route.goal == goal)) route = {.goal = goal, .points = {}, .passed = {}};
  const Vec3 position = robot.position;
  const double room = room_at(solids_, goal, robot.radius + kRouteRoom);
  const SpaceRoutePoint start{position, room_at(solids_, position, robot.radius + kRouteRoom)};
  if (room >= kLeastRoom * robot.radius && is_free_between(solids_, start, {goal, room})) {
    if (route.reaches && !route.points.empty())
      pass(route, route.points.size() - 1);
    else
      route.passed.clear(), route.is_moved = false;
    route.points.assign(1, {goal, room});
    route.reaches = route.is_searched = true, route.is_in_box = false, route.left = 0.0;
    return;
  }
  const bool sees = advance(solids_, position, robot.radius, route);
  if (route.rests > 0) --route.rests;
  if ((route.is_searched && sees) || route.rests > 0) return;
  FoundRoute found = find(position, goal, robot.radius, scratch);
  route.rests = kRests;
  const bool was_searched = std::exchange(route.is_searched, true);
  const bool stays =
      !was_searched && sees && route.reaches && is_clear(solids_, route.points) &&
      route_length(position, route.points) <= kAsShort * route_length(position, found.points);
  if (stays || (found.points.empty() && !route.points.empty())) return;
  if (found.points.empty()) found.points.push_back(start);  // it is enclosed, and rests
  route.passed.assign(1, start), route.is_moved = false;
  route.points = std::move(found.points), route.reaches = found.reaches;
  route.is_in_box = found.is_in_box;
  route.left = found.reaches ? 0.0 : norm(goal - route.points.back().place);
}

bool SpaceRoutes::is_behind_box(std::size_t k, Vec3 position, Vec3 goal) const {
  return solids_.size() > 0 && routes_[k].reaches && !solids_.sees(position, goal);
}

void SpaceRoutes::look(std::size_t k, const Robot& robot, Vec3 goal, HeadingScratch& scratch) {
  if (solids_.size() > 0) follow(robot, goal, routes_[k], scratch);
}

SpaceClaimer SpaceRoutes::claimer_of(std::size_t k, const Robot& robot, const PassageView& company,
                                     const SpaceRoute& route) {
  return {robot.position,
          robot.radius,
          planned_braking(robot),
          company.sensing_radius,
          static_cast<std::uint32_t>(k),
          route.points,
          company.neighbors,
          route.yielded};
}

SpaceHeading SpaceRoutes::heading(std::size_t k, const Robot& robot, Vec3 goal,
                                  double preferred_speed, const PassageView& company,
                                  SpaceRoute& route, HeadingScratch& scratch) const {
  SpaceHeading heading{goal, preferred_speed, norm(goal - robot.position)};
  if (solids_.size() == 0) return heading;
  follow(robot, goal, route, scratch);
  if (route.points.empty()) return heading;
  heading = heading_on(robot, preferred_speed, route);
  if (passages_.empty()) return heading;
  const SpaceClaimer claimer = claimer_of(k, robot, company, route);
  if (company.detour <= kLeavesLane && is_in_company(robot, company.neighbors)) {
    if (const auto lane = lane_ahead(passages_, solids_, claimer))
      heading.goal = beyond(robot.position, *lane, heading.left), heading.guide = Guide::lane;
  }
  const SpaceCourse course = right_of_way(passages_, claims_, claimer, scratch.others);
  route.yielded = course.is_after_others ? route.yielded + company.time_step : 0.0;
  if (course.target || course.max_speed < heading.speed) heading.guide = Guide::passage;
  heading.speed = std::min(heading.speed, course.max_speed);
  if (course.target)
    heading.goal =
        course.stops ? *course.target : beyond(robot.position, *course.target, heading.left);
  return heading;
}

std::optional<SpaceWait> SpaceRoutes::wait(std::size_t k, const Robot& robot,
                                           const PassageView& company, const SpaceRoute& route,
                                           HeadingScratch& scratch) const {
  return waited_for(passages_, claims_, claimer_of(k, robot, company, route), scratch.others);
}

}  // namespace avo::space
