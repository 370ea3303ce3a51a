// SPDX-License-Identifier: Apache-2.0
#include "space/mover_checks.h"

#include <algorithm>
#include <string>

#include "avo/error.h"
#include "fields/space_fields.h"
#include "guidance/names.h"
#include "space/certificate.h"
#include "space/mover_constraints.h"
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

// Refuses contact, and what braking comes to touch, in the words of the plane. slack: m, what
// braking leaves beyond contact.
void check_start(const Robot& robot, const Mover& mover, const StepLaw& law, double slack,
                 RobotId id, MovingObstacleId obstacle) {
  constexpr double kRounded = 1e-9;
  constexpr int kDigits = 9;
  const double contact = robot.radius + mover.radius;
  const double distance = norm(robot.position - mover.position);
  const double depth = std::min(contact, parabola_error(mover, law) - slack);
  const bool overlaps = distance < (1.0 - kRounded) * contact;
  if (!overlaps && !(depth > kRounded * contact)) return;
  const std::string name = "robot " + std::to_string(id.value);
  const std::string pair = name + " and moving obstacle " + std::to_string(obstacle.value);
  if (overlaps)
    throw Error(pair + " overlap at the start: found " + number(distance, kDigits) +
                " m between the centers, must be >= " + number(robot.radius, kDigits) + " + " +
                number(mover.radius, kDigits) + " = " + number(contact, kDigits) +
                " m; move them apart");
  throw Error(pair + " start too fast for their distance: found " + number(depth, kDigits) +
              " m of overlap when " + name +
              " brakes at once, must be none; slow down, or move apart");
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
  }
}

void check_mover_starts(std::span<const Robot> robots, std::span<const Mover> movers,
                        std::span<const MovingObstacleId> ids, StepLaw law) {
  law.sensing_error = {};  // starts are true states
  Constraints constraints;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    begin_constraints(robots[k], braking_of(robots[k], law), law, constraints);
    for (std::size_t m = 0; m < movers.size(); ++m) {
      begin_movers(robots[k], movers.subspan(m, 1), constraints.own, constraints.own_direction,
                   constraints.deviation, law, constraints.movers);
      check_start(robots[k], movers[m], law, constraints.movers.invariant.slack, {k}, ids[m]);
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
