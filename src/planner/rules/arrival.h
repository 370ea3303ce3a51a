// SPDX-License-Identifier: Apache-2.0
// Arriving: keep right in traffic, give way, back out of a jam (docs/arrival.md). All of it only
// turns the preferred velocity, so that safety never depends on it; local, deterministic, the same
// for every robot.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"

namespace avo::inline planner {

inline constexpr double kMostKeepRight = 30.0 * (3.14159265358979323846 / 180.0);  // rad
inline constexpr double kCongestion = 2.8;  // robots right ahead that make the way fully congested
inline constexpr double kSlow = 0.05;       // of v_max: so slow, a robot ahead counts in full
inline constexpr double kCloses = 0.2;      // of v_max: that fast it moves away who does not count
inline constexpr double kInFront = 0.1;     // cosine: nearer to abeam, a robot counts less
/// Of the velocity along the wish that the limits alone allow: with less, a robot is blocked.
inline constexpr double kBlocked = 0.7;
inline constexpr double kFree = 0.95;   // likewise: with less, it begins to go over to a detour,
inline constexpr double kStuck = 0.45;  // and with less than that, it goes on the detour alone
/// The clearance that is nearly contact, of r_A + r_B.
inline constexpr double kRoom = 0.25;

/// What a robot sees of its neighbors.
struct Traffic {
  /// Robots ahead within the range that close in or are nearly at rest, weighted by how near they
  /// are.
  double ahead = 0.0;
  bool is_beside = false;  ///< some are nearly in contact
  Vec2 push;               ///< away from them as far as they move, see push_of()
  Vec2 push_at_rest;       ///< and as far as they rest
};

/// [T] s, v_max/a_max, and at least the time in which a robot goes four radii.
double time_to_speed(double max_speed, double max_acceleration, double radius);
double time_to_speed(const Robot& robot);

/// m, as far as look_around() looks at any neighbor of at most that radius.
double arrival_range(const Robot& robot, double largest_radius);

/// 0 to 1: what counts of its push to one that gives way to those that move, near its goal; who
/// rests beside it has come to its own goal. 1 of a larger one, and on the way of all.
double motion_of(const Robot& robot, const Neighbor& neighbor);

/// Away from a neighbor that is nearly in contact: less from a smaller one, the more the nearer the
/// goal, and on the way less from one that passes by.
Vec2 push_of(const Robot& robot, const Neighbor& neighbor);

/// Whether it is something that a robot can remember.
bool is_sound(const Detour& detour);

/// By how much the way ahead is more congested than what the robot is used to, which it remembers:
/// to keep right for ever gets nobody anywhere. time: T, s.
double unusual_congestion(double ahead, double time, double time_step, Detour& detour);

/// [m/s] which way a robot wishes to go: as it keeps right, or nowhere where it has settled, and in
/// both cases out of the way of those that push.
Vec2 wish_of(const Robot& robot, Vec2 kept_right, const Traffic& traffic,
             const PlannerOptions& options, Detour& detour);

/// a turned clockwise by an angle in [0, π) rad, nearly; its length is kept.
Vec2 turned_right(Vec2 a, double angle);

/// What is left of the velocity along `wish` that the limits alone allow; 1 where they allow none.
double part_of_wish(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish);

/// Whether it is on the last of its way, where it gives way to those that move.
bool is_near_goal(const Robot& robot);
bool is_near_goal(double distance_to_goal, double radius);

/// Whether the robot may leave its way at all: not where it has all but arrived.
bool may_detour(const Robot& robot);

/// Turns off further while the detour is blocked as well, among walls all over again from the way,
/// and back once the way is free.
void turn_off(Detour& detour, const Robot& robot, double time_step, bool among_walls);
void turn_back(Detour& detour, const Robot& robot, double time_step);

}  // namespace avo::inline planner
