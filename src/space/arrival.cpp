// SPDX-License-Identifier: Apache-2.0
#include "space/arrival.h"

#include <algorithm>
#include <cmath>

#include "avo/half_plane.h"
#include "space/own_space.h"
#include "space/trace.h"

namespace avo::space {
namespace {

// Robots ahead on collision courses that make a route fully congested. In the plane all robots
// ahead count, and it takes more of them.
constexpr double kFullCongestion = 2.0;

// The turn to the right fades over so many stopping lengths of the route, before the last one.
constexpr double kFade = 7.0;

// The neighbor of the plane with the same distance and the same speeds, along one axis.
avo::Neighbor in_plane(const Neighbor& neighbor) {
  avo::Neighbor same;
  same.radius = neighbor.radius;
  same.velocity = {norm(neighbor.velocity), 0.0};
  return same;
}

// See avo::push_of().
Vec3 push_of(const Robot& robot, const Neighbor& neighbor, Vec3 away, double distance) {
  avo::Robot a = numbers_of(robot);
  avo::Neighbor b = in_plane(neighbor);
  // along one axis, with the relative velocity of the two
  a.position = {distance, 0.0};
  a.velocity = {norm(robot.velocity - neighbor.velocity), 0.0};
  b.velocity = {};
  return (avo::push_of(a, b).x / distance) * away;
}

}  // namespace

Traffic traffic_of(const Robot& robot, const Bodies& bodies, const Looked& looked) {
  Traffic traffic;
  traffic.ahead = looked.ahead;
  for (const std::uint32_t place : looked.beside) {
    const Neighbor neighbor = bodies.neighbor(place);
    const Vec3 away =
        away_from(robot.position, robot.downwash, neighbor.position, neighbor.downwash);
    const double gap = norm(away), contact = robot.radius + neighbor.radius;
    if (!(gap > 0.0 && gap < (1.0 + kRoom) * contact)) continue;
    traffic.is_beside = true;
    const double defers = 2.0 * room_share(1.0, 1.0, neighbor.priority, robot.priority);
    const Vec3 push = defers * push_of(robot, neighbor, away, gap);
    const double motion = motion_of(numbers_of(robot), in_plane(neighbor));
    traffic.push = traffic.push + motion * push;
    traffic.push_at_rest = traffic.push_at_rest + (1.0 - motion) * push;
  }
  return traffic;
}

Vec3 turned_right(Vec3 a, Vec3 axis, double angle) {
  const Vec2 turned = avo::turned_right({1.0, 0.0}, angle);
  return turned.x * a + turned.y * cross(axis, a) + ((1.0 - turned.x) * dot(axis, a)) * axis;
}

template <typename Trace>
Vec3 wish_of(const Viewer& look, const Bodies& bodies, std::span<const Box> boxes,
             const Looked& looked, const PlannerOptions& options, const Tempo& tempo,
             Detour& detour, Trace trace) {
  const Robot& robot = look.robot;
  const avo::Robot same = numbers_of(robot);
  const Traffic traffic = traffic_of(robot, bodies, looked);
  avo::Detour plane{
      .beside = detour.beside, .congestion = detour.congestion, .has_arrived = detour.has_arrived};
  const double ahead =
      unusual_congestion(traffic.ahead, tempo.time_to_speed, options.time_step, plane);
  detour.congestion = plane.congestion;
  if (detour.goal_taken) {
    detour.beside = 0.0F, detour.has_arrived = false;
    return robot.preferred_velocity;
  }
  // The turn fades to 0: on the last part of its route a robot needs its acceleration to brake. On
  // a short route, a turn costs more than it saves, unless there is much traffic.
  const double stopping = 0.5 * robot.max_speed * (robot.max_speed / planned_braking(robot));
  Vec3 wish = robot.preferred_velocity;
  if (ahead > 0.0 && robot.distance_to_goal > stopping) {
    const double left = (robot.distance_to_goal - stopping) / stopping;
    const double part = std::min(std::min(left / kFade, 1.0) * (ahead / kFullCongestion), 1.0);
    wish = turned_right(wish, turn_axis(robot, boxes), part * kMostKeepRight);
    trace.keeps_right(look, bodies, looked, wish);
  }
  if (!traffic.is_beside && detour.beside == 0.0F) return wish;
  const PushRule rule = push_rule(same, traffic.is_beside, options, plane);
  detour.beside = plane.beside, detour.has_arrived = plane.has_arrived;
  const Vec3 push =
      robot.max_speed * (rule.moving * traffic.push + rule.at_rest * traffic.push_at_rest);
  wish = rule.settles ? push : wish + push;
  trace.yields(robot, bodies, looked, rule, wish);
  return wish;
}

template Vec3 wish_of(const Viewer&, const Bodies&, std::span<const Box>, const Looked&,
                      const PlannerOptions&, const Tempo&, Detour&, NoTrace);
template Vec3 wish_of(const Viewer&, const Bodies&, std::span<const Box>, const Looked&,
                      const PlannerOptions&, const Tempo&, Detour&, Recorder);

}  // namespace avo::space
