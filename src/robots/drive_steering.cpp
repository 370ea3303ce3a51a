// SPDX-License-Identifier: Apache-2.0
// Where differential drives steer. As in drive.cpp, q is the point L ahead of the axle, and V its
// speed.
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/drive.h"

namespace avo::inline robots {
namespace {

// What is wished for stays so much within S, so that it can be followed to the end.
constexpr double kWithin = 1.0 - 0x1p-9;
constexpr double kNear = 2.0;         // [L], of the goal from the axle
constexpr double kNearEnough = 0.05;  // [L]: nobody turns round for that

// See within_steering(); h: its heading.
Vec2 within_steering(const DifferentialDrive& drive, const Robot& robot, Vec2 h, Vec2 v) {
  const double speed = norm(v);
  if (!(speed > 0.0)) return v;
  const Vec2 to = v / speed;
  const double most = kWithin * most_speed(drive, change_limit(robot), dot(h, to), cross(h, to));
  return std::min(speed, most) * to;
}

// Where the goal is nearer to the axle than L, that would circle round it: with β the angle of the
// goal off the heading and d its distance, V cos β ahead and V sin β across make
// β' = V sin β (cos β/d - 1/L). With as much across as kNear L/d times that, β shrinks at any
// distance. It may shrink no faster than it can be stopped, and then less of V is ahead. A goal
// behind it is there driven to backwards. A velocity that is across the heading of now has a part
// along that of the step's end, σ² Δt/L, on which the drive would circle beside its goal for ever:
// it steers by the heading that it will have.
Vec2 steered_near(const DifferentialDrive& drive, const Robot& robot, const Approach& approach) {
  const double distance = robot.distance_to_goal;
  if (distance <= std::min(kNearEnough * drive.offset, approach.near_enough)) return {};
  const Vec2 wish = robot.preferred_velocity, now = ahead_of(robot.heading);
  const double turned = approach.time_step * cross(now, robot.velocity) / drive.offset;
  const Vec2 h = elementary::direction(robot.heading + turned);
  const double speed = norm(wish), along = dot(h, wish) / speed, across = cross(h, wish) / speed;
  const double needed = kNear * drive.offset / distance * std::abs(across);
  const double turn =
      std::min(needed * speed, std::sqrt(robot.max_acceleration * drive.offset * std::abs(across)));
  const double ahead = needed > 0.0 ? std::min(speed * std::abs(along), turn / needed) : speed;
  const Vec2 side = across * along < 0.0 ? -perpendicular(h) : perpendicular(h);
  return within_steering(drive, robot, now, std::copysign(ahead, along) * h + turn * side);
}

}  // namespace

// Far from its goal it heads for it at once, and turns as q does. One that has its goal behind it
// first turns on the spot, by q going round the axle; to the right where both ways are as long.
Vec2 steered(const DifferentialDrive& drive, const Robot& robot, const Approach& approach) {
  const Vec2 wish = robot.preferred_velocity, h = ahead_of(robot.heading);
  const double speed = norm(wish);
  if (!(speed > 0.0)) return wish;
  const double along = dot(h, wish) / speed, across = cross(h, wish) / speed;
  if (robot.distance_to_goal < kNear * drive.offset)
    return approach.at_once ? steered_near(drive, robot, approach)
                            : within_steering(drive, robot, h, wish);
  const Vec2 turning = across > 0.0 ? perpendicular(h) : -perpendicular(h);
  return within_steering(drive, robot, h, along < 0.0 ? speed * turning : wish);
}

Vec2 within_steering(const DifferentialDrive& drive, const Robot& robot, Vec2 v) {
  return within_steering(drive, robot, ahead_of(robot.heading), v);
}

}  // namespace avo::inline robots
