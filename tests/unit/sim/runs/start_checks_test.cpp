// SPDX-License-Identifier: Apache-2.0
// Simulations and edits refuse starts that the command line refuses, in the same words, unless the
// scene allows them; and nothing has changed then.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::pieces;
using test::refusal;
using test::robot_at;

// Two robots at rest, 10 m apart, one parked below, a wall above, a solid to the right.
Scenario yard() {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({10, 0}, {10, 0}), robot_at({5, -5}, {5, -5})};
  scene.robots[2].behavior = Behavior::parked;
  scene.obstacles = {
      pieces({{{0, 5}, {10, 5}}}),
      {.chains = {{{{20, -5}, {30, -5}, {30, 5}, {20, 5}}, true}}, .fill = Fill::solid}};
  return scene;
}

// What the edit is refused with; checks that it has changed nothing. Empty: accepted.
template <typename Edit>
std::string said(Simulation& simulation, const Edit& edit) {
  const std::uint64_t hash = simulation.state_hash();
  const std::vector<std::byte> saved = simulation.save();
  const std::string line = refusal([&] { edit(simulation); });
  if (line.empty()) return line;
  EXPECT_EQ(simulation.state_hash(), hash) << line;
  EXPECT_TRUE(simulation.save() == saved) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  return line;
}

std::string said_of(Simulation& simulation, const RobotSetup& robot) {
  return said(simulation, [&](Simulation& own) { own.add_robot(robot); });
}

std::string said_of_move(Simulation& simulation, std::uint64_t robot, Vec2 place) {
  return said(simulation, [&](Simulation& own) { own.move_robot({robot}, place); });
}

const std::string kAllowed = "; or allow_broken_assumptions";

TEST(StartChecks, a_simulation_refuses_what_the_command_line_refuses) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({0.75, 0}, {9, 5})};
  EXPECT_EQ(refusal([&] { Simulation simulation(scene, 1); }),
            "robot 0 and robot 1 overlap at the start: found 0.75 m between the centers, must be "
            ">= 0.5 + 0.5 = 1 m; move them apart" +
                kAllowed);
  scene.robots[0].velocity = {3, 0};
  EXPECT_EQ(refusal([&] { Simulation simulation(scene, 1); }),
            "robot 0 and robot 1 overlap at the start: found 0.75 m between the centers, must be "
            ">= 0.5 + 0.5 = 1 m; move them apart [1 more]" +
                kAllowed);
  scene.allow_broken_assumptions = true;
  Simulation simulation(scene, 1);
  scene.allow_broken_assumptions = false;
  scene.certificate = Certificate::none;
  Simulation without(scene, 1);
  EXPECT_EQ(complaints(scene), std::vector<std::string>{});
}

TEST(StartChecks, a_robot_is_not_added_where_it_breaks_an_assumption) {
  Simulation simulation(yard(), 1);
  for (int k = 0; k < 3; ++k) simulation.step();
  RobotSetup robot = robot_at({0.4, 0}, {0, 3});
  EXPECT_EQ(said_of(simulation, robot),
            "robot 3 and robot 0 overlap at the start: found 0.4 m between the centers, must be "
            ">= 0.5 + 0.5 = 1 m; move them apart" +
                kAllowed);
  robot.position = {5.4, -5};
  EXPECT_EQ(said_of(simulation, robot),
            "robot 3 and robot 2 overlap at the start: found 0.4 m between the centers, must be "
            ">= 0.5 + 0.5 = 1 m; move them apart" +
                kAllowed);
  robot.position = {2, 0};
  EXPECT_EQ(said_of(simulation, robot), "");
  robot.position = {7.1, 0}, robot.velocity = {2, 0};
  EXPECT_EQ(said_of(simulation, robot),
            "robot 4 and robot 1 start too fast for their distance: found 0.1 m of overlap when "
            "both brake at once, must be none; slow down, move apart, or start at rest" +
                kAllowed);
  robot.position = {6, 4.75}, robot.velocity = {};
  EXPECT_EQ(said_of(simulation, robot),
            "robot 4 starts too near obstacle 0: found [6, 4.75], 0.25 m from it, must be >= 0.5 "
            "+ 0 m and 3e-12 m for rounding; move it away" +
                kAllowed);
  robot.position = {6, 3}, robot.velocity = {0, 1.9};
  EXPECT_EQ(said_of(simulation, robot),
            "robot 4 starts too fast for obstacle 0: found 0.195 m left when it brakes, must be >= "
            "0.5 + 0 m; slow down, move it away, or start at rest" +
                kAllowed);
  robot.position = {25, 0}, robot.velocity = {};
  EXPECT_EQ(
      said_of(simulation, robot),
      "position of robot 4: found [25, 0], must be outside of the solid obstacle 1" + kAllowed);
  robot.position = {0, -30}, robot.velocity = {0, -2.5};
  EXPECT_EQ(said_of(simulation, robot),
            "velocity of robot 4: found 2.5 m/s at the start, must be <= its max_speed = 2 m/s; "
            "slow down, or limit speeds or start at rest" +
                kAllowed);
  robot.velocity = {0, -2.0};
  EXPECT_EQ(said_of(simulation, robot), "");
}

