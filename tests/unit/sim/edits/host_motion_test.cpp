// SPDX-License-Identifier: Apache-2.0
// Robots that move as the host tells: others evade them and are not touched in motion. Taken back,
// they brake and decide again.
#include <gtest/gtest.h>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "avo/events.h"
#include "avo/explanation.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;
using test::run_for;

constexpr RobotId kPlayer{0};

// The player, and a crowd that crosses a square to and fro.
Scenario crowd(std::size_t robots, std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.robots = {robot_at({-12, 0}, {12, 0})};
  for (std::size_t k = 0; k < robots; ++k) {
    RobotSetup robot =
        robot_at({1.6 * static_cast<double>(k % 8), 1.6 * static_cast<double>(k / 8) - 5},
                 {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)});
    robot.radius = random.uniform(0.25, 0.45);
    scene.robots.push_back(robot);
  }
  return scene;
}

// The result, in m/s, leads as fast towards the nearest robot as the player's limits allow.
Vec2 chase(const Simulation& simulation) {
  const RobotState player = simulation.robot(kPlayer);
  const RobotSetup limits = simulation.setup(kPlayer);
  const RobotState prey = simulation.robot(simulation.nearest_robots(player.position, 2)[1]);
  const Vec2 towards = prey.position + 0.5 * prey.velocity - player.position;
  const Vec2 wanted = limits.max_speed / norm(towards) * towards - player.velocity;
  const double most = limits.max_acceleration * 0.1;
  const Vec2 next = player.velocity + (norm(wanted) > most ? most / norm(wanted) * wanted : wanted);
  return norm(next) > limits.max_speed ? limits.max_speed / norm(next) * next : next;
}

TEST(HostMotion, a_player_who_chases_robots_touches_none_in_motion) {
  std::int64_t touched = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Scenario scene = crowd(40, seed);
    Simulation simulation(scene, 1), other(scene, 3);
    Metrics metrics(scene);
    metrics.observe(simulation);
    for (int k = 0; k < 300; ++k) {
      const Vec2 velocity = chase(simulation);
      for (Simulation* own : {&simulation, &other}) {
        own->set_velocity(kPlayer, velocity);
        own->step();
      }
      metrics.observe(simulation);
      ASSERT_EQ(simulation.robot(kPlayer).velocity, velocity);
    }
    const RunSummary summary = metrics.summary();
    EXPECT_EQ(summary.one_sided_collisions_in_motion, 0) << "seed " << seed;
    EXPECT_EQ(summary.collision_pairs, 0) << "seed " << seed;
    EXPECT_LE(summary.acceleration_excess, 0.0);
    touched += summary.one_sided_collisions;
    EXPECT_EQ(simulation.state_hash(), other.state_hash()) << "seed " << seed;
  }
  EXPECT_GT(touched, 0) << "robots at rest are run into";
}

