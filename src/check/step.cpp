// SPDX-License-Identifier: Apache-2.0
// What moves over one step of a recording, and its pairs seen as relative paths.
#include "check/step.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace avo::judge {
namespace {

// Differences first: far from the origin the rows are coarse, their differences are exact.
RelativePath cubic(Vec2 from, Vec2 from_velocity, Vec2 to, Vec2 to_velocity, double duration) {
  const double third = duration / 3.0;
  return {{from, from + third * from_velocity, to - third * to_velocity, to}};
}

// By how much the cubic may be off the arc of a car, m. With speed v, its change a and curvature κ,
//   p'''' = (3 a² κ - v⁴ κ³) n - 6 a v² κ² e,   e along the heading, n across,
// and a cubic through positions and velocities errs by at most Δt⁴ |p''''|/384. At rest there is no
// heading to tell κ from; but |p''| <= a_max, and ∫|K(u, s)| ds of the interpolation's Peano kernel
// is at most 1/16, at u = 1/2.
double arc_error(const CheckedState& before, const CheckedState& now, double max_acceleration,
                 double duration) {
  const double any = max_acceleration * duration * duration / 16.0;
  const double from = norm(before.velocity), to = norm(now.velocity);
  if (!(from > 0.0 && to > 0.0)) return any;
  const double turn =
      elementary::atan2(cross(before.velocity, now.velocity), dot(before.velocity, now.velocity));
  const double change = std::abs(to - from) * duration;  // a Δt², m
  const double top = std::max(from, to);
  const double rate = std::abs(turn) * top / (0.5 * (from + to));  // v κ Δt, rad
  const double along = 6.0 * change * rate * rate;
  const double way = top * duration;
  const double across = 3.0 * change * change * rate / way + way * rate * rate * rate;
  return std::min(any, (along + across) / 384.0);
}

}  // namespace

Mover robot_mover(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                  double duration) {
  Mover mover{before.position, before.velocity,           now.position, now.velocity,
              robot.radius,    robot.interpolation_error, now.robot};
  if (robot.car) mover.error += arc_error(before, now, robot.max_acceleration, duration);
  if (robot.straight)
    mover.from_velocity = mover.to_velocity = (now.position - before.position) / duration;
  return mover;
}

Mover newcomer(const CheckedRobot& robot, const CheckedState& now) {
  Mover mover{now.position, now.velocity, now.position,
              now.velocity, robot.radius, robot.interpolation_error,
              now.robot};
  mover.newcomer = true;
  return mover;
}

Place place_of(const CheckedObstacle& obstacle, double time) {
  const double t = time;
  return {obstacle.position + t * (obstacle.velocity + (0.5 * t) * obstacle.acceleration),
          obstacle.velocity + t * obstacle.acceleration};
}

Mover obstacle_mover(const Place& from, const Place& to, double radius, std::int64_t index) {
  Mover mover{from.position, from.velocity, to.position, to.velocity, radius, 0.0, index};
  mover.obstacle = true;
  return mover;
}

RelativePath path_of(const Mover& mover, double duration, Vec2 origin) {
  const Vec2 to = mover.to - origin;
  if (mover.newcomer) return {{to, to, to, to}};
  return cubic(mover.from - origin, mover.from_velocity, to, mover.to_velocity, duration);
}

RelativePath relative_path(const Mover& a, const Mover& b, double duration) {
  const Vec2 to = a.to - b.to;
  if (end_only(a, b)) return {{to, to, to, to}};
  return cubic(a.from - b.from, a.from_velocity - b.from_velocity, to,
               a.to_velocity - b.to_velocity, duration);
}

Box box_of(const Mover& mover, std::size_t owner, double duration) {
  return box_around(path_of(mover, duration).control, mover.radius, owner);
}

double speed_bound(const Mover& mover, double from_fraction, double to_fraction, double duration) {
  if (mover.newcomer) return norm(mover.to_velocity);
  const double third = duration / 3.0;
  const Vec2 d0 = third * mover.from_velocity, d2 = third * mover.to_velocity;
  const Vec2 d1 = (mover.to - mover.from) - (d0 + d2);
  // the quadratic with control points 3d, blossomed: its control points over the part
  const auto blossom = [&](double s, double t) {
    return (1.0 - s) * ((1.0 - t) * d0 + t * d1) + s * ((1.0 - t) * d1 + t * d2);
  };
  const double longest = std::max({norm(blossom(from_fraction, from_fraction)),
                                   norm(blossom(from_fraction, to_fraction)),
                                   norm(blossom(to_fraction, to_fraction))});
  return 3.0 * longest / duration;
}

}  // namespace avo::judge