TEST(StartChecks, a_robot_is_not_moved_where_it_breaks_an_assumption) {
  Simulation simulation(yard(), 1);
  EXPECT_NE(said_of_move(simulation, 0, {9.5, 0}).find("robot 0 and robot 1 overlap"),
            std::string::npos);
  EXPECT_NE(said_of_move(simulation, 1, {5, -4.5}).find("robot 1 and robot 2 overlap"),
            std::string::npos);
  EXPECT_NE(said_of_move(simulation, 0, {5, 5}).find("robot 0 starts too near obstacle 0"),
            std::string::npos);
  EXPECT_NE(said_of_move(simulation, 0, {29, 0}).find("outside of the solid obstacle 1"),
            std::string::npos);
  EXPECT_EQ(said_of_move(simulation, 0, {0.1, 0}), "") << "where it was itself";
  EXPECT_EQ(said_of_move(simulation, 0, {9, 0}), "") << "they touch";
  EXPECT_EQ(simulation.fleet().position[0], (Vec2{9, 0}));
}

TEST(StartChecks, one_that_is_parked_is_not_put_into_another_one) {
  Simulation simulation(yard(), 1);
  RobotSetup robot = robot_at({5, -4.5}, {5, -4.5});
  robot.behavior = Behavior::parked;
  EXPECT_NE(said_of(simulation, robot).find("robot 3 and robot 2 overlap at the start"),
            std::string::npos);
  robot.position = robot.goal = {10.5, 0};
  EXPECT_NE(said_of(simulation, robot).find("robot 1 at [10, 0]"), std::string::npos);
  robot.position = robot.goal = {5, -3};
  EXPECT_EQ(said_of(simulation, robot), "");
}

TEST(StartChecks, moving_obstacles_count_where_they_are_now) {
  Scenario scene;
  scene.robots = {robot_at({0, 20}, {0, 20})};
  scene.moving_obstacles = {{.position = {0, 0}, .velocity = {1, 0}}};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 50; ++k) simulation.step();
  EXPECT_NE(said_of(simulation, robot_at({5.5, 0}, {0, 9})).find("robot 1 and moving obstacle 0"),
            std::string::npos);
  EXPECT_EQ(said_of(simulation, robot_at({0, 0}, {0, 9})), "");
}

TEST(StartChecks, whoever_avoids_nobody_there_may_be_there) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0})};
  Simulation simulation(scene, 1);
  RobotSetup robot = robot_at({0, 0}, {0, 5});
  robot.layers = robot.avoids = {2};
  EXPECT_NE(said_of(simulation, robot), "") << "the other one avoids it";
  scene.robots[0].layers = scene.robots[0].avoids = {1};
  Simulation apart(scene, 1);
  EXPECT_EQ(said_of(apart, robot), "");
  EXPECT_EQ(said_of_move(apart, 0, {0, 0}), "");
  robot.avoids = {3};
  EXPECT_NE(said_of(apart, robot), "") << "it avoids the other one";
}

// Others are in the midst of a step, at the end of which they are elsewhere.
TEST(StartChecks, with_free_clocks_others_finish_their_steps) {
  Scenario scene;
  scene.clock = Clock::free;
  scene.time_step = 0.5;
  scene.robots = {robot_at({0, 0}, {40, 0}), robot_at({0, 90}, {0, 90})};
  scene.robots[1].time_step = 0.1;
  Simulation simulation(scene, 1);
  while (simulation.fleet().velocity[0].x < 1.0 ||
         simulation.next_decision({0}) < simulation.time() + 0.3)
    simulation.step();
  const double x = simulation.fleet().position[0].x, v = simulation.fleet().velocity[0].x;
  const double at_once = 1.0 + 0.5 * v * v;  // m ahead, would it brake now
  EXPECT_NE(said_of(simulation, robot_at({x + at_once + 0.25, 0}, {0, 9})), "");
  EXPECT_EQ(said_of(simulation, robot_at({x + at_once + 2.0, 0}, {0, 9})), "");
}

