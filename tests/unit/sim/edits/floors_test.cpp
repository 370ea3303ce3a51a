// SPDX-License-Identifier: Apache-2.0
// Static obstacles that robots of some layers heed: floors above each other.
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>

#include "avo/assumptions.h"
#include "avo/metrics.h"
#include "avo/navigator.h"
#include "avo/reachability.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/judged.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::refusal;

constexpr LayerSet kGround{1}, kUpper{2};

RobotSetup on_floor(LayerSet floor, Vec2 position, Vec2 goal) {
  RobotSetup robot = test::robot_at(position, goal);
  robot.layers = robot.avoids = floor;
  return robot;
}

StaticObstacle wall_of(LayerSet floor, Vec2 a, Vec2 b) {
  return {.chains = {{{a, b}}}, .layers = floor};
}

// A storey with a wall, in which there is a door, and robots on both sides.
Scenario storey(LayerSet floor, const std::vector<Wall>& walls, int robots, double turn) {
  Scenario scene{.sensing_radius = 15.0};
  scene.obstacles = {test::pieces(walls)};
  scene.obstacles.front().layers = floor;
  for (int k = 0; k < robots; ++k) {
    const double side = k % 2 == 0 ? -1.0 : 1.0;
    const Vec2 place{side * (8.0 + 1.3 * (k / 8)), 1.7 * (k / 2 % 4) - 2.5 + 0.11 * k};
    RobotSetup robot = on_floor(floor, place, {-place.x, place.y * turn});
    robot.radius = 0.4;
    scene.robots.push_back(robot);
  }
  return scene;
}

Scenario together(const Scenario& first, const Scenario& second) {
  Scenario both = first;
  both.robots.insert(both.robots.end(), second.robots.begin(), second.robots.end());
  both.obstacles.insert(both.obstacles.end(), second.obstacles.begin(), second.obstacles.end());
  return both;
}

// The first storey of a building moves as it does alone: walls, routes, claims of passages, goals.
TEST(Floors, another_storey_changes_no_bit) {
  const Scenario ground = storey(kGround, test::doorway(1.6), 24, -1.0);
  const Scenario upper = storey(kUpper, test::corridor(1.6), 20, 1.0);
  Scenario roof = storey({4}, test::doorway(1.6), 16, -1.0);
  roof.obstacles.clear();
  for (const auto& [first, second] : {std::pair(ground, upper), std::pair(upper, ground),
                                      std::pair(roof, ground), std::pair(ground, roof)}) {
    Simulation both(together(first, second), 2), alone(first, 1);
    for (int step = 0; step < 200; ++step) {
      both.step(), alone.step();
      for (std::size_t k = 0; k < first.robots.size(); ++k)
        ASSERT_EQ(both.fleet().position[k], alone.fleet().position[k]) << step << " " << k;
    }
    EXPECT_EQ(both.is_at_goal({0}), alone.is_at_goal({0}));
    EXPECT_EQ(both.route({1}).length, alone.route({1}).length);
  }
}

// The same storeys, by the judge and the metrics: no robot touches a wall of its storey, and walls
// of the other storey do not count.
TEST(Floors, are_judged_by_their_own_walls) {
  const Scenario scene =
      together(storey(kGround, test::doorway(1.6), 24, -1.0),
               storey(kUpper, {{{-9, 0.9}, {9, 0.9}}, {{-9, -3.4}, {9, -3.4}}}, 0, 1.0));
  Scenario crossing = scene;
  crossing.robots.push_back(on_floor(kUpper, {-8, -1}, {8, -1}));
  EXPECT_TRUE(broken_assumptions(crossing).none());
  EXPECT_TRUE(out_of_reach(crossing).empty());
  test::Judged judged(crossing, 1);
  Metrics metrics(crossing);
  metrics.observe(judged.simulation);
  for (int step = 0; step < 500; ++step) judged.step(), metrics.observe(judged.simulation);
  EXPECT_TRUE(judged.report().safe());
  EXPECT_EQ(metrics.summary().static_collisions, 0);
  EXPECT_GT(metrics.summary().min_static_clearance, -1e-9);
  EXPECT_TRUE(judged.simulation.is_at_goal({24}));
  EXPECT_NEAR(judged.simulation.robot({24}).position.y, -1.0, 1e-9)
      << "no wall of its storey there";
  crossing.robots.back().layers = {3};  // it is on both storeys, and starts in the door's wall
  crossing.robots.back().position = {0, 4};
  EXPECT_EQ(broken_assumptions(crossing).beside_count, 1);
}

