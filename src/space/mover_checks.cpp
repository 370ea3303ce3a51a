// SPDX-License-Identifier: Apache-2.0
#include "space/mover_checks.h"

#include <algorithm>
#include <string>

#include "avo/error.h"
#include "fields/space_fields.h"
#include "space/senses.h"

namespace avo::space {
namespace {

// m/s: of its legs.
double fastest_leg(const MovingObstacle& obstacle) {
  double fastest = 0.0;
  for (std::size_t k = 1; k < obstacle.trajectory.size(); ++k) {
    const TimedPoint &a = obstacle.trajectory[k - 1], &b = obstacle.trajectory[k];
    fastest = std::max(fastest, norm(b.position - a.position) / (b.time - a.time));
  }
  return fastest;
}

void check_trajectory(const MovingObstacle& obstacle, const std::string& place_of) {
  const std::string key = place_of + "trajectory";
  for (std::size_t i = 0; i < obstacle.trajectory.size(); ++i) {
    const TimedPoint& place = obstacle.trajectory[i];
    require(key, place.time, kAnyValue, "s");
    require(key, place.position, "m");
    if (i > 0 && !(place.time > obstacle.trajectory[i - 1].time))
      refuse(key, text(place.time) + " s after " + text(obstacle.trajectory[i - 1].time) + " s",
             "ascending times");
  }
  if (!(obstacle.acceleration == Vec3{}))
    refuse(place_of + "acceleration", "one", "[0, 0, 0] beside a trajectory");
  const double speed = fastest_leg(obstacle);
  if (obstacle.max_speed && speed > *obstacle.max_speed * (1.0 + 1e-9))
    refuse(place_of + "max_speed", text(*obstacle.max_speed),
           ">= " + text(speed) + " m/s, what its trajectory has");
}

}  // namespace

void check_moving_obstacle(const MovingObstacle& obstacle, const std::string& key) {
  require_ranges(obstacle, Behind{key});
  if (!obstacle.trajectory.empty()) check_trajectory(obstacle, key);
  if (!obstacle.max_speed) return;
  if (!(obstacle.max_deviation > 0.0))
    refuse(key + "max_speed", text(*obstacle.max_speed),
           "left out without max_deviation: it keeps its acceleration");
  if (!(obstacle.acceleration == Vec3{}))
    refuse(key + "acceleration", "one", "[0, 0, 0] with max_speed, which it would exceed");
  if (norm(obstacle.velocity) > *obstacle.max_speed)
    refuse(key + "velocity", text(norm(obstacle.velocity)) + " m/s",
           "<= max_speed = " + text(*obstacle.max_speed) + " m/s");
}

void check_moving_obstacles(const Scenario& scenario) {
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k) {
    const MovingObstacle& obstacle = scenario.moving_obstacles[k];
    check_moving_obstacle(obstacle, "moving_obstacles." + std::to_string(k) + ".");
    const Vec3 start = state_at(obstacle, 0.0).position;
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      const Robot robot = robot_of(scenario.robots[i]);
      const double depth = robot.radius + obstacle.radius - norm(robot.position - start);
      if (depth > 0.0)
        throw Error("robots." + std::to_string(i) + " and moving_obstacles." + std::to_string(k) +
                    ": they overlap by " + text(depth) + " m at the start; move them apart");
    }
  }
}

double mover_range(const Scenario& scenario, const Robot& largest, const PlannerOptions& options) {
  const double fastest = largest.max_speed * std::max(largest.vertical, 1.0);
  double range = 0.0;
  for (const MovingObstacle& obstacle : scenario.moving_obstacles) {
    Mover mover = mover_at(obstacle, 0.0);
    // |v + t a| is largest at one of the ends
    const Vec3 last = obstacle.velocity + scenario.duration * obstacle.acceleration;
    const double speed =
        std::max({norm(obstacle.velocity), norm(last), fastest_leg(obstacle),
                  obstacle.max_deviation > 0.0 ? obstacle.max_speed.value_or(0.0) : 0.0});
    mover.velocity = {speed, 0.0, 0.0};
    range = std::max(
        range, sensing_range(largest, mover, options) + (fastest + speed) * time_unseen(scenario));
  }
  return range;
}

}  // namespace avo::space
