// SPDX-License-Identifier: Apache-2.0
// Fleets drive among walls: no robot touches one, whatever the walls are and whichever robots join.
#include "support/walls.h"

#include <gtest/gtest.h>
#include <string>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"
#include "walls/wall_grid.h"

namespace avo {
namespace {

using test::gap_to;
using test::gap_to_all;
using test::Random;
using test::refusal;
using test::robot_at;

StaticObstacle piece(const Wall& wall) {
  return {{{wall.a == wall.b ? std::vector{wall.a} : std::vector{wall.a, wall.b}, false}},
          wall.radius};
}

constexpr double kSide = 20.0;

// Robots at rest among random walls, with goals anywhere.
Scenario walled_scene(std::uint64_t seed, int robots, Motion motion, bool cars = false) {
  Random random(seed);
  Scenario scene;
  scene.motion = motion;
  scene.duration = 60.0;
  const std::vector<Wall> walls = test::random_walls(random, kSide, 0.3);
  for (const Wall& wall : walls) scene.obstacles.push_back(piece(wall));
  while (static_cast<int>(scene.robots.size()) < robots) {
    RobotSetup setup =
        robot_at(test::free_place(random, walls, kSide, 0.31), test::in_square(random, kSide));
    setup.radius = 0.3;
    setup.max_speed = setup.preferred_speed = random.uniform(0.5, 2.5);
    setup.max_acceleration = random.uniform(0.5, 2.0);
    if (cars && random.below(3) == 0) {
      setup.model = Car{0.5};
      setup.heading = random.uniform(-3.0, 3.0);
    }
    bool is_free = true;
    for (const RobotSetup& other : scene.robots) {
      is_free = is_free && norm(other.position - setup.position) > 0.61;
    }
    if (is_free) scene.robots.push_back(setup);
  }
  return scene;
}

// m: least gap of all robots to all walls in one step of the simulation.
double step_and_measure(Simulation& simulation, const std::vector<Wall>& walls) {
  const PlannerOptions& options = simulation.planner().options();
  const FleetView before = simulation.fleet();
  std::vector<test::TrueStep> steps;
  for (std::size_t k = 0; k < before.id.size(); ++k) {
    steps.push_back({before.position[k], before.velocity[k], {}});
  }
  simulation.step();
  const FleetView after = simulation.fleet();
  double least = 1e300;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    steps[k].next_velocity = after.velocity[k];
    const double gap = !is_holonomic(after.setup[k].model)
                           ? gap_to_all(after.position[k], walls)
                           : test::least_gap(steps[k], walls, options);
    least = std::min(least, gap - after.setup[k].radius);
  }
  return least;
}

TEST(WalledFleets, thirty_robots_touch_no_wall) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(seed);
      const Scenario scene = walled_scene(seed, 30, motion, motion == Motion::held);
      ASSERT_TRUE(broken_assumptions(scene).none());
      const std::vector<Wall> walls = walls_of(scene.obstacles);
      Simulation simulation(scene, 2);
      double least = 1e300, way = 0.0;
      for (int k = 0; k < 400; ++k) {
        least = std::min(least, step_and_measure(simulation, walls));
        for (const Vec2 v : simulation.fleet().velocity) way += 0.1 * norm(v);
      }
      EXPECT_GT(least, 0.0);
      EXPECT_LT(least, 0.01) << "nobody came near";
      EXPECT_GT(way, 60.0);
      for (const Plan& plan : simulation.fleet().plan) {
        EXPECT_NE(plan.status, PlanStatus::overlapping);
      }
    }
  }
}

TEST(WalledFleets, those_that_movers_pass_touch_no_wall) {
  Scenario scene = walled_scene(5, 12, Motion::held);
  scene.moving_obstacles = {{{-4.0, 8.0}, {0.8, 0.1}, {}, 0.5},
                            {{9.0, 26.0}, {0.0, -0.6}, {}, 0.8}};
  const std::vector<Wall> walls = walls_of(scene.obstacles);
  Simulation simulation(scene, 1);
  double least = 1e300;
  for (int k = 0; k < 300; ++k) least = std::min(least, step_and_measure(simulation, walls));
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 0.1);
}

TEST(WalledFleets, without_walls_some_would_be_touched) {
  Scenario scene = walled_scene(1, 30, Motion::held);
  const std::vector<Wall> walls = walls_of(scene.obstacles);
  scene.obstacles.clear();
  Simulation simulation(scene, 2);
  double least = 1e300;
  for (int k = 0; k < 100; ++k) least = std::min(least, step_and_measure(simulation, walls));
  EXPECT_LT(least, -0.1);
}

