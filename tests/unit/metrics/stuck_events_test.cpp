// SPDX-License-Identifier: Apache-2.0
// Robots without progress are told once, and why.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "avo/explanation.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"
#include "watched_host.h"

namespace avo {
namespace {

using test::robot_at;
using test::told;
using test::watched_scene;
using Host = test::WatchedHost;

// Two robots in a corridor of one lane: the first has its goal there.
Scenario blocked_corridor() {
  Scenario scene = watched_scene({robot_at({0, 0}, {0, 0}), robot_at({-10, 0}, {12, 0})});
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots[0].max_speed = scene.robots[0].preferred_speed = 1e-3;
  return scene;
}

// By all lengths of the route: a robot is stuck only if the shortest one is hardly shorter than
// that time ago, and surely if that has been so for as long again. It backs off and comes again
// meanwhile.
TEST(StuckEvents, are_robots_without_progress_once_until_they_get_on) {
  for (const double stuck_after : {1.0, 3.0}) {
    Host host(blocked_corridor(), stuck_after);
    const int window = static_cast<int>(std::lround(stuck_after / 0.1));
    std::vector<double> shortest;
    int without_progress = 0, found = 0;  // steps, events
    for (int k = 0; k < 300; ++k) {
      host.simulation.step();
      const double length = host.simulation.route({1}).length;
      shortest.push_back(k == 0 ? length : std::min(shortest.back(), length));
      const bool makes_none =
          k >= window && shortest[static_cast<std::size_t>(k - window)] - shortest.back() <=
                             0.01 * 2.0 * stuck_after;
      without_progress = makes_none ? without_progress + 1 : 0;
      for (const Event& event : host.events.observe(host.simulation)) {
        EXPECT_EQ(told({&event, 1}), "stuck 1");
        EXPECT_EQ(event.sentence, host.simulation.explain({1}).sentence);
        EXPECT_TRUE(makes_none) << k;
        ++found;
      }
      if (without_progress > window) {
        EXPECT_EQ(found, 1) << k;
      }
    }
    EXPECT_GT(without_progress, window);
    host.simulation.move_robot({1}, {-12, 3});
    EXPECT_EQ(host.run(150), "stuck 1") << "it was taken away, and is stuck anew";
    host.simulation.move_robot({0}, {4, 0});
    EXPECT_EQ(host.run(150), "left 0 stuck 0 stuck 1") << "a few meters on it is stuck again";
    host.simulation.remove_robot({0});
    EXPECT_EQ(host.run(150), "gone 0 arrived 1");
  }
}

TEST(StuckEvents, are_anew_for_another_goal) {
  Host host(blocked_corridor());
  EXPECT_EQ(host.run(180), "stuck 1");
  host.simulation.set_goal({1}, {12, 1});
  EXPECT_EQ(host.run(25), "");
  EXPECT_EQ(host.run(25), "stuck 1");
}

TEST(StuckEvents, are_anew_at_an_earlier_time) {
  Host host(blocked_corridor());
  EXPECT_EQ(host.run(80), "");
  const std::vector<std::byte> before = host.simulation.save();
  EXPECT_EQ(host.run(30), "stuck 1");
  host.simulation.restore(before);
  EXPECT_EQ(host.run(25), "");
  EXPECT_EQ(host.run(50), "stuck 1");
}

// A door opens far away: the route is shorter, and the robot stands as before. A door closes: the
// route is longer, and the robot moves as before.
TEST(StuckEvents, are_no_progress_by_another_route_and_no_standstill) {
  Scenario scene = blocked_corridor();
  Host host(scene);
  const StaticObstacle wall{{{{{7, -7.9}, {7, 4}}, false}}, 0.0, Fill::none};
  const ObstacleId door = host.simulation.add_obstacle(wall);
  EXPECT_EQ(host.run(200), "stuck 1");
  const double length = host.simulation.route({1}).length;
  host.simulation.remove_obstacle(door);
  EXPECT_LT(host.simulation.route({1}).length, length - 1.0);
  EXPECT_EQ(host.run(100), "") << "it is told already";

  Scenario wide = watched_scene({robot_at({-15, 0}, {15, 0})});
  wide.obstacles = {test::pieces(test::doorway(3.0))};
  Host driving(wide);
  EXPECT_EQ(driving.run(20), "");
  driving.simulation.add_obstacle({{{{{5, -7.9}, {5, 6}}, false}}, 0.0, Fill::none});
  EXPECT_EQ(driving.run(300), "arrived 0");
}

TEST(StuckEvents, are_no_standstill_of_robots_that_the_host_steers) {
  Host host(watched_scene({robot_at({0, 0}, {9, 0})}));
  host.simulation.set_preferred_velocity({0}, Vec2{});
  EXPECT_EQ(host.run(100), "");
  host.simulation.set_preferred_velocity({0}, std::nullopt);
  EXPECT_EQ(host.run(100), "arrived 0");
}

}  // namespace
}  // namespace avo