// The disc of a drive moves off its heading. A robot that is accepted before the drive is not
// touched.
TEST(StartChecks, a_drive_in_motion_can_stop_before_whoever_comes) {
  int accepted = 0, refused = 0;
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene;
    scene.clock = clock;
    RobotSetup drive = robot_at({0, 0}, {0, 20});
    drive.radius = 0.3, drive.max_acceleration = 1.2;
    drive.model = DifferentialDrive{
        .track = 0.4, .offset = 0.4, .wheel_speed = 2.0, .wheel_acceleration = 3.0};
    scene.robots = {drive, robot_at({60, 0}, {60, 0})};
    Simulation simulation(scene, 1);
    for (int k = 0; k < 40; ++k) {
      simulation.step();
      const FleetView fleet = simulation.fleet();
      const Vec2 center = disc_center(drive.model, fleet.position[0], fleet.heading[0]);
      const Vec2 v = fleet.velocity[0];
      if (!(norm(v) > 0.0)) continue;
      const double contact = disc_radius(drive.model, 0.3) + 0.5;
      for (const double gap : {0.002, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8}) {
        Simulation other(simulation.save(), 1);
        const Vec2 place = center + ((contact + gap) / norm(v)) * v;
        if (!said_of_move(other, 1, place).empty()) {
          ++refused;
          continue;
        }
        ++accepted;
        for (int step = 0; step < 30; ++step) {
          other.step();
          const FleetView now = other.fleet();
          const Vec2 disc = disc_center(drive.model, now.position[0], now.heading[0]);
          ASSERT_GE(norm(disc - now.position[1]), contact - 1e-9) << k << ", " << gap << " m ahead";
        }
      }
    }
  }
  EXPECT_GT(accepted, 50);
  EXPECT_GT(refused, 50);
}

TEST(StartChecks, where_the_scene_allows_for_it_robots_are_put_anywhere) {
  Scenario scene = yard();
  scene.allow_broken_assumptions = true;
  Simulation original(scene, 1);
  Simulation restored(original.save(), 1);
  for (Simulation* simulation : {&original, &restored}) {
    EXPECT_EQ(said_of(*simulation, robot_at({0.4, 0}, {0, 3})), "");
    EXPECT_EQ(said_of_move(*simulation, 1, {5, 5}), "");
    for (int k = 0; k < 100; ++k) simulation->step();
    EXPECT_GE(norm(simulation->fleet().position[3] - simulation->fleet().position[0]), 1.0 - 1e-9)
        << "they part";
  }
  EXPECT_EQ(original.state_hash(), restored.state_hash());
  scene.allow_broken_assumptions = false;
  Simulation strict(scene, 1);
  strict.restore(original.save());
  EXPECT_NE(said_of_move(strict, 0, {5, -5}), "");
}

TEST(StartChecks, an_obstacle_of_nothing_is_refused) {
  Simulation simulation(yard(), 1);
  EXPECT_EQ(said(simulation, [](Simulation& own) { own.add_obstacle({}); }),
            "obstacle 2: chains: found none, must be one at least");
  Scenario scene = yard();
  scene.obstacles.emplace_back();
  EXPECT_EQ(refusal(scene), "obstacles.2.chains: found none, must be one at least");
}

// A plan may have an empty part.
TEST(StartChecks, a_solid_of_nothing_is_no_wall) {
  Scenario scene = yard();
  Simulation without(scene, 1);
  scene.obstacles.push_back({{}, 0.0, Fill::solid});
  Simulation with(scene, 1), restored(scene, 1);
  for (int k = 0; k < 20; ++k) without.step(), with.step();
  restored.restore(with.save());
  for (std::size_t k = 0; k < scene.robots.size(); ++k)
    EXPECT_EQ(with.fleet().position[k], without.fleet().position[k]);
  EXPECT_EQ(restored.state_hash(), with.state_hash());
}

// Robots that come between two steps are checked against the robots near them. Those are found in a
// grid that is made for the second newcomer.
TEST(StartChecks, many_edits_between_two_steps_are_checked_as_one_alone_is) {
  Scenario scene = test::dense_avo_scene(200, Motion::held, Certificate::braking_trajectories);
  scene.allow_broken_assumptions = false;
  scene.moving_obstacles.clear();
  scene.sensing_radius = 20.0;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    RobotSetup& robot = scene.robots[i];
    robot.position = robot.goal = 3.0 * robot.position, robot.velocity = {};
  }
  Simulation together(scene, 1), alone(scene, 1);
  test::Random random(3);
  const auto anywhere = [&] {
    return Vec2{random.uniform(-5.0, 80.0), random.uniform(-5.0, 80.0)};
  };
  int refused = 0, edits = 0;
  for (; edits < 300; ++edits) {
    if (edits % 100 == 99) together.step(), alone.step();
    RobotSetup setup = robot_at(anywhere(), anywhere());
    setup.velocity = test::in_disc(random, 2.0);
    const std::uint64_t other = together.fleet().id[static_cast<std::size_t>(edits) % 150].value;
    const auto edit = [&](Simulation& own) {
      if (edits % 3 == 0)
        own.move_robot({other}, setup.position);
      else if (edits % 7 == 1)
        own.remove_robot({other});
      else
        own.add_robot(setup);
    };
    alone.restore(alone.save());  // of which the next check makes no grid
    const std::string found = refusal([&] { edit(together); });
    ASSERT_EQ(found, refusal([&] { edit(alone); })) << edits;
    refused += found.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 30);
  EXPECT_LT(refused, edits - 100);
  EXPECT_EQ(together.state_hash(), alone.state_hash());
}

}  // namespace
}  // namespace avo
