// SPDX-License-Identifier: Apache-2.0
// The host asks which robots are near, what a ray meets, and where there is room.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::furnished;
using test::refusal;
using test::robot_at;

std::vector<RobotId> by_force(const Simulation& simulation, Vec2 center, double radius) {
  const FleetView fleet = simulation.fleet();
  std::vector<std::pair<double, std::uint64_t>> found;
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const double distance =
        norm(center - disc_center(fleet.setup[k])) - disc_radius(fleet.setup[k]);
    if (distance <= radius) found.emplace_back(distance, fleet.id[k].value);
  }
  std::sort(found.begin(), found.end());
  std::vector<RobotId> robots;
  for (const auto& [distance, id] : found) robots.push_back({id});
  return robots;
}

TEST(HostQueries, asks_which_robots_are_near) {
  Simulation simulation = furnished();
  for (int step = 0; step < 40; ++step) {
    simulation.step();
    if (step == 20) simulation.remove_robot({3});  // ids are no rows any more
    const Vec2 p{9.0 * std::sin(1.7 * step), 9.0 * std::cos(2.3 * step)};
    for (const double radius : {0.0, 0.4, 3.0, 50.0})
      EXPECT_EQ(simulation.robots_within(p, radius), by_force(simulation, p, radius)) << step;
    std::vector<RobotId> all = by_force(simulation, p, 1e6);
    all.resize(7);
    EXPECT_EQ(simulation.nearest_robots(p, 7), all);
  }
  EXPECT_EQ(simulation.nearest_robots({500, 500}, 99).size(), 19U);
  EXPECT_TRUE(simulation.nearest_robots({0, 0}, 0).empty());
  EXPECT_EQ(refusal([&] {
              static_cast<void>(simulation.robots_within({NAN, 0}, 1.0));
            }),
            "robots_within: center.0: found nan, must be a finite number");
}

TEST(HostQueries, asks_whether_a_wall_hides_a_place) {
  Simulation simulation = furnished();
  EXPECT_FALSE(simulation.is_in_sight({0, 4}, {14, 4})) << "a solid lies between";
  EXPECT_TRUE(simulation.is_in_sight({0, 8}, {14, 8})) << "it is beside the way";
  EXPECT_FALSE(simulation.is_in_sight({0, 8}, {14, 8}, 2.0)) << "a wide disc touches it";
  EXPECT_TRUE(simulation.is_in_sight({-8, 8}, {-3, 8})) << "movers do not count";
  const Vec2 robot = simulation.robot({0}).position;
  EXPECT_TRUE(simulation.is_in_sight(robot - Vec2{1, 0}, robot + Vec2{1, 0})) << "nor do robots";
  simulation.remove_obstacle({1});
  EXPECT_TRUE(simulation.is_in_sight({0, 4}, {14, 4}));
  EXPECT_EQ(refusal([&] {
              static_cast<void>(simulation.is_in_sight({0, 0}, {1, 0}, -1.0));
            }),
            "is_in_sight: radius: found -1, must be >= 0 m");
}

TEST(HostQueries, asks_what_a_ray_meets_and_where_room_is) {
  Simulation simulation = furnished();
  const auto cast = [&](Vec2 from, Vec2 to, double radius) {
    return simulation.cast_ray(from, to, radius);
  };
  const auto wall = cast({0, 4}, {14, 4}, 0.0);
  ASSERT_TRUE(wall && wall->obstacle);
  EXPECT_EQ(*wall->obstacle, ObstacleId{1});
  EXPECT_NEAR(wall->distance, 1.9, 1e-12) << "the wall is 0.1 m thick to each side";
  const auto thick = cast({0, 6.3}, {14, 6.3}, 0.5);
  ASSERT_TRUE(thick && thick->obstacle);
  EXPECT_NEAR(thick->center.x, 2.0 - std::sqrt(0.36 - 0.09), 1e-12) << "around the corner";
  const auto disc = cast({-8, 3}, {-8, -9}, 0.25);
  ASSERT_TRUE(disc && disc->obstacle);
  EXPECT_NEAR(disc->distance, 6.0 - 1.25, 1e-12);
  const auto mover = cast({-14, 8}, {0, 8}, 0.0);
  ASSERT_TRUE(mover && mover->moving_obstacle);
  EXPECT_NEAR(mover->distance, 14.0 - 5.0 - 0.7, 1e-12);
  const auto robot = cast({-12, 0}, {-12, -14}, 0.0);
  ASSERT_TRUE(robot && robot->robot);
  EXPECT_EQ(*robot->robot, RobotId{0});
  EXPECT_NEAR(robot->distance, 10.0 - 0.25, 1e-12);
  EXPECT_FALSE(cast({0, 12}, {10, 12}, 0.3));
  EXPECT_EQ(cast({-12, -10}, {5, 5}, 0.1)->distance, 0.0) << "it begins in a robot";
  EXPECT_TRUE(simulation.is_free({0, 12}, 1.0));
  EXPECT_FALSE(simulation.is_free({0, 14.5}, 1.0)) << "a wall";
  EXPECT_FALSE(simulation.is_free({3.5, 4}, 0.1)) << "a solid";
  EXPECT_FALSE(simulation.is_free({30, 30}, 0.1)) << "out of bounds";
  EXPECT_FALSE(simulation.is_free({-5, 8.9}, 0.3)) << "the mover";
  EXPECT_TRUE(simulation.is_free({-5, 9.1}, 0.3));
  const ObstacleId door =
      simulation.add_obstacle({{{{{-3, 12}, {3, 12}}, false}}, 0.0, Fill::none});
  EXPECT_FALSE(simulation.is_free({0, 12}, 1.0));
  simulation.remove_obstacle(door);
  EXPECT_TRUE(simulation.is_free({0, 12}, 1.0));
  simulation.move_robot({0}, {0, 12.5});
  EXPECT_FALSE(simulation.is_free({0, 12}, 1.0));
}

TEST(HostQueries, lets_no_ray_through_a_corner) {
  Scenario scene;
  scene.robots = {robot_at({3, 3}, {3, 3})};
  scene.robots[0].radius = 0.2;
  std::vector<Vec2> ring;
  for (int k = 0; k < 9; ++k)
    ring.push_back({3.0 + 7.0 * std::cos(0.7 * k), 3.0 + 6.3 * std::sin(0.7 * k)});
  scene.obstacles = {{{{ring, true}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  for (const Vec2 corner : ring)
    for (int k = 0; k < 200; ++k) {
      const Vec2 from{3.5 + 0.01 * k, 3.3 + 0.007 * k};
      EXPECT_TRUE(simulation.cast_ray(from, from + 3.0 * (corner - from))) << k;
    }
}

TEST(HostQueries, may_look_and_order_in_turn) {
  Simulation simulation = furnished();
  const std::vector<RobotId> before = simulation.nearest_robots({0, 0}, 5);
  simulation.set_preferred_velocity({1}, Vec2{1, 0});
  simulation.set_goal({2}, {5, 9});
  EXPECT_EQ(simulation.nearest_robots({0, 0}, 5), before);
  simulation.step();
  simulation.move_robot({1}, {0, 0});
  EXPECT_EQ(simulation.nearest_robots({0, 0}, 1), std::vector<RobotId>{{1}});
}

}  // namespace
}  // namespace avo