TEST(HostMotion, is_taken_as_told_whatever_is_in_its_way) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 9}), robot_at({6, 4}, {-6, 4})};
  scene.obstacles = {{{{{{-5, 2}, {5, 2}}, false}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  Events events(simulation);
  run_for(simulation, 0.5);
  const RobotState before = simulation.robot(kPlayer);
  simulation.set_velocity(kPlayer, Vec2{0, 1.5});
  EXPECT_EQ(simulation.host_velocity(kPlayer), (Vec2{0, 1.5}));
  EXPECT_EQ(simulation.host_velocity({1}), std::nullopt);
  simulation.step();
  const RobotState after = simulation.robot(kPlayer);
  EXPECT_EQ(after.velocity, (Vec2{0, 1.5}));
  EXPECT_NEAR(norm(after.position - before.position - 0.05 * (before.velocity + after.velocity)), 0,
              1e-12);
  EXPECT_FALSE(simulation.decided(kPlayer));
  EXPECT_TRUE(simulation.decided({1}));
  EXPECT_EQ(simulation.setup(kPlayer).avoids.bits, 0U);
  EXPECT_EQ(refusal([&] { static_cast<void>(simulation.explain(kPlayer)); }),
            "robot 0: found one that the host moves, must be one that decides");
  run_for(simulation, 6.0);
  EXPECT_NEAR(simulation.robot(kPlayer).position.x, before.position.x, 0.1);
  EXPECT_GT(simulation.robot(kPlayer).position.y, 8.0) << "through the wall";
  simulation.set_velocity(kPlayer, Vec2{});
  for (int k = 0; k < 60; ++k) {
    simulation.step();
    for (const Event& event : events.observe(simulation))
      EXPECT_NE(event.kind, EventKind::stuck) << event.sentence;
  }
  EXPECT_FALSE(simulation.is_at_goal(kPlayer));
}

TEST(HostMotion, brakes_and_decides_again_when_it_is_taken_back) {
  const Scenario scene = crowd(0, 1);
  Simulation simulation(scene, 1);
  simulation.set_velocity(kPlayer, Vec2{0, -2});
  run_for(simulation, 3.0);
  const std::uint64_t roster = simulation.roster();
  simulation.set_velocity(kPlayer, std::nullopt);
  EXPECT_EQ(simulation.host_velocity(kPlayer), std::nullopt);
  for (int k = 1; k <= 20; ++k) {
    simulation.step();
    EXPECT_NEAR(simulation.robot(kPlayer).velocity.y, -2 + 0.1 * k, 1e-9) << "1 m/s^2";
    EXPECT_FALSE(simulation.decided(kPlayer));
  }
  EXPECT_EQ(simulation.roster(), roster);
  simulation.step();
  EXPECT_TRUE(simulation.decided(kPlayer));
  EXPECT_NE(simulation.roster(), roster) << "its setup is another one";
  EXPECT_EQ(simulation.setup(kPlayer).avoids.bits, RobotSetup{}.avoids.bits);
  run_for(simulation, 60.0);
  EXPECT_TRUE(simulation.is_at_goal(kPlayer));
}

// It brakes for longer than a robot needs to be stuck.
TEST(HostMotion, is_not_stuck_while_it_brakes) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 50})};
  scene.robots[0].max_acceleration = 0.5;
  Simulation simulation(scene, 1);
  Events events(simulation, {.stuck_after = 2.0});
  simulation.set_velocity(kPlayer, Vec2{0, -2});
  simulation.step();
  simulation.set_velocity(kPlayer, std::nullopt);
  int braked = 0;
  for (; simulation.is_moved(kPlayer); ++braked) {
    simulation.step();
    EXPECT_TRUE(events.observe(simulation).empty()) << simulation.time();
  }
  EXPECT_EQ(braked, 41) << "2 m/s by 0.5 m/s^2";
}

TEST(HostMotion, brakes_as_its_motion_does) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    Scenario scene = crowd(0, 1);
    scene.motion = motion;
    scene.control_time = 0.2;
    scene.robots[0].max_acceleration = 3.0, scene.robots[0].max_braking = 1.5;
    Simulation simulation(scene, 1);
    simulation.set_velocity(kPlayer, Vec2{2, 0});
    simulation.step();
    simulation.set_velocity(kPlayer, std::nullopt);
    simulation.step();
    EXPECT_NEAR(simulation.robot(kPlayer).applied_acceleration, 1.5, 1e-9);
  }
}

// The host changes a robot while it moves it, so that others would have to see it from farther off.
TEST(HostMotion, stays_at_rest_where_the_scene_no_longer_allows_it) {
  Scenario scene;
  scene.sensing_radius = 30.0;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({0, 20}, {9, 20})};
  scene.robots[0].avoids = {3}, scene.robots[1].layers = scene.robots[1].avoids = {2};
  Simulation simulation(scene, 1);
  simulation.set_velocity(kPlayer, Vec2{0.5, 0});
  simulation.step();
  RobotSetup fast = simulation.setup(kPlayer);
  fast.max_speed = 20.0;
  simulation.change_robot(kPlayer, fast);
  simulation.set_velocity(kPlayer, std::nullopt);
  run_for(simulation, 5.0);
  EXPECT_TRUE(simulation.is_moved(kPlayer));
  EXPECT_EQ(simulation.robot(kPlayer).velocity, Vec2{});
  fast.max_speed = 2.0;
  simulation.change_robot(kPlayer, fast);
  run_for(simulation, 0.2);
  EXPECT_FALSE(simulation.is_moved(kPlayer));
  EXPECT_EQ(simulation.setup(kPlayer).avoids.bits, 3U);
}

