// SPDX-License-Identifier: Apache-2.0
// The host parks robots that stand, and sets parked robots free.
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/judged.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::refusal;
using test::robot_at;

void park(Simulation& simulation, std::size_t robot, bool is_parked) {
  RobotSetup setup = simulation.setup({robot});
  setup.behavior = is_parked ? Behavior::parked : Behavior::decides;
  simulation.change_robot(simulation.robot({robot}).id, setup);
}

// A robot parks on the course of another one. The route of the other one then leads around it, and
// the robot drives on later.
TEST(Parking, makes_a_wall_of_a_robot_and_back) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({-8, 0}, {8, 0})};
  test::Judged judged(scene, 1);
  Simulation& simulation = judged.simulation;
  EXPECT_EQ(simulation.route({1}).length, 16.0);
  park(simulation, 0, true);
  EXPECT_TRUE(is_parked(simulation.setup({0})));
  EXPECT_GT(simulation.route({1}).length, 16.01) << "around its disc";
  EXPECT_TRUE(simulation.perceive({1}).neighbors.empty()) << "it is a wall";
  EXPECT_EQ(refusal([&] {
              simulation.set_goal({0}, {5, 5});
            }),
            "robot 0: found a goal for it, must be one that is not parked");
  Simulation continued(simulation.save(), 1);
  judged.run(3.0);
  for (int step = 0; step < 30; ++step) continued.step();
  EXPECT_EQ(continued.state_hash(), simulation.state_hash());
  EXPECT_EQ(simulation.robot({0}).position, Vec2{});
  park(simulation, 0, false);
  EXPECT_EQ(simulation.robot({0}).goal, Vec2{}) << "it stays until it is sent";
  simulation.set_goal({0}, {0, 6});
  judged.run(17.0);
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_TRUE(judged.report().safe());
}

// Walls are known by the ids of their obstacles and parked robots, also where lists have changed.
TEST(Parking, names_the_walls_that_a_robot_sees) {
  Scenario scene;
  const Chain square{{{0, 2}, {1, 2}, {1, 3}, {0, 3}}, true};
  scene.obstacles = {{.chains = {{{{-3, -3}, {3, -3}}}}}, {.chains = {square}, .layers = {2}}};
  for (const double x : {-2.0, 0.0, 2.0}) scene.robots.push_back(robot_at({x, 0}, {x, 0}));
  scene.robots[0].behavior = Behavior::parked;
  Simulation simulation(scene, 1);
  using Sources = std::vector<std::int64_t>;
  EXPECT_EQ(simulation.perceive({1}).wall_source, (Sources{0, -1}));
  simulation.remove_obstacle({0});
  simulation.remove_robot({0});
  park(simulation, 2, true);
  const ObstacleId disc = simulation.add_obstacle({.chains = {{{{0, -3}}}}, .radius = 0.5});
  RobotSetup upper = robot_at({0, -9}, {0, -9});
  upper.layers = {2};
  const RobotId above = simulation.add_robot(upper);
  simulation.move_robot({1}, {0, -0.5});
  const Simulation::Perception seen = simulation.perceive({1});
  EXPECT_EQ(disc.value, 2U);
  EXPECT_EQ(seen.wall_source, (Sources{2, -3}));
  ASSERT_EQ(seen.walls.size(), 2U);
  EXPECT_EQ(seen.walls[0].a, (Vec2{0, -3}));
  EXPECT_EQ(seen.walls[1].a, (Vec2{2, 0})) << "the disc of robot 2";
  simulation.remove_obstacle(disc);
  simulation.move_robot(above, {0, 0.9});
  simulation.move_robot({1}, {0, -4});
  EXPECT_EQ(simulation.perceive(above).wall_source, (Sources{1, 1, 1, 1, -3}));
}

