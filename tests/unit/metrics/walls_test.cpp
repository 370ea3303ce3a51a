// SPDX-License-Identifier: Apache-2.0
// What a run is said to have done beside static obstacles, against brute force.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <vector>

#include "avo/metrics.h"
#include "runs.h"
#include "support/generators.h"
#include "support/segment_distance.h"

namespace avo {
namespace {

using test::robot_at;

StaticObstacle wall_between(Vec2 a, Vec2 b, double radius = 0.0) {
  return {{{{a, b}}}, radius};
}

// Whatever the robots plan: at 2 m/s, 0.6 m and 0.7 m before a wall, they cannot stop.
TEST(Metrics, robots_that_touch_static_obstacles_are_counted_once) {
  Scenario scene = blind({cruising({0, 0}, {9, 0}), cruising({0, 9}, {9, 9}),
                          robot_at({0, 40}, {0, 40}), robot_at({0, 50}, {0, 50})});
  scene.obstacles = {wall_between({0.6, -5}, {0.6, 5}),
                     wall_between({0.65, -5}, {0.65, 5}),
                     wall_between({1.0, 5}, {1.0, 12}, 0.3),
                     wall_between({2, 42}, {20, 42}),
                     {{{{{5, 50}}}}, 4.25}};
  const RunSummary summary = run(scene, 10);
  EXPECT_EQ(summary.static_collisions, 2);
  EXPECT_EQ(summary.mover_collisions, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_LT(*summary.min_static_clearance, -0.1);
  scene.robots.erase(scene.robots.begin(), scene.robots.begin() + 2);
  EXPECT_EQ(run(scene, 0).static_collisions, 0);
  EXPECT_NEAR(*run(scene, 0).min_static_clearance, 0.25, 1e-12) << "of the disc";
  scene.obstacles.clear();
  EXPECT_FALSE(run(scene, 10).min_static_clearance);
}

TEST(Metrics, contact_with_a_static_obstacle_begins_at_a_billionth_of_the_radii) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const double overlap : {-1e-10, 0.0, 0.9e-9, 1.1e-9, 1e-3}) {
      Scenario scene = blind({robot_at({0, 0}, {0, 0})});
      scene.robots[0].radius = 0.5 * scale;
      const double y = scale * (1.0 - overlap);
      scene.obstacles = {wall_between({-scale, y}, {scale, y}, 0.5 * scale)};
      const RunSummary summary = run(scene, 0);
      EXPECT_EQ(summary.static_collisions, overlap > 1e-9 ? 1 : 0) << scale << " " << overlap;
      EXPECT_NEAR(*summary.min_static_clearance, -overlap * scale, 1e-15 * scale);
    }
  }
}

// The clearance from walls, from the equations of motion and samples of each step.
double slow_wall_clearance(const Scenario& scene, int steps, std::set<std::size_t>& touched) {
  const std::vector<Wall> walls = walls_of(scene.obstacles);
  double least = std::numeric_limits<double>::infinity();
  for_each_step(scene, steps, [&](const FleetView& fleet, const auto& place) {
    for (std::size_t i = 0; i < fleet.id.size(); ++i) {
      for (int n = 0; n <= 200; ++n) {
        const Vec2 at = place(i, scene.time_step * n / 200.0);
        for (const Wall& wall : walls) {
          const double clearance =
              test::slow_segment_distance(at, wall.a, wall.b) - wall.radius - fleet.setup[i].radius;
          least = std::min(least, clearance);
          if (clearance < -1e-3) touched.insert(i);
        }
      }
    }
  });
  return least;
}

TEST(Metrics, min_obstacle_clearance_is_that_of_all_walls) {
  test::Random random(21);
  for (const Method method : {Method::avo_paper, Method::orca}) {
    for (const Motion motion : {Motion::held, Motion::exponential}) {
      for (const double half : {6.0, 60.0}) {
        Scenario scene = blind({});
        scene.method = method;
        scene.motion = motion;
        for (int i = 0; i < 6; ++i) {
          const Vec2 start{random.uniform(-half, half), random.uniform(-half, half)};
          scene.robots.push_back(cruising(start, start + 30.0 * random.direction()));
          scene.robots.back().radius = random.uniform(0.1, 0.5);
        }
        for (int k = 0; k < 40; ++k) {
          const Vec2 a{random.uniform(-half, half), random.uniform(-half, half)};
          const double radius = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
          if (random.below(3) == 0)
            scene.obstacles.push_back({{{{a}}}, radius + 0.1});
          else
            scene.obstacles.push_back(
                wall_between(a, a + random.log_uniform(0.1, 50.0) * random.direction(), radius));
        }
        std::set<std::size_t> touched;
        const RunSummary summary = run(scene, 30);
        // samples are up to 1 cm apart
        EXPECT_NEAR(*summary.min_static_clearance, slow_wall_clearance(scene, 30, touched), 5e-3);
        EXPECT_GE(summary.static_collisions, static_cast<std::int64_t>(touched.size()));
        EXPECT_EQ(*summary.min_static_clearance<-1e-9, summary.static_collisions> 0);
      }
    }
  }
}