// A robot that heeds one more wall than another one yields at the same door.
TEST(Floors, robots_that_heed_other_walls_share_passages) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.obstacles.push_back(wall_of(kUpper, {-4, 9}, {4, 9}));
  scene.robots = {test::robot_at({-9, 0}, {9, 0}), test::robot_at({8, 0}, {-8, 0})};
  Simulation one_floor(scene, 1);
  scene.robots[1].layers = {3};
  Simulation simulation(scene, 1);
  bool waits = false;
  for (int step = 0; step < 400; ++step) {
    simulation.step(), one_floor.step();
    waits = waits || simulation.wait({0}) || simulation.wait({1});
    ASSERT_EQ(simulation.fleet().position[0], one_floor.fleet().position[0]) << step;
  }
  EXPECT_TRUE(waits);
  EXPECT_TRUE(simulation.all_at_goal());
}

TEST(Floors, hide_robots_by_the_walls_of_the_one_that_looks) {
  Scenario scene;
  scene.sensing.occlusion = true;
  scene.obstacles = {wall_of(kUpper, {0, -3}, {0, 3})};
  scene.robots = {test::robot_at({-2, 0}, {-2, 0}), test::robot_at({2, 0}, {2, 0})};
  scene.robots[0].layers = {3};
  Simulation simulation(scene, 1);
  EXPECT_TRUE(simulation.perceive({0}).neighbors.empty());
  EXPECT_EQ(simulation.perceive({1}).neighbors.size(), 1u);
}

TEST(Floors, answer_queries_of_their_layers) {
  Scenario scene;
  scene.obstacles = {wall_of(kGround, {5, -3}, {5, 3}),
                     wall_of(kUpper, {8, -3}, {8, 3}),
                     {.chains = {{{{-9, -9}, {-6, -9}, {-6, -6}, {-9, -6}}, true}},
                      .fill = Fill::solid,
                      .layers = kUpper}};
  scene.robots = {on_floor(kUpper, {3, 0}, {3, 0})};
  const Simulation simulation(scene, 1);
  const auto first = [&](LayerSet layers) {
    return simulation.cast_ray({0, 0}, {20, 0}, 0.0, layers);
  };
  EXPECT_TRUE(first(kAllLayers)->robot);
  EXPECT_EQ(first(kGround)->obstacle->value, 0u);
  EXPECT_TRUE(first(kUpper)->robot);
  EXPECT_FALSE(first({4}));
  EXPECT_TRUE(simulation.is_in_sight({4, 0}, {6, 0}, 0.0, kUpper));
  EXPECT_FALSE(simulation.is_in_sight({4, 0}, {6, 0}, 0.0, kGround));
  EXPECT_FALSE(simulation.is_in_sight({4, 0}, {6, 0}));
  EXPECT_TRUE(simulation.is_free({5, 0}, 0.5, kUpper));
  EXPECT_FALSE(simulation.is_free({5, 0}, 0.5));
  EXPECT_TRUE(simulation.is_free({3, 0}, 0.5, kGround));
  EXPECT_FALSE(simulation.is_free({3, 0}, 0.5, kUpper));
  EXPECT_TRUE(simulation.is_free({-7.5, -7.5}, 0.5, kGround));
  EXPECT_FALSE(simulation.is_free({-7.5, -7.5}, 0.5, kUpper)) << "inside of a solid";
}

// A door closes on one storey; a robot of the other one stands there.
TEST(Floors, are_edited_apart) {
  Scenario scene;
  scene.robots = {on_floor(kGround, {0, 0}, {8, 0}), on_floor(kUpper, {0, 0}, {8, 0})};
  Simulation simulation(scene, 1);
  EXPECT_NE(refusal([&] { simulation.add_obstacle(wall_of(kUpper, {0.3, -4}, {0.3, 4})); }), "");
  simulation.remove_robot({1});
  const ObstacleId door = simulation.add_obstacle(wall_of(kUpper, {0.3, -4}, {0.3, 4}));
  EXPECT_NEAR(simulation.route({0}).length, 8.0, 1e-9) << "not on its storey";
  RobotSetup beside = on_floor(kUpper, {-1, 3}, {8, 3});
  const RobotId guest = simulation.add_robot(beside);
  EXPECT_GT(simulation.route(guest).length, 9.1) << "around the wall";
  beside.position = {0.3, 0};
  EXPECT_NE(refusal([&] { simulation.add_robot(beside); }), "");
  RobotSetup ground = simulation.setup({0});
  ground.layers = kUpper;  // it stands on the wall of that storey
  EXPECT_NE(refusal([&] { simulation.change_robot({0}, ground); }).find("obstacle 0"),
            std::string::npos);
  simulation.remove_obstacle(door);
  simulation.change_robot({0}, ground);
  EXPECT_NEAR(simulation.route(guest).length, 9.0, 1e-9);
  EXPECT_EQ(simulation.setup(guest).layers, kUpper);
}

