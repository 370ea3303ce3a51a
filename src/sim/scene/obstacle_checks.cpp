// SPDX-License-Identifier: Apache-2.0
// Decides which obstacles can be simulated: moving and static ones.
#include <cstddef>
#include <string>
#include <string_view>

#include "core/ranges.h"
#include "fields/scene_fields.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

void check_max_speed(std::size_t k, const MovingObstacle& obstacle) {
  const std::string_view list = "moving_obstacles";
  const double most = *obstacle.max_speed;
  if (!(obstacle.max_deviation > 0.0))
    refuse(std::string(Place{list, k, "max_speed"}), text(most),
           "left out without max_deviation: it keeps its acceleration");
  if (!(obstacle.acceleration == Vec2{}))
    refuse(std::string(Place{list, k, "acceleration"}), text(obstacle.acceleration),
           "[0, 0] with max_speed, which it would exceed");
  if (norm(obstacle.velocity) > most)
    refuse(std::string(Place{list, k, "velocity"}), text(obstacle.velocity),
           "at most max_speed = " + text(most) + " m/s long");
}

void check_trajectory(std::size_t k, const MovingObstacle& obstacle) {
  const auto at = [&](std::string_view field) {
    return std::string(Place{"moving_obstacles", k, field});
  };
  const std::string beside = " beside a trajectory";
  if (!obstacle.path.empty()) refuse(at("path"), "one", "left out" + beside);
  if (!(obstacle.acceleration == Vec2{}))
    refuse(at("acceleration"), text(obstacle.acceleration), "[0, 0]" + beside);
  const TimedPlace* before = nullptr;
  for (const TimedPlace& place : obstacle.trajectory) {
    require(Place{"moving_obstacles", k, "trajectory"}, place.time, kAnyValue, "s");
    require(Place{"moving_obstacles", k, "trajectory"}, place.position, "m");
    if (before != nullptr && !(place.time > before->time))
      refuse(at("trajectory"), text(place.time) + " s after " + text(before->time) + " s",
             "ascending times");
    const double speed = before != nullptr
                             ? norm(place.position - before->position) / (place.time - before->time)
                             : 0.0;
    if (!(speed <= kLargest))
      refuse(at("trajectory"), text(speed) + " m/s", "at most " + text(kLargest) + " m/s");
    if (obstacle.max_speed && speed > *obstacle.max_speed * (1.0 + 1e-9))
      refuse(at("max_speed"), text(*obstacle.max_speed),
             ">= " + text(speed) + " m/s, what its trajectory has");
    before = &place;
  }
  const PathWalk start = on_trajectory(obstacle, 0.0);
  if (!(obstacle.position == start.position))
    refuse(at("position"), text(obstacle.position),
           text(start.position) + ", where its trajectory has it at 0 s");
  if (!(obstacle.velocity == start.velocity))
    refuse(at("velocity"), text(obstacle.velocity),
           text(start.velocity) + ", what its trajectory has at 0 s");
}

void check_obstacle(std::size_t k, const MovingObstacle& obstacle) {
  require_ranges(obstacle, PlaceOf{"moving_obstacles", k});
  if (obstacle.max_speed) check_max_speed(k, obstacle);
  if (!obstacle.trajectory.empty()) check_trajectory(k, obstacle);
  if (obstacle.path.empty()) return;
  if (!obstacle.max_speed)
    refuse(std::string(Place{"moving_obstacles", k, "path"}), "one",
           "left out without max_speed and max_deviation, within which it is followed");
  for (const Vec2 point : obstacle.path) require(Place{"moving_obstacles", k, "path"}, point, "m");
}

void check_static_obstacle(std::size_t k, const StaticObstacle& obstacle) {
  const std::string_view list = "obstacles";
  require(Place{list, k, "radius"}, obstacle.radius, kNotNegative, "m");
  if (obstacle.chains.empty() && obstacle.fill != Fill::solid)  // a plan may have nothing solid
    refuse(std::string(Place{list, k, "chains"}), "none", "one at least");
  for (const Chain& chain : obstacle.chains) {
    if (chain.points.empty())
      refuse(std::string(Place{list, k, "chains"}), "one without points", "of a point at least");
    for (const Vec2 point : chain.points) require(Place{list, k, "points"}, point, "m");
  }
}

// A measurement of the past is extrapolated from the past state, which is not stored for an
// obstacle on a path.
void check_paths(const Scenario& scenario) {
  const SensingModel& sensing = scenario.sensing;
  if (sensing.delay == 0 && !sensing.misses()) return;
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k) {
    if (!scenario.moving_obstacles[k].path.empty())
      refuse(std::string(Place{"moving_obstacles", k, "path"}), "one",
             "left out where sensing has delay, dropped or occlusion");
  }
}

}  // namespace

void check_obstacles(const Scenario& scenario) {
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k)
    check_obstacle(k, scenario.moving_obstacles[k]);
  check_paths(scenario);
  for (std::size_t k = 0; k < scenario.obstacles.size(); ++k)
    check_static_obstacle(k, scenario.obstacles[k]);
}

}  // namespace avo::inline sim
