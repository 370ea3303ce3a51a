// SPDX-License-Identifier: Apache-2.0
// Arriving: keep right in traffic, yield, back out of a jam (docs/arrival.md). These rules only
// turn the preferred velocity, so that safety never depends on them. They are local, deterministic,
// and the same for every robot.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"

namespace avo::inline planner {

inline constexpr double kMostKeepRight = 30.0 * (3.14159265358979323846 / 180.0);  // rad
// robots right ahead that make the route fully congested
inline constexpr double kCongestion = 2.8;
inline constexpr double kSlow = 0.05;  // of v_max: below it a robot ahead counts in full
// of v_max: a robot that moves away this fast does not count
inline constexpr double kCloses = 0.2;
inline constexpr double kInFront = 0.1;  // cosine: nearer to abeam, a robot counts less
/// Part of the velocity along the wish that the limits alone allow: with less, a robot is blocked.
inline constexpr double kBlocked = 0.7;
// part of the same velocity: with less, it begins to change to a detour,
inline constexpr double kFree = 0.95;
inline constexpr double kStuck = 0.45;  // and with less than this part, it follows the detour alone
/// A clearance below this part of r_A + r_B is nearly contact.
inline constexpr double kRoom = 0.25;

/// A robot's view of its neighbors.
struct Traffic {
  /// Number of robots ahead within the range that close in or are nearly at rest, weighted by
  /// nearness.
  double ahead = 0.0;
  bool is_beside = false;  ///< whether a neighbor is nearly in contact
  Vec2 push;               ///< away from them, the part for their motion, see push_of()
  Vec2 push_at_rest;       ///< and the part for neighbors at rest
};

/// [T] s, v_max/a_max, and at least the time in which a robot moves four radii.
double time_to_speed(double max_speed, double max_acceleration, double radius);
double time_to_speed(const Robot& robot);

/// m, the range of look_around() for neighbors of at most that radius.
double arrival_range(const Robot& robot, double largest_radius);

/// 0 to 1: the part of a neighbor's push that counts for a robot that yields to moving neighbors,
/// near its goal. A neighbor that rests beside it has probably reached its own goal. It is 1 for a
/// larger neighbor, and for all neighbors on the rest of the route.
double motion_of(const Robot& robot, const Neighbor& neighbor);

/// The weight of the push of a neighbor of another priority; 1 where both are equal.
double deference(double own, double other);

/// The push away from a neighbor that is nearly in contact. It is less from a smaller neighbor, and
/// greater near the goal. On the rest of the route it is less from a neighbor that passes by.
Vec2 push_of(const Robot& robot, const Neighbor& neighbor);

/// Returns whether it is a value that a robot can remember.
bool is_sound(const Detour& detour);

/// Returns how much more congested the route ahead is than the robot is used to; the robot
/// remembers that. A robot that keeps right for ever never arrives. time: T, s.
double unusual_congestion(double ahead, double time, double time_step, Detour& detour);

/// Returns whether a robot that has been beside others for a while stays in place, near its goal.
bool settles(const Robot& robot, const Detour& detour, double arrival_distance);

/// How a robot follows the pushes of its neighbors: their factors, of v_max.
struct PushRule {
  bool settles = false;  ///< it stays in place, and wishes nothing but to move aside
  double moving = 0.0, at_rest = 0.0;
};
/// Updates the detour.
PushRule push_rule(const Robot& robot, bool is_beside, const PlannerOptions& options,
                   Detour& detour);

/// [m/s] The wish of a robot: the velocity that keeps right, or 0 where it has settled. In both
/// cases it moves aside for neighbors that push.
Vec2 wish_of(const Robot& robot, Vec2 kept_right, const Traffic& traffic, const PushRule& rule);

/// a turned clockwise by an angle in [0, π) rad, approximately; its length is kept.
Vec2 turned_right(Vec2 a, double angle);

/// The remaining part of the velocity along `wish` that the limits alone allow; 1 where they allow
/// none.
double part_of_wish(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish);

/// Returns whether the robot is on the last part of its route, where it yields only to moving
/// neighbors.
bool is_near_goal(const Robot& robot);
bool is_near_goal(double distance_to_goal, double radius);

/// Returns whether the robot may leave its route at all; it may not where it has nearly arrived.
bool may_detour(const Robot& robot);

/// Turns off further while the detour is also blocked; among walls it starts again from the route.
/// Turns back once the route is free.
void turn_off(Detour& detour, const Robot& robot, double time_step, bool among_walls);
void turn_back(Detour& detour, const Robot& robot, double time_step);

}  // namespace avo::inline planner
