// SPDX-License-Identifier: Apache-2.0
// The host changes robots and tells them where to go, one or many, between two steps.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::furnished;
using test::refusal;
using test::robot_at;
using test::run_for;
using test::two_lanes;

double least_clearance(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  double least = 1e9;
  for (std::size_t a = 0; a < fleet.id.size(); ++a)
    for (std::size_t b = a + 1; b < fleet.id.size(); ++b)
      least = std::min(least, norm(fleet.position[a] - fleet.position[b]) - fleet.setup[a].radius -
                                  fleet.setup[b].radius);
  return least;
}

TEST(Host, changes_what_a_robot_can_do_and_it_slows_down) {
  Simulation simulation(two_lanes(), 1);
  run_for(simulation, 6.0);
  EXPECT_GT(norm(simulation.robot({0}).velocity), 1.5);
  RobotSetup setup = simulation.setup({0});
  const std::uint64_t roster = simulation.roster();
  setup.max_speed = setup.preferred_speed = 0.5;
  setup.priority = 3.0, setup.arrival_distance = 0.2;
  setup.position = {99, 99}, setup.goal = {0, 77};  // not read
  simulation.change_robot(simulation.fleet().id[0], setup);
  EXPECT_NE(simulation.roster(), roster);
  EXPECT_EQ(simulation.setup({0}).max_speed, 0.5);
  EXPECT_EQ(simulation.setup({0}).priority, 3.0);
  EXPECT_EQ(simulation.setup({0}).arrival_distance, 0.2);
  EXPECT_EQ(simulation.setup({0}).goal, (Vec2{40, 0}));
  const double before = norm(simulation.robot({0}).velocity);
  simulation.step();
  EXPECT_GE(norm(simulation.robot({0}).velocity), before - 0.1 - 1e-9) << "a_max is 1 m/s^2";
  run_for(simulation, 4.0);
  EXPECT_LE(norm(simulation.robot({0}).velocity), 0.5 + 1e-9);
  Simulation again(simulation.save(), 1);
  run_for(simulation, 5.0), run_for(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
}

// The change alone matters, not the manner in which it is made.
TEST(Host, changes_are_those_of_a_robot_that_was_so_from_the_start) {
  Scenario scene = two_lanes();
  Simulation changed(scene, 1);
  RobotSetup other = scene.robots[1];
  other.radius = 0.3, other.max_acceleration = 2.0, other.max_braking = 0.8, other.priority = 2.0;
  other.max_speed = 1.5, other.preferred_speed = 1.2, other.time_horizon = 2.0;
  changed.change_robot({1}, other);
  scene.robots[1] = other;
  scene.sensing_radius = changed.sensing_radius();
  Simulation told(scene, 1);
  run_for(changed, 30.0), run_for(told, 30.0);
  EXPECT_EQ(changed.state_hash(), told.state_hash());
}

TEST(Host, is_refused_changes_that_break_the_promise) {
  Scenario scene;
  scene.sensing_radius = 12.0;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({1.2, 0}, {1.2, 0})};
  scene.obstacles = {{{{{{-5, 1}, {5, 1}}, false}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  RobotSetup setup = simulation.setup({0});
  setup.radius = 0.8;
  const std::string beside = refusal([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(beside.find("robot 0"), std::string::npos) << beside;
  EXPECT_EQ(simulation.setup({0}).radius, 0.5);
  setup.radius = 0.6;
  EXPECT_EQ(refusal([&] { simulation.change_robot({0}, setup); }), "");
  setup.max_speed = 50.0;
  const std::string fast = refusal([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(fast.find("sensing_radius is 12"), std::string::npos) << fast;
  setup = simulation.setup({0}), setup.max_acceleration = -1.0;
  EXPECT_EQ(refusal([&] { simulation.change_robot({0}, setup); }),
            "robot 0: max_acceleration: found -1, must be > 0 m/s^2");
  setup = simulation.setup({0}), setup.model = Car{};
  EXPECT_EQ(refusal([&] { simulation.change_robot({0}, setup); }),
            "robot 0: model: found another one, must be the one that it has");
  EXPECT_NE(refusal([&] { simulation.change_robot({7}, setup); }), "");
  run_for(simulation, 2.0);
  EXPECT_GE(least_clearance(simulation), 0.0);
}

TEST(Host, tells_a_robot_its_preferred_velocity_and_takes_it_back) {
  Scenario scene = two_lanes();
  scene.robots[1].goal = {-20, 0}, scene.robots[1].position = {20, 0};
  Simulation simulation(scene, 1);
  simulation.set_preferred_velocity({0}, Vec2{0, 1.0});
  EXPECT_EQ(simulation.preferred_velocity({0}), (Vec2{0, 1.0}));
  EXPECT_EQ(simulation.preferred_velocity({1}), std::nullopt);
  run_for(simulation, 20.0);
  EXPECT_NEAR(simulation.robot({0}).position.x, -20.0, 0.3);
  EXPECT_GT(simulation.robot({0}).position.y, 15.0);
  EXPECT_EQ(simulation.perceive({0}).guide, Guide::host);
  EXPECT_EQ(simulation.perceive({0}).robot.preferred_velocity, (Vec2{0, 1.0}));
  simulation.set_preferred_velocity({0}, std::nullopt);
  run_for(simulation, 60.0);
  EXPECT_TRUE(simulation.is_at_goal({0}));
}

TEST(Host, stops_a_robot_that_is_told_the_velocity_0_so_that_it_can_be_parked) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene = two_lanes();
    scene.clock = clock;
    Simulation simulation(scene, 1);
    simulation.set_preferred_velocity({0}, Vec2{0, 1.0});
    run_for(simulation, 5.0);
    EXPECT_GT(simulation.robot({0}).velocity.y, 0.5);
    simulation.set_preferred_velocity({0}, Vec2{});
    run_for(simulation, 15.0);
    EXPECT_EQ(simulation.robot({0}).velocity, Vec2{});
    if (clock == Clock::free) continue;  // robots are not parked while clocks are free
    RobotSetup setup = simulation.setup({0});
    setup.behavior = Behavior::parked;
    EXPECT_NO_THROW(simulation.change_robot({0}, setup));
  }
}

// At its goal too it goes where it is told, and then it is not at its goal.
TEST(Host, leads_a_robot_through_a_crowd_without_contact) {
  Scenario scene;
  for (int k = 0; k < 25; ++k) {
    const Vec2 place{2.0 * (k % 5), 2.0 * (k / 5)};
    scene.robots.push_back(robot_at(place, place));
  }
  scene.robots[0].position = scene.robots[0].goal = {-4, 4};
  Simulation simulation(scene, 1);
  EXPECT_TRUE(simulation.is_at_goal({0}));
  simulation.set_preferred_velocity({0}, Vec2{1.5, 0});
  EXPECT_FALSE(simulation.is_at_goal({0}));
  double least = 1e9;
  for (int k = 0; k < 250; ++k) {
    simulation.step();
    least = std::min(least, least_clearance(simulation));
  }
  EXPECT_GE(least, 0.0);
  EXPECT_GT(simulation.robot({0}).position.x, 9.0);
}

TEST(Host, edits_many_robots_at_once_or_none) {
  Simulation one = furnished(), many = furnished();
  const std::vector<RobotId> some{{3}, {7}, {11}};
  const std::vector<Vec2> goals{{0, 0}, {1, 8}, {-9, 9}}, velocities{{1, 0}, {0, 1}, {-1, 0}};
  many.set_goals(some, goals), many.set_preferred_velocities(some, velocities);
  for (std::size_t k = 0; k < 3; ++k)
    one.set_goal(some[k], goals[k]), one.set_preferred_velocity(some[k], velocities[k]);
  run_for(one, 3.0), run_for(many, 3.0);
  EXPECT_EQ(one.state_hash(), many.state_hash());
  const std::vector<std::byte> before = many.save();
  const std::vector<RobotSetup> setups{robot_at({-12, 13}, {12, 13}),
                                       robot_at({-12, 13.2}, {0, 0})};
  EXPECT_NE(refusal([&] { many.add_robots(setups); }), "") << "the second one stands on the first";
  EXPECT_EQ(many.save(), before);
  EXPECT_EQ(refusal([&] {
              many.remove_robots(std::vector<RobotId>{{3}, {9}, {3}});
            }),
            "robot 3: found it twice, must be there once");
  EXPECT_NE(refusal([&] {
              many.set_goals(std::vector<RobotId>{{3}, {99}}, std::span(goals).first(2));
            }),
            "");
  EXPECT_EQ(refusal([&] { many.set_goals(some, std::span(goals).first(2)); }),
            "goals: found 2, must be 3, one for each robot");
  EXPECT_EQ(many.save(), before);
  EXPECT_EQ(many.add_robots(std::span(setups).first(1)), (std::vector<RobotId>{{20}}));
  many.remove_robots(some);
  EXPECT_EQ(many.size(), 18U);
}

// Values that say what holds anyway are those that are left out.
TEST(Host, changes_nothing_by_values_spelled_out) {
  Scenario scene;
  for (int k = 0; k < 5; ++k) scene.robots.push_back(robot_at({4.0 * k, 0}, {4.0 * k, 20}));
  Simulation simulation(scene, 1);
  for (int k = 0; k < 5; ++k) {
    RobotSetup setup = simulation.setup({static_cast<std::size_t>(k)});
    setup.method = Method::avo, setup.max_braking = setup.max_acceleration;
    simulation.change_robot({static_cast<std::uint64_t>(k)}, setup);
    setup.max_speed = 1.0 + 0.1 * k;
    simulation.change_robot({static_cast<std::uint64_t>(k)}, setup);
  }
  simulation.remove_robots(std::vector<RobotId>{{0}, {2}, {4}});
  simulation.add_robot(robot_at({30, 0}, {30, 5}));
  run_for(simulation, 2.0);
  EXPECT_EQ(simulation.size(), 3U);
}

// B does not avoid A: A counts on no more than the top speed of B.
TEST(Host, checks_a_top_speed_on_which_others_count) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {300, 0}), robot_at({100, 0}, {-300, 0})};
  scene.robots[0].max_speed = scene.robots[0].preferred_speed = 10.0;
  scene.robots[0].velocity = {10, 0}, scene.robots[0].avoids = {3};
  scene.robots[1].max_speed = scene.robots[1].preferred_speed = 1.0;
  scene.robots[1].max_acceleration = 10.0, scene.robots[1].velocity = {-1, 0};
  scene.robots[1].layers = {2}, scene.robots[1].avoids = {0};
  scene.sensing_radius = 400.0;
  Simulation simulation(scene, 1);
  RobotSetup setup = simulation.setup({1});
  setup.max_speed = setup.preferred_speed = 20.0;
  const std::string refused = refusal([&] { simulation.change_robot({1}, setup); });
  EXPECT_NE(refused.find("too fast for their distance"), std::string::npos) << refused;
  setup.max_speed = setup.preferred_speed = 0.5;
  EXPECT_EQ(refusal([&] { simulation.change_robot({1}, setup); }), "");
}

TEST(Host, leads_an_airplane_past_its_goal) {
  Scenario scene;
  RobotSetup plane = robot_at({0, 0}, {30, 0});
  plane.max_speed = plane.preferred_speed = 8.0, plane.velocity = {8, 0};
  plane.model = Airplane{.min_speed = 5.0, .after_goal = AfterGoal::leave};
  scene.robots = {plane};
  Simulation simulation(scene, 1);
  simulation.set_preferred_velocity({0}, Vec2{8, 0});
  run_for(simulation, 12.0);
  ASSERT_EQ(simulation.size(), 1U);
  EXPECT_GT(simulation.robot({0}).position.x, 60.0);
  simulation.set_preferred_velocity({0}, std::nullopt);
  run_for(simulation, 120.0);
  EXPECT_EQ(simulation.size(), 0U) << "it came back to its goal, and left";
}

}  // namespace
}  // namespace avo