TEST(Parking, is_refused_in_motion_and_where_another_one_could_not_stop) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({-2.2, 0}, {9, 0})};
  scene.robots[0].velocity = scene.robots[1].velocity = {1.2, 0};
  Simulation moving(scene, 1);
  EXPECT_EQ(refusal([&] { park(moving, 0, true); }),
            "robot 0: behavior: found parked at 1.2 m/s, must be parked at rest");
  scene.robots[0].velocity = {};
  scene.robots[1].position = {-1.75, 0};
  Simulation beside(scene, 1);
  EXPECT_EQ(refusal([&] { park(beside, 0, true); }), "") << "the other one stops before it";
  EXPECT_NE(refusal([&] {
              RobotSetup wide = beside.setup({0});
              wide.radius = 0.6;
              beside.change_robot({0}, wide);
            }).find("must be one that is not parked"),
            std::string::npos);
  scene.clock = Clock::free;
  Simulation freely(scene, 1);
  EXPECT_EQ(
      refusal([&] { park(freely, 0, true); }),
      "robot 0: behavior: found a change to or from parked while clocks are free, must be the "
      "same");
}

// The others count on a parked robot as on one that decides: nothing has to be checked anew.
TEST(Parking, leaves_the_promises_of_a_fleet_as_they_are) {
  Scenario scene;
  scene.clock = Clock::free;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({0, 5}, {0, 5})};
  scene.robots[1].behavior = Behavior::parked;
  Simulation simulation(scene, 1);
  RobotSetup faster = simulation.setup({0});
  faster.max_speed = 2.1;
  EXPECT_EQ(refusal([&] { simulation.change_robot({0}, faster); }), "");
}

// Scenes with the same robots from the start move alike.
TEST(Parking, equals_a_robot_that_was_parked_before) {
  Scenario scene;
  scene.obstacles = {{.chains = {{{{-3, 2}, {3, 2}}}}}};
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({-8, 0.1}, {8, 0}), robot_at({8, 1}, {-8, 0})};
  Simulation changed(scene, 1);
  scene.robots[0].behavior = Behavior::parked;
  Simulation given(scene, 1);
  park(changed, 0, true);
  for (int step = 0; step < 150; ++step) {
    changed.step(), given.step();
    ASSERT_EQ(changed.state_hash(), given.state_hash()) << step;
  }
}

// A robot that parks has the wall of a robot that is parked there from the start. The wall has the
// new radius, and is as long as the footprint. The body of a drive is ahead of its place.
TEST(Parking, has_the_wall_of_its_body) {
  const DifferentialDrive drive{.offset = 0.3};
  DifferentialDrive covered;
  covered.footprint = {.discs = 3, .radius = 0.5, .first = -0.6, .spacing = 0.6};
  Car truck;
  truck.footprint = {.discs = 4, .radius = 0.6, .first = 0.0, .spacing = 0.9};
  for (const MotionModel& model :
       {MotionModel{}, MotionModel{drive}, MotionModel{covered}, MotionModel{truck}}) {
    Scenario scene;
    scene.robots = {robot_at({0.1, 0.2}, {0.1, 0.2}), robot_at({-8, 0.1}, {8, 0}),
                    robot_at({8, 2}, {-8, 0})};
    scene.robots[0].model = model, scene.robots[0].heading = 1.1;
    scene.sensing_radius = 20.0;  // else it was chosen with this robot in mind
    Simulation changed(scene, 1);
    RobotSetup wide = changed.setup({0});
    wide.behavior = Behavior::parked, wide.radius = 0.8;
    changed.change_robot({0}, wide);
    scene.robots[0].behavior = Behavior::parked, scene.robots[0].radius = 0.8;
    Simulation given(scene, 1);
    Simulation continued(changed.save(), 1);
    for (int step = 0; step < 60; ++step) {
      changed.step(), given.step(), continued.step();
      ASSERT_EQ(changed.state_hash(), given.state_hash()) << model.index() << " " << step;
      ASSERT_EQ(changed.state_hash(), continued.state_hash()) << model.index() << " " << step;
    }
  }
}

}  // namespace
}  // namespace avo