// A lift: the host changes the layers of a robot that stands there, and it goes on by the routes of
// the other storey.
TEST(Floors, are_changed_in_a_lift) {
  Scenario scene;
  scene.obstacles = {wall_of(kUpper, {0, -6}, {0, 2}), wall_of(kGround, {0, -2}, {0, 6})};
  scene.robots = {on_floor(kGround, {-2, 0}, {2, 0})};
  Simulation simulation(scene, 1);
  const double below = simulation.route({0}).next.y;
  RobotSetup robot = simulation.setup({0});
  robot.layers = robot.avoids = kUpper;
  simulation.change_robot({0}, robot);
  EXPECT_LT(below, -2.0);
  EXPECT_GT(simulation.route({0}).next.y, 2.0);
  for (int step = 0; step < 120; ++step) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
}

std::uint64_t hash_after(Simulation& simulation, int steps) {
  for (int step = 0; step < steps; ++step) simulation.step();
  return simulation.state_hash();
}

TEST(Floors, are_saved_and_restored) {
  const Scenario scene = together(storey(kGround, test::doorway(1.6), 16, -1.0),
                                  storey(kUpper, test::corridor(1.6), 16, 1.0));
  Simulation simulation(scene, 2);
  hash_after(simulation, 40);
  RobotSetup robot = simulation.setup({3});
  robot.layers = robot.avoids = {4};  // a storey without walls
  simulation.change_robot({3}, robot);
  const std::vector<std::byte> saved = simulation.save();
  const std::uint64_t future = hash_after(simulation, 60);
  Simulation continued(saved, 1);
  EXPECT_EQ(hash_after(continued, 60), future);
  simulation.add_obstacle(wall_of(kUpper, {-30, 20}, {30, 20}));
  simulation.restore(saved);
  EXPECT_EQ(hash_after(simulation, 60), future);
  EXPECT_EQ(simulation.obstacles().setup[1].layers, kUpper);
  Simulation fresh(scene, 1);  // which has no floor for that robot
  fresh.restore(saved);
  EXPECT_EQ(hash_after(fresh, 60), future);
}

// The only robot of a storey leaves; what is saved then is whole, and so is what is refused.
TEST(Floors, need_no_robots) {
  Scenario scene;
  scene.obstacles = {wall_of(kUpper, {0, -3}, {0, 3})};
  scene.robots = {on_floor(kGround, {0, 0}, {8, 0}), on_floor(kUpper, {5, 0}, {8, 0})};
  Simulation simulation(scene, 1);
  simulation.remove_robot({1});
  const std::vector<std::byte> saved = simulation.save();
  EXPECT_EQ(Simulation(saved, 1).state_hash(), simulation.state_hash());
  RobotSetup refused = on_floor({3}, {0.2, 0}, {8, 0});
  EXPECT_NE(refusal([&] { simulation.add_robot(refused); }), "");
  EXPECT_TRUE(simulation.save() == saved);
  Simulation continued(saved, 1);
  EXPECT_EQ(hash_after(continued, 50), hash_after(simulation, 50));
}

// On board as in a simulation: of the map, the walls of its layers.
TEST(Floors, are_chosen_on_board) {
  const std::vector<StaticObstacle> map = {wall_of(kUpper, {0, -6}, {0, 2}),
                                           wall_of(kGround, {0, -2}, {0, 6})};
  Navigator navigator({.layers = kUpper}, map);
  Robot robot;
  robot.position = {-2, 0};
  navigator.set_goal({2, 0});
  EXPECT_GT(navigator.step(robot, {}, 0.0).preferred_velocity.y, 0.1);
  navigator.set_obstacles(map, kGround);
  EXPECT_LT(navigator.step(robot, {}, 0.1).preferred_velocity.y, -0.1);
}

}  // namespace
}  // namespace avo
