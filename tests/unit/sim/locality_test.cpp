// SPDX-License-Identifier: Apache-2.0
// What a robot does depends on what it senses, and on nothing else.
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "avo/check.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

// One robot drives to its goal among moving obstacles.
Scenario among_movers(Method method) {
  Scenario scene;
  scene.method = method;
  scene.duration = 20.0;
  scene.robots = {{.position = {-10.0, 0.0}, .velocity = {1.0, 0.0}, .goal = {10.0, 0.0}}};
  scene.sensing_radius = 15.0;
  scene.moving_obstacles = {{.position = {0.0, 5.0}, .velocity = {0.0, -0.8}},
                            {.position = {4.0, -9.0}, .velocity = {-0.1, 1.0}},
                            {.position = {3.0, 0.2}, .velocity = {-0.4, 0.0}}};
  return scene;
}

TEST(Locality, a_robot_a_kilometer_away_changes_no_bit_of_a_path_among_movers) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle}) {
    for (const bool capped : {false, true}) {
      Scenario scene = among_movers(method);
      if (capped) scene.max_neighbors = 1;
      Simulation alone(scene, 1);
      scene.robots.push_back({.position = {1000.0, 0.0}, .goal = {1020.0, 0.0}});
      Simulation together(scene, 1);
      int among = 0;
      for (int k = 0; k < 200; ++k) {
        among += alone.perceive({0}).among_movers ? 1 : 0;
        EXPECT_EQ(together.perceive({0}).among_movers, alone.perceive({0}).among_movers);
        alone.step();
        together.step();
        ASSERT_EQ(alone.fleet().position[0], together.fleet().position[0])
            << to_string(method) << ", step " << k;
        ASSERT_EQ(alone.fleet().plan[0].status, together.fleet().plan[0].status);
      }
      EXPECT_GT(among, 100);
      if (!avoids_union(method)) {
        EXPECT_FALSE(together.perceive({1}).among_movers);  // it senses no neighbor
      }
    }
  }
}

// A second robot comes into the sensing radius in the midst of an encounter, and leaves it. The
// manner of planning changes there and back, and no robot is touched while it moves.
TEST(Locality, switching_within_an_encounter_keeps_the_promise) {
  test::Random random(5);
  int switches = 0;
  for (int run = 0; run < 60; ++run) {
    Scenario scene;
    scene.sensing_radius = 7.0;
    scene.duration = 30.0;
    const int robots = 2 + random.below(3);
    for (int k = 0; k < robots; ++k) {
      const Vec2 way = random.direction();
      const double across = random.uniform(-3.0, 3.0);
      const Vec2 aside{-way.y * across, way.x * across};
      scene.robots.push_back({.position = 9.0 * way + aside, .goal = -9.0 * way + aside});
    }
    for (int k = 0; k < 4; ++k) {
      const Vec2 way = random.direction();
      scene.moving_obstacles.push_back({.position = random.uniform(1.0, 5.0) * way,
                                        .velocity = random.uniform(0.0, 1.0) * random.direction(),
                                        .radius = random.uniform(0.2, 0.6)});
    }
    const auto apart = [&](const RobotSetup& a) {
      return std::ranges::all_of(scene.robots, [&](const RobotSetup& b) {
        return &a == &b || norm(a.position - b.position) > 1.1;
      });
    };
    if (!std::ranges::all_of(scene.robots, apart)) continue;
    Simulation simulation(scene, 1);
    std::vector<CheckedRobot> judged;
    for (const RobotSetup& robot : scene.robots) {
      judged.push_back({.radius = robot.radius, .goal = robot.goal});
    }
    std::vector<CheckedMover> obstacles;
    for (const MovingObstacle& o : scene.moving_obstacles) {
      obstacles.push_back({o.position, o.velocity, o.acceleration, o.radius});
    }
    Check check(judged, obstacles);
    std::vector<bool> before(scene.robots.size());
    for (int k = 0; k < 300; ++k) {
      std::vector<CheckedState> rows;
      const FleetView fleet = simulation.fleet();
      for (std::size_t i = 0; i < fleet.id.size(); ++i) {
        rows.push_back({static_cast<std::int64_t>(i), fleet.position[i], fleet.velocity[i]});
        const bool now = simulation.perceive({i}).among_movers;
        switches += now != before[i] ? 1 : 0;
        before[i] = now;
      }
      check.add(simulation.time(), rows);
      simulation.step();
    }
    const CheckReport report = check.report();
    EXPECT_EQ(report.overlaps.count, 0) << run;
    EXPECT_EQ(report.mover_contacts_moving.count, 0) << run;
    EXPECT_EQ(report.accelerations.count, 0) << run;
  }
  EXPECT_GT(switches, 200);
}

}  // namespace
}  // namespace avo