// Their half-planes are harder than those of neighbors. Those of orca always allow to stop, those
// of avo_paper promise nothing.
TEST(WalledFleets, without_certificate_they_see_walls_as_well) {
  for (const Method method : {Method::avo_paper, Method::orca}) {
    Scenario scene = walled_scene(3, 15, Motion::held);
    scene.method = method;
    scene.certificate = Certificate::none;
    const std::vector<Wall> walls = walls_of(scene.obstacles);
    Simulation simulation(scene, 2);
    double least = 1e300;
    for (int k = 0; k < 300; ++k) least = std::min(least, step_and_measure(simulation, walls));
    EXPECT_GT(least, -1e-9) << to_string(method);
    EXPECT_LT(least, 0.05) << to_string(method);
  }
}

// All that can be touched within the horizon: more walls change no bit.
TEST(WalledFleets, without_certificate_they_know_the_walls_of_the_horizon) {
  for (const Method method : {Method::avo_paper, Method::orca}) {
    Scenario scene = walled_scene(4, 8, Motion::held);
    scene.obstacles = {piece({{-30.0, -30.0}, {-30.0, 40.0}}), piece({{24.0, -30.0}, {24.0, 40.0}}),
                       piece({{31.0, 0.0}, {31.0, 0.0}, 0.5})};
    scene.method = method;
    scene.certificate = Certificate::none;
    scene.navigation = false;
    for (RobotSetup& setup : scene.robots) setup.goal.x = 60.0;
    const std::vector<Wall> walls = walls_of(scene.obstacles);
    Simulation simulation(scene, 1);
    PlanWorkspace workspace;
    int cut = 0;
    for (int k = 0; k < 60; ++k) simulation.step();
    for (std::size_t i = 0; i < scene.robots.size(); ++i) {
      const auto seen = simulation.perceive({i});
      const auto plan = [&](std::span<const Wall> near) {
        return simulation.planner().plan(seen.robot, seen.neighbors, workspace, nullptr, near);
      };
      EXPECT_EQ(plan(seen.walls).new_velocity, plan(walls).new_velocity);
      cut += plan({}).new_velocity == plan(walls).new_velocity ? 0 : 1;
    }
    EXPECT_GT(cut, 0) << to_string(method);
  }
}

TEST(WalledFleets, any_number_of_threads_and_a_saved_state_go_on_alike) {
  const Scenario scene = walled_scene(7, 300, Motion::held);
  Simulation one(scene, 1), two(scene, 2);
  for (int k = 0; k < 60; ++k) one.step(), two.step();
  EXPECT_EQ(one.state_hash(), two.state_hash());
  Simulation continued(one.save(), 2);
  for (int k = 0; k < 30; ++k) one.step(), continued.step();
  EXPECT_EQ(one.state_hash(), continued.state_hash());
  EXPECT_EQ(one.save(), continued.save());
  Scenario other = scene;
  other.obstacles.pop_back();
  Simulation different(other, 1);
  different.restore(one.save());
  different.step(), one.step();
  EXPECT_EQ(different.state_hash(), one.state_hash());
}

// The grid is built anew for one that reaches farther.
TEST(WalledFleets, a_larger_and_faster_robot_may_join) {
  Scenario scene;
  scene.navigation = false;
  scene.sensing_radius = 200.0;
  scene.obstacles = {piece({{30.0, -20.0}, {30.0, 20.0}})};
  scene.robots = {robot_at({0.0, 0.0}, {5.0, 0.0})};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 20; ++k) simulation.step();
  RobotSetup fast = robot_at({-5.0, 8.0}, {60.0, 8.0});
  fast.radius = 2.0;
  fast.max_speed = fast.preferred_speed = 8.0;
  simulation.add_robot(fast);
  const std::vector<Wall> walls = walls_of(scene.obstacles);
  double least = 1e300;
  for (int k = 0; k < 300; ++k) least = std::min(least, step_and_measure(simulation, walls));
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 0.1);
}

TEST(WalledFleets, bad_obstacles_are_refused) {
  Scenario scene;
  scene.robots = {robot_at({0.0, 0.0}, {5.0, 0.0})};
  scene.obstacles = {piece({{3.0, 0.0}, {4.0, 0.0}})};
  EXPECT_EQ(refusal(scene), "");
  scene.obstacles[0].radius = -1.0;
  EXPECT_EQ(refusal(scene), "obstacles.0.radius: found -1, must be >= 0 m");
  scene.obstacles[0] = {{{{}, false}}};
  EXPECT_EQ(refusal(scene),
            "obstacles.0.chains: found one without points, must be of a point at least");
  scene.obstacles[0] = piece({{3.0, 0.0}, {4.0, 1e300}});
  EXPECT_EQ(refusal(scene), "obstacles.0.points.1: found 1e+300, must be <= 1e+12 m");
  scene.obstacles[0] = piece({{3.0, 0.0}, {4.0, 0.0}});
  scene.robots[0].radius = 0.002;
  EXPECT_NE(refusal(scene).find("robots.0.radius: found 0.002, must be > 0.0025"),
            std::string::npos);
  Simulation simulation(walled_scene(3, 2, Motion::held), 1);
  EXPECT_THROW(simulation.add_robot(scene.robots[0]), Error);
}