TEST(HostMotion, may_become_slower_than_the_velocity_that_was_taken_back) {
  Simulation simulation(crowd(0, 1), 1);
  simulation.set_velocity(kPlayer, Vec2{2, 0});
  simulation.step();
  RobotSetup slow = simulation.setup(kPlayer);
  slow.max_speed = 1.0;
  EXPECT_NE(refusal([&] { simulation.change_robot(kPlayer, slow); }), "");
  simulation.set_velocity(kPlayer, std::nullopt);
  run_for(simulation, 1.5);
  simulation.change_robot(kPlayer, slow);
  EXPECT_EQ(simulation.setup(kPlayer).max_speed, 1.0);
}

// Pairs of deciding robots that overlap, and did not one step before.
class NewOverlaps {
 public:
  int after_step(const Simulation& simulation) {
    int begun = 0;
    std::set<std::pair<std::size_t, std::size_t>> now;
    const FleetView fleet = simulation.fleet();
    for (std::size_t a = 0; a < fleet.id.size(); ++a) {
      for (std::size_t b = a + 1; b < fleet.id.size(); ++b) {
        const double contact = fleet.setup[a].radius + fleet.setup[b].radius;
        if (norm(fleet.position[a] - fleet.position[b]) >= contact - 1e-9) continue;
        now.insert({a, b});
        const bool decide = simulation.decided(fleet.id[a]) && simulation.decided(fleet.id[b]);
        begun += decide && !before_.contains({a, b}) ? 1 : 0;
      }
    }
    before_ = now;
    return begun;
  }

 private:
  std::set<std::pair<std::size_t, std::size_t>> before_;
};

TEST(HostMotion, parts_from_what_it_rests_on) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {20, 0}), robot_at({4.3, 0}, {4.3, 0})};
  scene.robots[1].radius = 0.3;
  scene.obstacles = {{{{{{5.2, -3}, {5.2, 3}}, false}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  simulation.set_velocity(kPlayer, Vec2{2, 0});
  run_for(simulation, 1.7);
  simulation.set_velocity(kPlayer, std::nullopt);
  run_for(simulation, 2.2);
  EXPECT_TRUE(simulation.decided(kPlayer));
  EXPECT_NEAR(simulation.robot(kPlayer).position.x, 5.3, 0.3) << "on the robot, in the wall";
  run_for(simulation, 60.0);
  EXPECT_TRUE(simulation.all_at_goal());
}

// The host stops the player at once, before a robot that follows too fast to stop.
TEST(HostMotion, decides_again_once_robots_in_motion_can_stop_before_it) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({-2.4, 0}, {90, 0})};
  scene.robots[0].velocity = scene.robots[1].velocity = {2, 0};
  Simulation simulation(scene, 1);
  simulation.set_velocity(kPlayer, Vec2{2, 0});
  simulation.step();
  simulation.set_velocity(kPlayer, Vec2{});
  simulation.step();
  simulation.set_velocity(kPlayer, std::nullopt);
  while (norm(simulation.robot({1}).velocity) > 1e-6) {
    simulation.step();
    if (norm(simulation.robot({1}).velocity) > 0.0) {
      ASSERT_FALSE(simulation.decided(kPlayer)) << simulation.time();
    }
    ASSERT_LT(simulation.time(), 10.0);
  }
  run_for(simulation, 0.2);
  EXPECT_TRUE(simulation.decided(kPlayer));
}

