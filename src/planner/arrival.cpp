// SPDX-License-Identifier: Apache-2.0
// Keep right in traffic, give way, back out of a jam. Angles in rad; times and lengths are measured
// in the robot's own: T = v_max/a_max to reach its speed, L = v_max²/a_max, twice its way to stop.
#include "planner/arrival.h"

#include <algorithm>
#include <cmath>

namespace avo {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kMostKeepRight = 30.0 * kDegree;
constexpr double kCongestion = 5.0;  // robots right ahead that make the way fully congested
constexpr double kSlow = 0.05;       // of v_max: nearly at rest
constexpr double kLeash = 4.0;  // r_A + r_B: distance to the goal within which it gives way more
constexpr double kLeastWeight = 0.3;      // of giving way on the way
constexpr double kPush = 2.0;             // v_max, in contact
constexpr double kSettled = 2.0;          // times kYields until it stays where it is
constexpr double kSettleDistance = 0.25;  // radii, from the goal
constexpr double kYields = 5.0;           // T for which it gives way near its goal
constexpr double kRecovers = 1.25;        // T after which it would again
constexpr double kMostDetour = 2.4;       // almost back
constexpr double kTurnOff = 1.0;          // per T
constexpr double kTurnBack = 2.0;         // per T
constexpr double kBlocked = 0.5;          // of the velocity that the limits alone allow

double time_to_speed(const Robot& robot) {
  return robot.max_speed / robot.max_acceleration;
}

double stopping_distance(const Robot& robot) {
  return 0.5 * robot.max_speed * time_to_speed(robot);
}

// How far traffic is looked at.
double traffic_range(const Robot& robot) {
  return std::max(4.0 * stopping_distance(robot), 8.0 * robot.radius);
}

}  // namespace

Traffic look_around(const Robot& robot, const Neighbors& neighbors) {
  return look_around(robot, neighbors, {traffic_range(robot), kSlow * robot.max_speed});
}

double arrival_range(const Robot& robot, double largest_radius) {
  return std::max(traffic_range(robot), (1.0 + kRoom) * (robot.radius + largest_radius));
}

Vec2 turned_right(Vec2 a, double angle) {
  // tan(angle / 2) = t/u by its continued fraction; any t and u make a rotation
  const double x = 0.5 * angle, xx = x * x;
  const double t = x * (945.0 - xx * (105.0 - xx)), u = 945.0 - xx * (420.0 - 15.0 * xx);
  const double both = t * t + u * u, c = (u * u - t * t) / both, s = 2.0 * t * u / both;
  return {c * a.x + s * a.y, c * a.y - s * a.x};
}

Vec2 keep_right(const Robot& robot, const Traffic& traffic) {
  const Vec2 wish = robot.preferred_velocity;
  if (robot.distance_to_goal < stopping_distance(robot) || !(traffic.ahead > 0.0)) return wish;
  const double part = std::min(traffic.ahead, kCongestion) / kCongestion;
  return turned_right(wish, part * kMostKeepRight);
}

Vec2 push_of(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 away = robot.position - neighbor.position;
  const double contact = robot.radius + neighbor.radius, room = kRoom * contact;
  const double distance = norm(away);
  const double nearness = std::min((contact + room - distance) / room, 1.0);
  const double weight = std::max(kLeastWeight, 1.0 - robot.distance_to_goal / (kLeash * contact));
  return (weight * nearness / distance) * away;
}

Vec2 give_way(const Robot& robot, const Traffic& traffic, double time_step, Detour& detour) {
  const Vec2 push = traffic.push;
  if (push == Vec2{} && detour.yielded == 0.0) return push;
  const double elapsed = time_step / time_to_speed(robot);
  const bool near_goal = robot.distance_to_goal < 2.0 * kLeash * robot.radius;
  detour.yielded = near_goal && push != Vec2{}
                       ? std::min(detour.yielded + elapsed / kYields, kSettled)
                       : std::max(detour.yielded - elapsed / kRecovers, 0.0);
  return (kPush * robot.max_speed * std::max(1.0 - detour.yielded, 0.0)) * push;
}

bool is_sound(const Detour& detour) {
  return detour.angle >= 0.0 && detour.angle <= kMostDetour && detour.yielded >= 0.0 &&
         detour.yielded <= kSettled;
}

bool has_settled(const Robot& robot, const Detour& detour) {
  return detour.yielded >= kSettled && robot.distance_to_goal < kSettleDistance * robot.radius;
}

bool is_blocked(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish) {
  const double unhindered = dot(unhindered_next_velocity, wish);
  return unhindered > 0.0 && dot(next_velocity, wish) < kBlocked * unhindered;
}

bool may_detour(const Robot& robot) {
  return robot.distance_to_goal >= robot.radius;
}

void turn_off(Detour& detour, const Robot& robot, double time_step) {
  detour.angle = std::min(detour.angle + kTurnOff * time_step / time_to_speed(robot), kMostDetour);
}

void turn_back(Detour& detour, const Robot& robot, double time_step) {
  detour.angle = std::max(detour.angle - kTurnBack * time_step / time_to_speed(robot), 0.0);
}

}  // namespace avo
