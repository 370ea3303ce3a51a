// SPDX-License-Identifier: Apache-2.0
#include "guidance/travel.h"

#include <algorithm>
#include <utility>

#include "core/plane.h"
#include "navigation/path_map.h"

namespace avo::inline guidance {
namespace {

constexpr std::uint64_t kStepsBetweenLooks = 10;
constexpr double kBeside = 1.1;        // of contact, where a mover stands on the goal
constexpr double kLittleDetour = 1.5;  // times the straight distance
constexpr std::size_t kFewCorners = 1000;

}  // namespace

std::optional<std::pair<Vec2, double>> rest_of(const Travel& travel) {
  if (travel.graph == nullptr) return std::nullopt;
  const PathMap& map = *travel.map;
  if (travel.target == PathMap::kGoal && map.is_free) return std::pair(map.goal, 0.0);
  if (map.place_of(travel.target) >= map.next.size()) return std::nullopt;
  return std::pair(travel.graph->points[travel.target],
                   length_from(*travel.graph, map, travel.target));
}

void aim_at_best(Travel& travel, Vec2 position, double radius, LegScratch& scratch) {
  travel.target =
      next_leg(*travel.graph, travel.map, position, radius, PathMap::kNothing, false, scratch)
          .target;
}

void aim_at(Travel& travel, std::uint32_t target, LegScratch& scratch) {
  travel.target = target;
  if (!travel.map->is_whole)
    travel.map = std::make_shared<const PathMap>(
        route_from(*travel.graph, *travel.map, target, scratch.search));
}

bool is_searched(const CornerGraph& graph) {
  return graph.corners() > kFewCorners && graph.lattice.empty();
}

Travel around(const Travel& travel, Vec2 position, double radius, std::vector<Segment> closed,
              LegScratch& scratch) {
  Travel other = travel;
  other.waiting = {};
  other.waiting.open = travel.waiting.open ? travel.waiting.open : travel.map;
  const auto map = is_searched(*travel.graph) ? goal_of : path_map;
  other.map = std::make_shared<const PathMap>(map(*travel.graph, travel.map->goal, closed));
  other.waiting.closed = std::move(closed);
  aim_at_best(other, position, radius, scratch);
  return other;
}

Travel reopened(const Travel& travel, Vec2 position, double radius, LegScratch& scratch) {
  Travel open = travel;
  open.map = std::exchange(open.waiting.open, nullptr);
  open.waiting.closed.clear();
  aim_at_best(open, position, radius, scratch);
  return open;
}

double length_of(const Travel& travel, Vec2 position) {
  const auto rest = rest_of(travel);
  return rest ? norm(rest->first - position) + rest->second : kInfinity;
}

Simulation::Route rest_of_route(const Travel& travel, Vec2 position, Vec2 goal) {
  const Vec2 end = travel.end(goal);
  Simulation::Route route{norm(end - position), end, norm(goal - end)};
  const auto rest = rest_of(travel);
  if (rest && travel.target != PathMap::kGoal)
    route.length = norm(rest->first - position) + rest->second, route.next = rest->first;
  if (travel.ends == RouteEnd::short_of) route.length = kInfinity;
  return route;
}

Heading follow(Travel& travel, Vec2 position, Vec2 end, const RobotTraits& robot, double own_path,
               bool looks_around, LegScratch& scratch) {
  const Heading straight = straight_to(end, robot);
  if (travel.graph == nullptr) return straight;
  const Leg leg = next_leg(*travel.graph, travel.map, position, robot.radius, travel.target,
                           looks_around, scratch);
  travel.target = leg.target;
  if (leg.is_last() || leg.target == PathMap::kNothing) return straight;
  const Vec2 to_aim = leg.aim - position;
  const double distance = norm(to_aim), to_end = norm(end - position);
  if (!(distance > 0.0) || (to_end < own_path && leg.length < kLittleDetour * to_end))
    return straight;
  return {
      .goal = position + (leg.length / distance) * to_aim,
      .preferred_speed = std::min(robot.preferred_speed, speed_limit(leg, robot.max_acceleration)),
      .next = leg.aim};
}

Heading beside_resting(std::span<const Wall> resting, const Heading& heading, Vec2 position,
                       Vec2 end, double radius) {
  if (heading.goal != end) return heading;
  const Wall* nearest = nullptr;
  for (const Wall& mover : resting) {
    const bool covers = norm(end - mover.a) < kBeside * (radius + mover.radius);
    const bool is_nearer =
        nearest == nullptr || norm(position - mover.a) < norm(position - nearest->a);
    if (covers && is_nearer) nearest = &mover;
  }
  const Vec2 away = nearest != nullptr ? position - nearest->a : Vec2{};
  const double distance = norm(away);
  if (!(distance > 0.0)) return heading;
  const double beside = kBeside * (radius + nearest->radius);
  Heading to = heading;
  to.goal = nearest->a + (beside / distance) * away, to.guide = Guide::mover;
  return to;
}

bool looks_around(RobotId robot, std::int64_t steps) {
  return (robot.value + static_cast<std::uint64_t>(steps)) % kStepsBetweenLooks == 0;
}

}  // namespace avo::inline guidance