// Taken and given back at random times in a crowd, two at once.
TEST(HostMotion, nobody_is_touched_in_motion_by_robots_that_come_and_go) {
  int back = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Scenario scene = crowd(32, seed);
    Random random(seed);
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    metrics.observe(simulation);
    NewOverlaps overlaps;
    for (int k = 0; k < 600; ++k) {
      const RobotId robot{static_cast<std::uint64_t>(random.below(2))};
      const bool decides = !simulation.host_velocity(robot) && simulation.decided(robot);
      const Vec2 v = simulation.robot(robot).velocity;
      if (k > 0 && decides && random.below(20) == 0)
        refusal([&] { simulation.set_velocity(robot, v); });
      if (simulation.host_velocity(robot)) {
        const Vec2 next = v + 0.07 * random.direction();
        if (norm(next) <= 2.0) simulation.set_velocity(robot, next);
        if (random.below(60) == 0) simulation.set_velocity(robot, std::nullopt), ++back;
      }
      simulation.step();
      metrics.observe(simulation);
      EXPECT_EQ(overlaps.after_step(simulation), 0) << "seed " << seed << " after " << k;
      if (k % 97 == 0) {
        Simulation again(simulation.save(), 2);
        for (int step = 0; step < 3; ++step) again.step();
        const std::vector<std::byte> now = simulation.save();
        for (int step = 0; step < 3; ++step) simulation.step();
        EXPECT_EQ(again.state_hash(), simulation.state_hash());
        simulation.restore(now);
        EXPECT_EQ(simulation.save(), now);
      }
    }
    const RunSummary summary = metrics.summary();
    EXPECT_EQ(summary.one_sided_collisions_in_motion, 0) << "seed " << seed;
  }
  EXPECT_GT(back, 20);
}

TEST(HostMotion, is_refused_where_it_cannot_be) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({0, 5}, {9, 5}), robot_at({5, 9}, {5, 9})};
  scene.robots[1].model = Car{};
  scene.robots[2].behavior = Behavior::parked;
  const auto refused = [&](std::uint64_t robot, Vec2 velocity) {
    Simulation simulation(scene, 1);
    const std::vector<std::byte> before = simulation.save();
    const std::string message = refusal([&] { simulation.set_velocity({robot}, velocity); });
    EXPECT_EQ(simulation.save(), before);
    return message;
  };
  EXPECT_EQ(refused(0, {0, 3}),
            "robot 0: velocity: found 3 m/s, must be at most its max_speed, 2 m/s");
  EXPECT_EQ(refused(1, {0, 1}),
            "robot 1: found a velocity for one with a heading, must be a preferred velocity");
  EXPECT_EQ(refused(2, {0, 1}), "robot 2: found a velocity for it, must be one that is not parked");
  EXPECT_EQ(refused(7, {0, 1}), "robot 7: found none of that id");
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({5.6, 0}, {-9, 0})};
  scene.robots[0].velocity = {2, 0}, scene.robots[1].velocity = {-2, 0};
  EXPECT_NE(refused(0, {2, 0}).find("too fast for their distance"), std::string::npos);
  scene.robots = {robot_at({0, 0}, {9, 0})};
  scene.execution = ExecutionModel{.velocity_error = 0.01};
  EXPECT_EQ(
      refused(0, {0, 1}),
      "robot 0: found a velocity for it in a scene with execution, must be a preferred velocity");
  scene.execution.reset(), scene.clock = Clock::free;
  EXPECT_EQ(refused(0, {0, 1}),
            "robot 0: found a velocity for it while clocks are free, must be a preferred velocity");
}

TEST(HostMotion, keeps_what_it_needs_while_it_is_moved) {
  Simulation simulation(crowd(3, 1), 1);
  simulation.set_velocity(kPlayer, Vec2{1, 0});
  RobotSetup setup = simulation.setup(kPlayer);
  setup.avoids = {2};
  EXPECT_EQ(refusal([&] { simulation.change_robot(kPlayer, setup); }),
            "robot 0: avoids: found a change while the host moves it, must be the same, nobody");
  setup = simulation.setup(kPlayer), setup.max_speed = 0.5;
  EXPECT_EQ(refusal([&] { simulation.change_robot(kPlayer, setup); }),
            "robot 0: max_speed: found 0.5, must be >= 1 m/s, the velocity that the host gave");
  setup = simulation.setup(kPlayer), setup.max_speed = setup.preferred_speed = 1.2;
  simulation.change_robot(kPlayer, setup);
  simulation.move_robot(kPlayer, {-20, 0});
  simulation.remove_robot({1});
  simulation.add_robot(robot_at({20, 0}, {0, 0}));
  run_for(simulation, 1.0);
  EXPECT_EQ(simulation.host_velocity(kPlayer), (Vec2{1, 0}));
  EXPECT_EQ(simulation.setup(kPlayer).max_speed, 1.2);
  EXPECT_NEAR(simulation.robot(kPlayer).position.x, -19.05, 1e-9) << "from rest";
}

}  // namespace
}  // namespace avo
