// SPDX-License-Identifier: Apache-2.0
// Moving obstacles go to and fro on paths that robots know, or their trajectories are predicted
// (docs/movers.md, "Known trajectories").
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/mover_scenes.h"

namespace avo {
namespace {

using test::mover;
using test::one_robot;
using test::robot_at;

// The moving obstacle goes to and fro between two points or more, from anywhere on its path.
MovingObstacle to_and_fro(test::Random& random, double x) {
  const double tilt = random.uniform(-1.5, 1.5), length = random.uniform(3.0, 6.0);
  const double middle = random.uniform(-1.5, 1.5), speed = random.uniform(0.8, 2.0);
  const Vec2 a{x - tilt, middle - length}, b{x + tilt, middle + length};
  const Vec2 along = (b - a) / norm(b - a);
  MovingObstacle m = mover(a + random.uniform(0.0, 1.0) * (b - a), (0.9 * speed) * along,
                           random.uniform(0.3, 1.0));
  m.max_deviation = random.uniform(0.7, 2.0), m.max_speed = speed;
  m.path = {b, a};
  if (random.below(2) == 0) std::swap(m.path[0], m.path[1]), m.velocity = -m.velocity;
  if (random.below(4) == 0) m.path.insert(m.path.begin() + 1, {x + random.uniform(-2, 2), middle});
  return m;
}

// The moving obstacles go across the course of the robot.
Scenario among_paths(test::Random& random, int count, double time_step) {
  Scenario scene = one_robot({-10, 0}, {10, 0}, time_step);
  scene.sensing_radius = 20.0;
  for (int k = 0; k < count; ++k)
    scene.moving_obstacles.push_back(
        to_and_fro(random, -6.0 + 12.0 * (k + random.uniform(0.2, 0.8)) / count));
  return scene;
}

// m, least room beside movers on their paths; infinite where a robot has not arrived.
double room_beside_paths(const Scenario& scene) {
  Simulation simulation(scene, 1);
  const double h = scene.time_step;
  std::vector<PathWalk> walks;
  for (const MovingObstacle& m : scene.moving_obstacles) walks.push_back({m.position, m.velocity});
  double least = std::numeric_limits<double>::infinity();
  for (double time = 0.0; time < 60.0; time += h) {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> p(before.position.begin(), before.position.end());
    const std::vector<Vec2> v(before.velocity.begin(), before.velocity.end());
    simulation.step();
    for (std::size_t j = 0; j < walks.size(); ++j) {
      const PathWalk walk = walks[j];
      walks[j] = next_on_path(scene.moving_obstacles[j], walk, h);
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 change =
            simulation.fleet().velocity[i] - v[i] - walks[j].velocity + walk.velocity;
        for (int part = 1; part <= 16; ++part) {
          const double t = h * part / 16.0;
          const Vec2 apart =
              p[i] - walk.position + t * (v[i] - walk.velocity) + (0.5 * t * t / h) * change;
          least = std::min(least,
                           norm(apart) - scene.moving_obstacles[j].radius - scene.robots[i].radius);
        }
      }
    }
  }
  EXPECT_TRUE(simulation.all_at_goal());
  return least;
}

// By its velocity alone such a moving obstacle leaves for ever. The limits of the obstacle make the
// robot stop on its path.
TEST(Evasion, nobody_is_hit_by_movers_that_come_back_on_their_paths) {
  for (const double y : {0.0, 1.0, 2.0}) {
    Scenario scene = one_robot({-10, y}, {10, y}, 0.1);
    scene.sensing_radius = 20.0;
    for (const Vec2 p : {Vec2{-2, -4}, Vec2{3, 4}}) {
      MovingObstacle m = mover(p, {0, p.y < 0.0 ? 1.0 : -1.0}, 1.0);
      m.max_deviation = 1.0, m.max_speed = 1.5, m.path = {{p.x, -p.y}, p};
      scene.moving_obstacles.push_back(m);
    }
    EXPECT_GE(room_beside_paths(scene), 0.0) << y;
  }
  test::Random random(38);
  for (const double time_step : {0.1, 0.05, 0.2}) {
    for (int trial = 0; trial < 8; ++trial)
      EXPECT_GE(room_beside_paths(among_paths(random, 1 + trial % 4, time_step)), 0.0)
          << time_step << " s, " << trial;
  }
}

// What is known of the future is no part of what is saved: it is found anew, to the last bit.
TEST(Evasion, knows_paths_when_it_is_restored) {
  test::Random random(39);
  for (int trial = 0; trial < 4; ++trial) {
    Simulation simulation(among_paths(random, 3, 0.1), 1);
    for (int step = 10 + 31 * trial; step > 0; --step) simulation.step();
    Simulation restored(simulation.save(), 1);
    for (int step = 0; step < 150; ++step) {
      const Simulation::Perception seen = restored.perceive({0});
      ASSERT_FALSE(seen.neighbors.empty());
      EXPECT_NE(seen.neighbors[0].trajectory, nullptr);
      simulation.step(), restored.step();
      ASSERT_EQ(simulation.state_hash(), restored.state_hash()) << trial << ", step " << step;
    }
  }
}

// On board: others are predicted with corners in time, at times that are no steps of the robot's.
TEST(Evasion, of_movers_whose_trajectories_are_predicted) {
  test::Random random(40);
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  int turned = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Robot robot{.position = {-6, 0}, .radius = 0.4};
    std::vector<Trajectory> trajectories;
    for (int k = 0; k < 2; ++k) {
      std::vector<TimedPlace> places{{-1.0, random.uniform(4.0, 9.0) * random.direction()}};
      if (norm(places[0].position - robot.position) < 4.0) places[0].position.x += 8.0;
      for (int leg = 0; leg < 5; ++leg) {
        const double lasts = random.uniform(0.7, 4.0);
        const Vec2 v = random.uniform(0.0, 1.8) * random.direction();
        places.push_back({places.back().time + lasts, places.back().position + lasts * v});
      }
      trajectories.emplace_back(places);
    }
    Detour detour;
    double least = std::numeric_limits<double>::infinity();
    bool was_safe = true;
    for (int step = 0; step < 250; ++step) {
      const double now = 0.1 * step;
      std::vector<Neighbor> neighbors;
      for (const Trajectory& trajectory : trajectories) {
        const Vec2 p = trajectory.at(now);
        neighbors.push_back({.position = p,
                             .velocity = (trajectory.at(now + 1e-6) - p) / 1e-6,
                             .radius = 0.6,
                             .behavior = Behavior::moves_on,
                             .trajectory = &trajectory,
                             .trajectory_time = now});
      }
      const Vec2 way = Vec2{6, 0} - robot.position;
      robot.preferred_velocity = std::min(1.0, 2.0 / std::max(norm(way), 1e-9)) * way;
      if (norm(robot.preferred_velocity) > 2.0)
        robot.preferred_velocity =
            (2.0 / norm(robot.preferred_velocity)) * robot.preferred_velocity;
      robot.distance_to_goal = norm(way);
      const Plan plan = planner.plan(robot, neighbors, workspace, &detour);
      if (step == 0) was_safe = plan.status != PlanStatus::overlapping;
      for (int part = 1; part <= 8; ++part) {
        const double t = 0.1 * part / 8.0;
        const Vec2 at = robot.position + t * robot.velocity +
                        (0.5 * t * t / 0.1) * (plan.next_velocity - robot.velocity);
        for (const Trajectory& trajectory : trajectories)
          least = std::min(least, norm(at - trajectory.at(now + t)) - 1.0);
      }
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    EXPECT_TRUE(was_safe) << trial;
    EXPECT_GE(least, 0.0) << trial;
    turned += least < 0.4 ? 1 : 0;
  }
  EXPECT_GT(turned, 10) << "most are met";
}

}  // namespace
}  // namespace avo
