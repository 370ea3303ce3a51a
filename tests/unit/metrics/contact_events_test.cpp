// SPDX-License-Identifier: Apache-2.0
// Contacts with moving obstacles are told when they begin.
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "unit/sim/mover_scenes.h"
#include "watched_host.h"

namespace avo {
namespace {

using test::mover;
using test::robot_at;
using Host = test::WatchedHost;

TEST(ContactEvents, are_contacts_in_motion_and_at_rest) {
  Scenario scene;
  scene.method = Method::avo_paper;
  scene.sensing_radius = 1e-3;  // no robot evades
  RobotSetup parked = robot_at({0, 10}, {0, 10});
  parked.behavior = Behavior::parked;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({-10, -10}, {90, -10}), parked};
  scene.robots[1].velocity = {2, 0}, scene.robots[1].max_acceleration = 1e-3;
  scene.moving_obstacles = {mover({-6, 0.2}, {1, 0}, 0.5), mover({6, 0}, {-1, 0}, 0.4),
                            mover({10, -10}, {}, 0.5), mover({-3, 10}, {1, 0}, 0.5)};
  scene.allow_broken_assumptions = true;
  Host host(scene);
  std::string events;
  const auto overlap = [&](std::size_t robot, std::size_t obstacle) {
    const MovingObstacleView movers = host.simulation.moving_obstacles();
    return norm(host.simulation.robot({robot}).position - movers.position[obstacle]) <
           0.5 + movers.setup[obstacle].radius;
  };
  bool before[3] = {};
  for (int k = 0; k < 250; ++k) {
    const std::string now = host.step();
    const bool present[] = {overlap(0, 0), overlap(0, 1), overlap(1, 2)};
    std::string expected;
    const char* const words[] = {"contact 0/0 rest", "contact 0/1 rest", "contact 1/2"};
    for (int pair = 0; pair < 3; ++pair) {
      if (present[pair] && !before[pair])
        expected += (expected.empty() ? "" : " ") + std::string(words[pair]);
      before[pair] = present[pair];
    }
    EXPECT_EQ(now, expected) << k;
    if (!now.empty()) events += now + "; ";
  }
  EXPECT_EQ(events, "contact 0/0 rest; contact 0/1 rest; contact 1/2; ") << "each one once";
}

// Discs of robots with wheels lie ahead of their places, and movers differ in size.
TEST(ContactEvents, are_the_contacts_of_all_pairs) {
  test::Random random(5);
  Scenario scene;
  scene.method = Method::avo_paper;
  scene.sensing_radius = 1e-3;
  scene.allow_broken_assumptions = true;
  for (int k = 0; k < 30; ++k) {
    const auto place = [&] { return Vec2{random.uniform(0, 30), random.uniform(0, 30)}; };
    RobotSetup robot = robot_at(place(), place());
    robot.radius = random.uniform(0.2, 0.6);
    if (k % 3 == 0) robot.model = DifferentialDrive{.track = 0.5, .offset = 0.3};
    if (k % 3 == 0) robot.heading = random.uniform(-3, 3);
    scene.robots.push_back(robot);
    scene.moving_obstacles.push_back(
        mover(place(), random.uniform(0.5, 2.0) * random.direction(), random.uniform(0.2, 1.5)));
  }
  Host host(scene);
  std::vector<bool> before(900, false);
  const auto overlaps = [&](std::size_t i, std::size_t k) {
    const RobotSetup robot = host.simulation.setup({i});
    const MovingObstacleView movers = host.simulation.moving_obstacles();
    return norm(disc_center(robot) - movers.position[k]) <
           (disc_radius(robot) + movers.setup[k].radius) * (1.0 - 1e-9);
  };
  for (std::size_t pair = 0; pair < 900; ++pair) before[pair] = overlaps(pair / 30, pair % 30);
  int found = 0;
  for (int step = 0; step < 250; ++step) {
    host.simulation.step();
    std::vector<Event> contacts;
    for (const Event& event : host.events.observe(host.simulation))
      if (event.kind == EventKind::contact) contacts.push_back(event);
    auto next = contacts.begin();
    for (std::size_t pair = 0; pair < 900; ++pair) {
      const bool now = overlaps(pair / 30, pair % 30);
      if (now && !before[pair]) {
        ASSERT_NE(next, contacts.end()) << step;
        EXPECT_EQ(next->robot.value, pair / 30);
        EXPECT_EQ(next->moving_obstacle.value, pair % 30);
        ++next, ++found;
      }
      before[pair] = now;
    }
    EXPECT_EQ(next, contacts.end()) << step;
  }
  EXPECT_GT(found, 50);
}

// Robot 0 is a player: it runs into robots that rest, on its own floor alone, and into no wall.
TEST(ContactEvents, are_told_of_robots_that_the_host_moves) {
  Scenario scene;
  RobotSetup upstairs = robot_at({3, 0.2}, {3, 0.2}), parked = robot_at({9, 0}, {9, 0});
  upstairs.layers = upstairs.avoids = LayerSet{2}, parked.behavior = Behavior::parked;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({3, 0}, {3, 0}), upstairs,
                  robot_at({6, 0}, {6, 0}), parked};
  scene.robots[0].avoids = LayerSet{1}, scene.robots[1].max_acceleration = 1e-3;
  scene.robots[3].max_acceleration = 1e-3;
  scene.moving_obstacles = {mover({6, 0.9}, {}, 0.5)};
  scene.allow_broken_assumptions = true;
  Host host(scene);
  EXPECT_EQ(host.run(10), "");
  std::string events;
  for (int k = 0; k < 110; ++k) {
    host.simulation.set_velocity({0}, Vec2{std::min(0.1 * k, 1.0), 0.0});
    if (const std::string now = host.step(); !now.empty()) events += now + "; ";
  }
  EXPECT_EQ(events, "left 0; contact 1/robot 0 rest; contact 3/robot 0 rest; contact 0/0; ");
  EXPECT_EQ(host.simulation.robot({2}).position, (Vec2{3, 0.2}));
}

}  // namespace
}  // namespace avo
