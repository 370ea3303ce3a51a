// SPDX-License-Identifier: Apache-2.0
// Keep right in traffic, give way, back out of a jam. Angles in rad; times and lengths are measured
// in the robot's own: T = v_max/a_max to reach its speed, L = v_max²/a_max, twice its way to stop.
#include "planner/arrival.h"

#include <algorithm>
#include <cmath>

#include "planner/arrival_kernel.h"

namespace avo {
namespace {

using Real = scalar::Pack<double>;

constexpr double kLeash = 4.0;  // r_A + r_B: distance to the goal within which it gives way more
constexpr double kLeastWeight = 0.3;     // of giving way on the way
constexpr double kPush = 2.0;            // v_max, in contact
constexpr double kAtRest = 0.01;         // of v_max: so slow, nobody pushes who is near its goal
constexpr double kInMotion = 0.2;        // of v_max: so fast, in full
constexpr double kSettles = 4.0;         // T beside others, until it stays where it is
constexpr double kRecovers = 10.0;       // T alone, until it has forgotten all of them
constexpr double kSettleDistance = 0.9;  // of the arrival distance, from the goal
constexpr double kMostDetour = 2.4;      // almost back
constexpr double kTurnOff = 1.0;         // per T
constexpr double kTurnBack = 2.0;        // per T

double time_to_speed(const Robot& robot) {
  return robot.max_speed / robot.max_acceleration;
}

scalar::Vec<Real> pack(Vec2 a) {
  return scalar::constant<Real>(a);
}

// Whether it has been beside others for so long, and so near its goal, that it stays there.
bool has_settled(const Robot& robot, const Detour& detour, double arrival_distance) {
  return detour.settled >= 1.0 && robot.distance_to_goal < kSettleDistance * arrival_distance;
}

}  // namespace

bool is_sound(const Detour& detour) {
  return detour.angle >= 0.0 && detour.angle <= kMostDetour && detour.settled >= 0.0 &&
         detour.settled <= 1.0;
}

double arrival_range(const Robot& robot, double largest_radius) {
  const Real range =
      scalar::traffic_range<Real>(robot.max_speed, braking_limit(robot), robot.radius);
  return std::max(range.value, (1.0 + kRoom) * (robot.radius + largest_radius));
}

Vec2 turned_right(Vec2 a, double angle) {
  return plain(scalar::turned_right(pack(a), Real(angle)));
}

Vec2 approach(Vec2 velocity, Vec2 target, double decrement) {
  return plain(scalar::approach(pack(velocity), pack(target), Real(decrement)));
}

namespace {

// Near its goal a robot gives way to those that move, and to larger ones: who rests beside it has
// come to its own goal.
double urgency(const Robot& robot, const Neighbor& neighbor) {
  if (!is_near_goal(robot) || neighbor.radius > robot.radius) return 1.0;
  const double part = norm(neighbor.velocity) / robot.max_speed;
  return std::clamp((part - kAtRest) / (kInMotion - kAtRest), 0.0, 1.0);
}

}  // namespace

Vec2 push_of(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 away = robot.position - neighbor.position;
  const double contact = robot.radius + neighbor.radius, room = kRoom * contact;
  const double distance = norm(away);
  const double nearness = std::min((contact + room - distance) / room, 1.0);
  const double nearing = std::max(kLeastWeight, 1.0 - robot.distance_to_goal / (kLeash * contact));
  const double size = std::min(neighbor.radius / robot.radius, 1.0);
  const double weight = nearing * size * urgency(robot, neighbor);
  return (weight * nearness / distance) * away;
}

Vec2 wish_of(const Robot& robot, Vec2 kept_right, const Traffic& traffic,
             const PlannerOptions& options, Detour& detour) {
  const double elapsed = options.time_step / time_to_speed(robot);
  detour.settled = is_near_goal(robot) && traffic.is_beside
                       ? std::min(detour.settled + elapsed / kSettles, 1.0)
                       : std::max(detour.settled - elapsed / kRecovers, 0.0);
  const Vec2 own = has_settled(robot, detour, options.arrival_distance) ? Vec2{} : kept_right;
  return own + (kPush * robot.max_speed) * traffic.push;
}

bool is_blocked(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish) {
  return scalar::is_blocked(pack(next_velocity), pack(unhindered_next_velocity), pack(wish)).bit;
}

bool is_near_goal(const Robot& robot) {
  return robot.distance_to_goal < 2.0 * kLeash * robot.radius;
}

bool may_detour(const Robot& robot) {
  return robot.distance_to_goal >= robot.radius;
}

void turn_off(Detour& detour, const Robot& robot, double time_step, bool among_walls) {
  if (among_walls && detour.angle == kMostDetour) {
    detour.angle = 0.0;
    return;
  }
  detour.angle = std::min(detour.angle + kTurnOff * time_step / time_to_speed(robot), kMostDetour);
}

void turn_back(Detour& detour, const Robot& robot, double time_step) {
  detour.angle = std::max(detour.angle - kTurnBack * time_step / time_to_speed(robot), 0.0);
}

}  // namespace avo