// Cars push into the corners of a room. Cubics through the ends of their steps cut the walls.
TEST(Metrics, cars_touch_no_wall_that_their_arcs_do_not_touch) {
  Scenario scene;
  test::Random random(4);
  for (int k = 0; k < 12; ++k) {
    const Vec2 start{1.5 * (k % 4), 1.5 * (k / 4)};
    RobotSetup car = robot_at(start, start + 30.0 * random.direction());
    car.radius = random.uniform(0.2, 0.5);
    car.max_acceleration = random.uniform(0.5, 3.0);
    car.model = Car{2.0 * car.radius}, car.heading = random.uniform(-3.0, 3.0);
    scene.robots.push_back(car);
  }
  scene.navigation = false;
  scene.obstacles = {{{{{{-2, -2}, {7, -2}, {8, 3}, {4, 8}, {-3, 4}}, true}}}};
  const RunSummary summary = run(scene, 400);
  EXPECT_EQ(summary.static_collisions, 0);
  EXPECT_GT(*summary.min_static_clearance, 0.0);
  EXPECT_LT(*summary.min_static_clearance, 1e-9);
}

// A robot turns round before a wall within one long step, where the cubic is millimeters off.
TEST(Metrics, static_obstacles_are_approached_by_the_equations_of_motion) {
  Scenario scene = blind({robot_at({0, 0}, {0, 100})});
  scene.motion = Motion::exponential;
  scene.time_step = scene.control_time.value();
  scene.robots[0].velocity = {0, -1};
  scene.obstacles = {wall_between({-50, -3}, {50, -3})};
  std::set<std::size_t> touched;
  EXPECT_NEAR(*run(scene, 1).min_static_clearance, slow_wall_clearance(scene, 1, touched), 1e-4);
}

TEST(Metrics, each_step_is_judged_among_the_obstacles_of_its_time) {
  const Scenario scene = blind({cruising({0, 0}, {90, 0})});
  for (const int closed : {3, 4, 5}) {
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    metrics.observe(simulation);
    for (int k = 0; k < 9; ++k) {
      if (k == closed) simulation.add_obstacle(wall_between({2.0, -3}, {2.0, 3}));
      simulation.step();
      metrics.observe(simulation);
      if (k == closed) simulation.remove_obstacle({0});
    }
    // step k brings the front to 0.5 + 0.2 (k + 1)
    EXPECT_NEAR(*metrics.summary().min_static_clearance, 1.3 - 0.2 * closed, 0.01);
    EXPECT_EQ(metrics.summary().static_collisions, 0);
    EXPECT_TRUE(metrics.summary().unreachable.empty());
  }
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  simulation.add_obstacle(wall_between({0.6, -3}, {0.6, 3}));
  simulation.step();
  metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().static_collisions, 1);
}

TEST(Metrics, who_stands_beyond_a_wall_has_not_arrived) {
  Scenario scene = blind({robot_at({0, -0.2}, {0, 0.2}), robot_at({9, -0.2}, {9, 0.2})});
  for (RobotSetup& robot : scene.robots) robot.radius = 0.1;
  scene.obstacles = {wall_between({-1, 0}, {1, 0})};
  EXPECT_EQ(run(scene, 0).arrived, 1);
}

TEST(Metrics, who_cannot_reach_its_goal_is_told) {
  Scenario scene = blind({robot_at({0, 0}, {9, 0}), robot_at({0, 4}, {9, 4})});
  scene.obstacles = {{{{{{8, -1}, {10, -1}, {10, 1}, {8, 1}}, true}}}};
  EXPECT_EQ(run(scene, 1).unreachable, (std::vector<std::uint64_t>{0}));
  scene.obstacles[0].chains[0].closed = false;
  EXPECT_TRUE(run(scene, 1).unreachable.empty());
}

}  // namespace
}  // namespace avo
