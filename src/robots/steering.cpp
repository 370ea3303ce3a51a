// SPDX-License-Identifier: Apache-2.0
// Where a car steers that cannot turn in place: towards its goal by pure pursuit (Coulter, CMU
// 1992), the circle that leaves along the heading and goes through the goal. A goal inside its
// turning circle it drives away from, until it is outside.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "robots/car.h"

namespace avo {
namespace {

constexpr double kEnough = 0.8;       // of a_max, that turning asks for
constexpr double kWiderCircle = 1.1;  // times the turning circle: goals outside are steered to
constexpr double kWidest = 4.0;       // times that circle: turned round on at most
constexpr double kNearEnough = 0.05;  // times its radius: nobody turns round for that
// It drives on in its direction until it had to turn by 90 degrees and more, by this cosine.
constexpr double kKeepDirection = 0.5;

// The way that it drives, and where that leads to, seen from the axle.
struct Aim {
  Vec2 ahead;       // unit, along the heading or against it
  double x, y;      // unit vector to the goal: ahead, to the left
  double distance;  // m
};

// Along the heading or against it: whichever is nearer to where it goes, and as it drives already
// where that is nearly as good.
Vec2 direction_of(const Car& car, const Robot& robot, Vec2 to) {
  const Vec2 heading = elementary::direction(robot.heading);
  if (!car.reverse) return heading;
  const double along = dot(heading, to), speed = dot(heading, robot.velocity);
  const double least = speed > 0.0 ? -kKeepDirection : speed < 0.0 ? kKeepDirection : 0.0;
  return along >= least ? heading : -heading;
}

// Velocities at more than 45 degrees become turns at full lock: as much across as ahead.
Vec2 bent(Vec2 ahead, double x, double y, double speed) {
  const Vec2 left = perpendicular(ahead);
  if (x >= std::abs(y)) return speed * (x * ahead + y * left);
  return speed * (ahead + std::copysign(1.0, y) * left);
}

// m/s: on a circle of that radius.
double cornering_speed(double max_acceleration, double radius) {
  return std::sqrt(kEnough * max_acceleration * radius);
}

}  // namespace

Vec2 steered(const Car& car, const Robot& robot) {
  const double speed = norm(robot.preferred_velocity);
  if (turns_in_place(car) || !(speed > 0.0)) return robot.preferred_velocity;
  const Vec2 to = robot.preferred_velocity / speed, ahead = direction_of(car, robot, to);
  const Aim aim{ahead, dot(ahead, to), cross(ahead, to), robot.distance_to_goal};
  const double turning = 1.0 / car.max_curvature, across = std::abs(aim.y);
  if (aim.distance <= kNearEnough * turning) return {};
  if (aim.distance < 2.0 * kWiderCircle * turning * across) {
    const double away = std::min(cornering_speed(robot.max_acceleration, turning), robot.max_speed);
    return away * aim.ahead;
  }
  // of the circle of pure pursuit
  const double radius =
      across > 0.0 ? aim.distance / (2.0 * across) : std::numeric_limits<double>::infinity();
  const double least = aim.x >= 0.0 ? radius : std::min(radius, kWidest * turning);
  const double top = cornering_speed(robot.max_acceleration, least);
  return bent(aim.ahead, aim.x, aim.y, std::min(speed, top));
}

Vec2 within_steering(const Car& car, const Robot& robot, Vec2 v) {
  const double speed = norm(v);
  if (turns_in_place(car) || !(speed > 0.0)) return v;
  const Vec2 to = v / speed, ahead = direction_of(car, robot, to);
  return bent(ahead, dot(ahead, to), cross(ahead, to), speed);
}

}  // namespace avo
