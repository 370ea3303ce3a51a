// SPDX-License-Identifier: Apache-2.0
// Crowds that are sent to one point, and their judge.
#pragma once
#include <algorithm>
#include <vector>

#include "avo/check.h"
#include "avo/checked.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {

inline bool is_clear(const RobotSetup& robot, const std::vector<RobotSetup>& others) {
  return std::all_of(others.begin(), others.end(), [&](const RobotSetup& other) {
    return norm(disc_center(other) - disc_center(robot)) >
           disc_radius(other) + disc_radius(robot) + 0.02;
  });
}

inline Vec2 in_square(Random& random, double extent) {
  const double x = random.uniform(-0.5, 0.5);
  return extent * Vec2{x, random.uniform(-0.5, 0.5)};
}

// m. In exponential motion |x''''| <= a_max/δ², and a cubic through places and velocities errs by
// Δt⁴ |x''''|/384 at most.
inline double interpolation_error(const Scenario& scene, const RobotSetup& robot) {
  if (scene.motion != Motion::exponential) return 0.0;
  const PlannerOptions options = planner_options(scene);
  const double h = options.time_step, ratio = h / options.control_time;
  return ratio * ratio * h * h * robot.max_acceleration / 384.0;
}

inline Check judge_of(const Scenario& scene) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& setup : scene.robots) {
    robots.push_back(checked_robot(setup));
    robots.back().interpolation_error = interpolation_error(scene, setup);
    if (scene.clock == Clock::free && !is_parked(setup))
      robots.back().time_step = time_step_of(scene, setup);
  }
  std::vector<CheckedMover> people;
  for (const MovingObstacle& person : scene.moving_obstacles)
    people.push_back({.position = person.position, .radius = person.radius});
  // what the certificate promises
  Check check(robots, people, {.movers_at_rest = true});
  std::vector<CheckedWall> walls;
  for (const Wall& wall : walls_of(scene.obstacles)) walls.push_back({wall.a, wall.b, wall.radius});
  check.set_walls(walls);
  return check;
}

inline void observe(const Simulation& simulation, Check& check) {
  const MovingObstacleView people = simulation.moving_obstacles();
  for (std::size_t k = 0; k < people.setup.size(); ++k)
    check.place_mover(static_cast<std::int64_t>(k), people.position[k], people.velocity[k]);
  check.add(simulation.time(), checked_states(simulation.fleet()));
}

}  // namespace avo::test
