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
constexpr double kSettled = 2.0;         // times kYields until it stays where it is
constexpr double kSettleDistance = 0.5;  // of the arrival distance, from the goal
constexpr double kYields = 5.0;          // T for which it gives way near its goal
constexpr double kRecovers = 1.25;       // T after which it would again
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
  return detour.yielded >= kSettled && robot.distance_to_goal < kSettleDistance * arrival_distance;
}

}  // namespace

bool is_sound(const Detour& detour) {
  return detour.angle >= 0.0 && detour.angle <= kMostDetour && detour.yielded >= 0.0 &&
         detour.yielded <= kSettled;
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

Vec2 push_of(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 away = robot.position - neighbor.position;
  const double contact = robot.radius + neighbor.radius, room = kRoom * contact;
  const double distance = norm(away);
  const double nearness = std::min((contact + room - distance) / room, 1.0);
  const double weight = std::max(kLeastWeight, 1.0 - robot.distance_to_goal / (kLeash * contact));
  return (weight * nearness / distance) * away;
}

Vec2 wish_of(const Robot& robot, Vec2 kept_right, Vec2 push, const PlannerOptions& options,
             Detour& detour) {
  if (push == Vec2{} && detour.yielded == 0.0) return kept_right;
  const double elapsed = options.time_step / time_to_speed(robot);
  detour.yielded = is_near_goal(robot) && push != Vec2{}
                       ? std::min(detour.yielded + elapsed / kYields, kSettled)
                       : std::max(detour.yielded - elapsed / kRecovers, 0.0);
  if (has_settled(robot, detour, options.arrival_distance)) return {};
  return kept_right + (kPush * robot.max_speed * std::max(1.0 - detour.yielded, 0.0)) * push;
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
