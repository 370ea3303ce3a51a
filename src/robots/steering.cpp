// SPDX-License-Identifier: Apache-2.0
// The steering of a car that cannot turn in place. It drives towards its goal by pure pursuit
// (Coulter, CMU 1992), on the circle that begins along the heading and passes through the goal. If
// the goal is inside its turning circle, the car drives away until the goal is outside. It drives
// straight ahead, or straight back where it may drive backwards.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/car.h"

namespace avo::inline robots {
namespace {

constexpr double kEnough = 0.8;       // of a_max, used for turning
constexpr double kWiderCircle = 1.1;  // times the turning circle: goals outside are steered to
// the same for a car that may drive backwards and does not drive to the goal
constexpr double kWellOutside = 1.3;
// While it accelerates, less is left of the sweep of its disc that others expect: per offset.
constexpr double kWhileStarting = 0.6;
constexpr double kWidest = 4.0;  // times that circle: the largest circle of a turn round
constexpr double kTurnInPlaceCosine = 0.96891242171064473;  // of kTurnInPlace
// It keeps its direction until it had to turn by at least 90 degrees, by this cosine.
constexpr double kKeepDirection = 0.5;

// Along the heading or against it: the direction nearer to its target, or the present direction
// where that is nearly as good.
Vec2 direction_of(const Car& car, const Robot& robot, Vec2 to) {
  const Vec2 heading = ahead_of(robot.heading);
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

// m/s: the speed on a circle of that radius.
double cornering_speed(double max_acceleration, double radius) {
  return std::sqrt(kEnough * max_acceleration * radius);
}

// m/s: a speed from which it stops at its goal although it first turns, by a sine y. The turn takes
// v y/a, in which it does not brake. A car that may drive backwards comes back if it could not
// stop.
double stopping_speed(const Car& car, const Robot& robot, double y) {
  if (car.reverse) return std::numeric_limits<double>::infinity();
  return std::sqrt(2.0 * planned_braking(robot) * robot.distance_to_goal /
                   (1.0 + 2.0 * std::abs(y)));
}

// The least radius of the circle to the goal, in radii of the turning circle.
double least_radius(const Car& car, const Robot& robot, Vec2 to) {
  if (!car.reverse) return kWiderCircle;
  if (dot(robot.velocity, to) > 0.0) return 1.0;
  return std::max(kWellOutside, 1.0 + kWhileStarting * std::abs(offset_of(car)) * sharpest(car));
}

// m, of the circle of pure pursuit
double pursuit_radius(double distance, double y) {
  return y == 0.0 ? std::numeric_limits<double>::infinity() : distance / (2.0 * std::abs(y));
}

}  // namespace

Vec2 steered_along(const Car& car, const Robot& robot, Vec2 ahead) {
  const double speed = norm(robot.preferred_velocity), turning = 1.0 / sharpest(car);
  const Vec2 to = robot.preferred_velocity / speed;
  const double x = dot(ahead, to), y = cross(ahead, to);
  const double radius = std::max(turning, pursuit_radius(robot.distance_to_goal, y));
  const double wide = x >= 0.0 ? radius : std::min(radius, kWidest * turning);
  const double top =
      std::min(cornering_speed(robot.max_acceleration, wide), stopping_speed(car, robot, y));
  return bent(ahead, x, y, std::min(speed, top));
}

// A car that turns in place would turn to and fro at its goal. Its disc swings there, and rounding
// leaves a part of the distance.
Vec2 steered(const Car& car, const Robot& robot, const Approach& approach) {
  const double speed = norm(robot.preferred_velocity);
  if (!(speed > 0.0)) return robot.preferred_velocity;
  const bool turns = turns_in_place(car), there = is_there(car, robot, approach);
  if (turns && !(there && is_rest(robot.velocity))) return robot.preferred_velocity;
  const Vec2 to = robot.preferred_velocity / speed, ahead = direction_of(car, robot, to);
  const double x = dot(ahead, to), y = cross(ahead, to), distance = robot.distance_to_goal;
  if (turns) return x < kTurnInPlaceCosine ? Vec2{} : robot.preferred_velocity;
  if (there) return {};
  const double turning = 1.0 / sharpest(car);
  const double radius = pursuit_radius(distance, y);
  if (radius < least_radius(car, robot, to) * turning) {
    const double away = std::min(cornering_speed(robot.max_acceleration, turning), robot.max_speed);
    return away * (car.reverse && x > 0.0 ? -ahead : ahead);
  }
  return steered_along(car, robot, ahead);
}

Vec2 within_steering(const Car& car, const Robot& robot, Vec2 v) {
  const double speed = norm(v);
  if (turns_in_place(car) || !(speed > 0.0)) return v;
  const Vec2 to = v / speed, ahead = direction_of(car, robot, to);
  return bent(ahead, dot(ahead, to), cross(ahead, to), speed);
}

}  // namespace avo::inline robots
