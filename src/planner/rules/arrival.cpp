// SPDX-License-Identifier: Apache-2.0
// Keep right in traffic, yield, back out of a jam. Angles in rad; times and lengths are in the
// robot's own units: T = v_max/a_max, the time to reach its speed, and L = v_max²/a_max, twice its
// stopping distance.
#include "planner/rules/arrival.h"

#include <algorithm>
#include <cmath>

#include "planner/arrival_kernel.h"

namespace avo::inline planner {

namespace {

using Real = scalar::Pack<double>;

constexpr double kLeash = 6.0;        // r_A + r_B: distance to the goal within which it yields more
constexpr double kNear = 20.0;        // radii, of the goal: the last part of the route
constexpr double kLeastWeight = 0.3;  // of yielding on the rest of the route
constexpr double kPush = 1.2;         // v_max, in contact
constexpr double kPushAtRest = 5.0;   // v_max, of a neighbor at rest
constexpr double kAtRest = 0.01;      // of v_max: a slower neighbor does not push near the goal
constexpr double kInMotion = 0.2;     // of v_max: a faster neighbor pushes in full
constexpr double kLeastTime = 4.0;    // radii at v_max: T of the strongest
constexpr double kTry = 14.0;         // T: in each such time, on the last part of the route,
constexpr double kYields = 0.9;       // it yields to neighbors at rest as well for this part
constexpr double kSettles = 2.0;      // T beside others, until it stays in place
constexpr double kSettleDistance = 0.9;  // of the arrival distance, from the goal
constexpr double kPatience = 6.0;        // T beside others: after that its distance grows
constexpr double kGrowth = 0.15;         // arrival distances per T
constexpr double kMostGrowth = 3.0;      // arrival distances
constexpr double kSmall = 0.5;           // radii: below it, both are in radii
// T beside others, the largest count; beyond it the last try repeats
constexpr double kLongest = 200.0;
constexpr double kRecovers = 10.0;   // T alone, in which it forgets all of the count but 1/e
constexpr double kGetsUsed = 100.0;  // T, to get used to the congestion ahead
constexpr double kUsual = 2.0;       // times the usual congestion does not make it keep right
constexpr float kMostDetour = 2.4F;  // rad, almost back
constexpr double kTurnOff = 1.0;     // per T
constexpr double kTurnBack = 2.0;    // per T

scalar::Vec<Real> pack(Vec2 a) {
  return scalar::constant<Real>(a);
}

// m, from its goal: within it a robot stays in place, once it has been beside others for a while. A
// robot that has been at its goal and finds no route back settles farther and farther away. Where
// arrival distances are small, the unit is the radius: others push the robot aside by a part of
// their radii.
double settling_distance(const Detour& detour, double radius, double arrival_distance) {
  if (detour.beside < kSettles) return 0.0;
  const double unit = arrival_distance < kSmall * radius ? radius / arrival_distance : 1.0;
  const double growth = unit * std::clamp(kGrowth * (detour.beside - kPatience), 0.0, kMostGrowth);
  return (kSettleDistance + (detour.has_arrived ? growth : 0.0)) * arrival_distance;
}

// Returns whether it yields to neighbors at rest as well: for most of each try, on the last part of
// the route.
bool yields_to_all(const Robot& robot, const Detour& detour, double arrival_distance) {
  if (!is_near_goal(robot) || robot.distance_to_goal < kSettleDistance * arrival_distance)
    return false;
  const double tries = detour.beside / kTry;
  return tries - std::floor(tries) < kYields;
}

void remember(const Robot& robot, bool is_beside, const PlannerOptions& options, Detour& detour) {
  // a step longer than the largest count has the length of that count
  const double elapsed = std::min(options.time_step / time_to_speed(robot), kLongest);
  const bool is_near = is_near_goal(robot);
  const double beside = detour.beside;
  double next = is_near && is_beside ? beside + elapsed
                                     : beside - std::max(beside, kSettles) * elapsed / kRecovers;
  if (next > kLongest) next -= kTry * std::ceil((next - kLongest) / kTry);
  detour.beside = static_cast<float>(std::max(next, 0.0));
  detour.has_arrived = is_near && detour.beside > 0.0F &&
                       (detour.has_arrived || robot.distance_to_goal <= options.arrival_distance);
}

}  // namespace

double time_to_speed(double max_speed, double max_acceleration, double radius) {
  return std::max(max_speed / max_acceleration, kLeastTime * radius / max_speed);
}

double time_to_speed(const Robot& robot) {
  return time_to_speed(robot.max_speed, robot.max_acceleration, robot.radius);
}

bool is_sound(const Detour& detour) {
  return detour.angle >= 0.0F && detour.angle <= kMostDetour && detour.beside >= 0.0F &&
         detour.beside <= kLongest && detour.congestion >= 0.0F &&
         detour.congestion <= kCongestion && std::isfinite(detour.acceleration_x) &&
         std::isfinite(detour.acceleration_y);
}

double arrival_range(const Robot& robot, double largest_radius) {
  const Real range =
      scalar::traffic_range<Real>(robot.max_speed, planned_braking(robot), robot.radius);
  return std::max(range.value, (1.0 + kRoom) * (robot.radius + largest_radius));
}

Vec2 turned_right(Vec2 a, double angle) {
  return plain(scalar::turned_right(pack(a), Real(angle)));
}

double motion_of(const Robot& robot, const Neighbor& neighbor) {
  if (!is_near_goal(robot) || neighbor.radius > robot.radius) return 1.0;
  const double part = norm(neighbor.velocity) / robot.max_speed;
  return std::clamp((part - kAtRest) / (kInMotion - kAtRest), 0.0, 1.0);
}

double deference(double own, double other) {
  return scalar::deference(Real(own), Real(other)).value;
}

Vec2 push_of(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 away = robot.position - neighbor.position;
  const double contact = robot.radius + neighbor.radius, room = kRoom * contact;
  const double distance = norm(away);
  const double nearness = std::min((contact + room - distance) / room, 1.0);
  const double passing = norm(robot.velocity - neighbor.velocity) / robot.max_speed;
  const double en_route = kLeastWeight * std::max(1.0 - passing, 0.0);
  const double nearing = std::max(en_route, 1.0 - robot.distance_to_goal / (kLeash * contact));
  const double size = std::min(neighbor.radius / robot.radius, 1.0);
  return (nearing * size * nearness / distance) * away;
}

double unusual_congestion(double ahead, double time, double time_step, Detour& detour) {
  const double usual = detour.congestion;
  const double part = std::min(time_step / (kGetsUsed * time), 1.0);
  detour.congestion = static_cast<float>(usual + part * (std::min(ahead, kCongestion) - usual));
  return std::max(ahead - kUsual * detour.congestion, 0.0);
}

bool settles(const Robot& robot, const Detour& detour, double arrival_distance) {
  return robot.distance_to_goal < settling_distance(detour, robot.radius, arrival_distance);
}

PushRule push_rule(const Robot& robot, bool is_beside, const PlannerOptions& options,
                   Detour& detour) {
  remember(robot, is_beside, options, detour);
  const double arrival_distance = options.arrival_distance;
  if (settles(robot, detour, arrival_distance)) return {true, kPush, 0.0};
  return {false, kPush, yields_to_all(robot, detour, arrival_distance) ? kPushAtRest : 0.0};
}

Vec2 wish_of(const Robot& robot, Vec2 kept_right, const Traffic& traffic, const PushRule& rule) {
  if (rule.settles) return (kPush * robot.max_speed) * traffic.push;
  return kept_right +
         robot.max_speed * (kPush * traffic.push + rule.at_rest * traffic.push_at_rest);
}

double part_of_wish(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish) {
  const double unhindered = dot(unhindered_next_velocity, wish);
  return unhindered > 0.0 ? dot(next_velocity, wish) / unhindered : 1.0;
}

bool is_near_goal(double distance_to_goal, double radius) {
  return distance_to_goal < kNear * radius;
}

bool is_near_goal(const Robot& robot) {
  return is_near_goal(robot.distance_to_goal, robot.radius);
}

bool may_detour(const Robot& robot) {
  return robot.distance_to_goal >= robot.radius;
}

void turn_off(Detour& detour, const Robot& robot, double time_step, bool among_walls) {
  if (among_walls && detour.angle == kMostDetour) {
    detour.angle = 0.0F;
    return;
  }
  const double turn = kTurnOff * time_step / time_to_speed(robot);
  detour.angle = std::min(static_cast<float>(detour.angle + turn), kMostDetour);
}

void turn_back(Detour& detour, const Robot& robot, double time_step) {
  const double turn = kTurnBack * time_step / time_to_speed(robot);
  detour.angle = std::max(static_cast<float>(detour.angle - turn), 0.0F);
}

}  // namespace avo::inline planner