TEST(WallStarts, those_too_near_or_too_fast_are_told) {
  Scenario scene;
  scene.obstacles = {piece({{-50.0, 0.0}, {50.0, 0.0}}), piece({{0.0, 30.0}, {0.0, 30.0}, 1.0})};
  const auto start = [](Vec2 position, Vec2 velocity) {
    RobotSetup setup = robot_at(position, position);
    setup.velocity = velocity;
    return setup;
  };
  scene.robots = {start({0.0, 0.5 + 1e-9}, {}), start({5.0, 1.5}, {0.0, -1.6}),
                  start({10.0, 2.0}, {1.6, 0.0}), start({20.0, -0.3}, {}), start({0.0, 31.4}, {})};
  const BrokenAssumptions broken = broken_assumptions(scene);
  ASSERT_EQ(broken.beside_count, 3);
  EXPECT_FALSE(broken.none());
  EXPECT_EQ(broken.beside[0].robot, RobotId{1});
  EXPECT_DOUBLE_EQ(broken.beside[0].distance, 1.5);
  EXPECT_NEAR(broken.beside[0].kept, 1.5 - 1.6 * 1.6 / 2.0, 0.01);
  EXPECT_EQ(broken.beside[1].robot, RobotId{3});
  EXPECT_DOUBLE_EQ(broken.beside[1].distance, 0.3);
  EXPECT_NEAR(broken.beside[1].required, 0.5, 1e-9);
  EXPECT_GT(broken.beside[1].required, 0.5);
  EXPECT_EQ(broken.beside[2].robot, RobotId{4});
  EXPECT_EQ(broken.beside[2].obstacle, ObstacleId{1});
}

TEST(WallStarts, solids_and_bounds_have_an_inside) {
  const auto square = [](double low, double high) {
    return Chain{{{low, low}, {high, low}, {high, high}, {low, high}}, true};
  };
  Scenario scene;
  scene.obstacles = {{{square(-20.0, 20.0)}, 0.0, Fill::bounds},
                     {{square(-10.0, 10.0), square(-5.0, 5.0)}, 0.0, Fill::solid}};
  const auto misplaced = [&scene](Vec2 p) -> int {
    scene.robots = {robot_at(p, p)};
    const BrokenAssumptions broken = broken_assumptions(scene);
    EXPECT_EQ(broken.beside_count, 0);
    if (broken.misplaced_count == 0) return -1;
    return static_cast<int>(broken.misplaced.front().obstacle.value);
  };
  EXPECT_EQ(misplaced({15.0, 0.0}), -1);
  EXPECT_EQ(misplaced({25.0, 0.0}), 0);
  EXPECT_EQ(misplaced({7.0, 1.0}), 1);
  EXPECT_EQ(misplaced({7.0, -7.0}), 1);
  EXPECT_EQ(misplaced({1.0, 1.0}), -1) << "a hole of it";
  scene.obstacles[1].fill = Fill::none;
  EXPECT_EQ(misplaced({7.0, 1.0}), -1);
}

TEST(WallGrid, lists_all_walls_within_their_reach) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double side = random.log_uniform(1.0, 1e3);
    std::vector<Wall> walls;
    std::vector<double> reach;
    for (int k = 0; k < 40; ++k) {
      const Vec2 a = test::in_square(random, side), b = test::in_square(random, side);
      const double bend = random.below(3) == 0 ? 0.0 : random.log_uniform(1e-3, 1.0);
      walls.push_back({a, random.below(4) == 0 ? Vec2{b.x, a.y} : a + bend * (b - a)});
      reach.push_back(random.log_uniform(1e-2, 0.3) * side);
    }
    const WallGrid grid(walls, reach);
    for (int k = 0; k < 300; ++k) {
      const Vec2 p = 1.6 * test::in_square(random, side) - Vec2{0.3 * side, 0.3 * side};
      const std::span<const Wall> near = grid.near(p);
      std::size_t place = 0;  // by their index
      for (std::size_t w = 0; w < walls.size(); ++w) {
        const bool is_listed = place < near.size() && near[place].a == walls[w].a;
        place += is_listed ? 1 : 0;
        if (gap_to(p, walls[w]) <= reach[w]) {
          EXPECT_TRUE(is_listed);
        }
      }
      EXPECT_EQ(place, near.size());
    }
  }
}

}  // namespace
}  // namespace avo
