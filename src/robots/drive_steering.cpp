// SPDX-License-Identifier: Apache-2.0
// The steering of differential drives. As in drive.cpp, q is the point L ahead of the axle, and V
// its speed.
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/drive.h"

namespace avo::inline robots {
namespace {

// The wish stays this far within S, so that the drive can follow it to the end.
constexpr double kWithin = 1.0 - 0x1p-9;
constexpr double kNear = 2.0;         // [L], of the goal from the axle
constexpr double kNearEnough = 0.05;  // [L]: the drive does not turn round for less

// See within_steering(); h: its heading.
Vec2 within_steering(const DifferentialDrive& drive, const Robot& robot, Vec2 h, Vec2 v) {
  const double speed = norm(v);
  if (!(speed > 0.0)) return v;
  const Vec2 to = v / speed;
  const double most = kWithin * most_speed(drive, change_limit(robot), dot(h, to), cross(h, to));
  return std::min(speed, most) * to;
}

// A goal nearer to the axle than L would make the drive circle round it. With β the angle of the
// goal off the heading and d its distance, V cos β ahead and V sin β across make β' = V sin β (cos
// β/d - 1/L). With kNear L/d times as much across, β shrinks at any distance. It must not shrink
// faster than it can be stopped; then less of V is ahead. The drive moves backwards to a goal
// behind it. A velocity across the present heading has a part along the heading at the step's end,
// σ² Δt/L. On this part the drive would circle beside its goal for ever. So it steers by the
// heading that it will have.
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

// Far from its goal the drive moves straight to the goal, and turns as q does. If the goal is
// behind the drive, it first turns on the spot, as q goes round the axle. It turns right where both
// directions are equally long.
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
