// SPDX-License-Identifier: Apache-2.0
// The host changes robots, tells them where to go, and moves obstacles, between two steps.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

template <typename Call>
std::string said(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void run(Simulation& simulation, double seconds) {
  const double until = simulation.time() + seconds - 1e-9;
  while (simulation.time() < until) simulation.step();
}

double least_clearance(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  double least = 1e9;
  for (std::size_t a = 0; a < fleet.id.size(); ++a)
    for (std::size_t b = a + 1; b < fleet.id.size(); ++b)
      least = std::min(least, norm(fleet.position[a] - fleet.position[b]) - fleet.setup[a].radius -
                                  fleet.setup[b].radius);
  return least;
}

Scenario two_lanes() {
  Scenario scene;
  scene.robots = {robot_at({-20, 0}, {40, 0}), robot_at({20, 3}, {-40, 3})};
  return scene;
}

TEST(Host, changes_what_a_robot_can_do_and_it_slows_down) {
  Simulation simulation(two_lanes(), 1);
  run(simulation, 6.0);
  EXPECT_GT(norm(simulation.robot(0).velocity), 1.5);
  RobotSetup setup = simulation.setup(0);
  const std::uint64_t roster = simulation.roster();
  setup.max_speed = setup.preferred_speed = 0.5;
  setup.priority = 3.0, setup.arrival_distance = 0.2;
  setup.position = {99, 99}, setup.goal = {0, 77};  // not read
  simulation.change_robot(simulation.fleet().id[0], setup);
  EXPECT_NE(simulation.roster(), roster);
  EXPECT_EQ(simulation.setup(0).max_speed, 0.5);
  EXPECT_EQ(simulation.setup(0).priority, 3.0);
  EXPECT_EQ(simulation.setup(0).arrival_distance, 0.2);
  EXPECT_EQ(simulation.setup(0).goal, (Vec2{40, 0}));
  const double before = norm(simulation.robot(0).velocity);
  simulation.step();
  EXPECT_GE(norm(simulation.robot(0).velocity), before - 0.1 - 1e-9) << "a_max is 1 m/s^2";
  run(simulation, 4.0);
  EXPECT_LE(norm(simulation.robot(0).velocity), 0.5 + 1e-9);
  Simulation again(simulation.save(), 1);
  run(simulation, 5.0), run(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
}

// The change alone matters, not the way in which it was made.
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
  run(changed, 30.0), run(told, 30.0);
  EXPECT_EQ(changed.state_hash(), told.state_hash());
}

TEST(Host, is_refused_changes_that_break_the_promise) {
  Scenario scene;
  scene.sensing_radius = 12.0;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({1.2, 0}, {1.2, 0})};
  scene.obstacles = {{{{{{-5, 1}, {5, 1}}, false}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  RobotSetup setup = simulation.setup(0);
  setup.radius = 0.8;
  const std::string beside = said([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(beside.find("robot 0"), std::string::npos) << beside;
  EXPECT_EQ(simulation.setup(0).radius, 0.5);
  setup.radius = 0.6;
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }), "");
  setup.max_speed = 50.0;
  const std::string fast = said([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(fast.find("sensing_radius is 12"), std::string::npos) << fast;
  setup = simulation.setup(0), setup.max_acceleration = -1.0;
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }),
            "robot 0: max_acceleration: found -1, must be > 0 m/s^2");
  setup = simulation.setup(0), setup.model = Car{};
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }),
            "robot 0: model: found another one, must be the one that it has");
  EXPECT_NE(said([&] { simulation.change_robot({7}, setup); }), "");
  run(simulation, 2.0);
  EXPECT_GE(least_clearance(simulation), 0.0);
}

TEST(Host, tells_a_robot_its_preferred_velocity_and_takes_it_back) {
  Scenario scene = two_lanes();
  scene.robots[1].goal = {-20, 0}, scene.robots[1].position = {20, 0};
  Simulation simulation(scene, 1);
  simulation.set_preferred_velocity({0}, Vec2{0, 1.0});
  EXPECT_EQ(simulation.preferred_velocity(0), (Vec2{0, 1.0}));
  EXPECT_EQ(simulation.preferred_velocity(1), std::nullopt);
  run(simulation, 20.0);
  EXPECT_NEAR(simulation.robot(0).position.x, -20.0, 0.3);
  EXPECT_GT(simulation.robot(0).position.y, 15.0);
  EXPECT_EQ(simulation.perceive(0).guide, Guide::host);
  EXPECT_EQ(simulation.perceive(0).robot.preferred_velocity, (Vec2{0, 1.0}));
  simulation.set_preferred_velocity({0}, std::nullopt);
  run(simulation, 60.0);
  EXPECT_TRUE(simulation.is_at_goal(0));
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
  EXPECT_TRUE(simulation.is_at_goal(0));
  simulation.set_preferred_velocity({0}, Vec2{1.5, 0});
  EXPECT_FALSE(simulation.is_at_goal(0));
  double least = 1e9;
  for (int k = 0; k < 250; ++k) {
    simulation.step();
    least = std::min(least, least_clearance(simulation));
  }
  EXPECT_GE(least, 0.0);
  EXPECT_GT(simulation.robot(0).position.x, 9.0);
}

TEST(Host, has_its_orders_saved_and_restored) {
  Scenario scene = two_lanes();
  scene.moving_obstacles = {{.position = {0, 30}, .velocity = {0.5, 0}}};
  Simulation simulation(scene, 1);
  const std::vector<std::byte> start = simulation.save();
  simulation.set_preferred_velocity({1}, Vec2{-0.5, 0.5});
  const MovingObstacleId came = simulation.add_moving_obstacle({.position = {0, -30}});
  simulation.remove_moving_obstacle({0});
  run(simulation, 3.0);
  Simulation again(simulation.save(), 1);
  EXPECT_EQ(again.preferred_velocity(1), (Vec2{-0.5, 0.5}));
  ASSERT_EQ(again.obstacles().id.size(), 1U);
  EXPECT_EQ(again.obstacles().id[0], came);
  run(simulation, 5.0), run(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
  EXPECT_EQ(again.add_moving_obstacle({.position = {0, -40}}).value, came.value + 1);
  simulation.restore(start);
  EXPECT_EQ(simulation.preferred_velocity(1), std::nullopt);
  ASSERT_EQ(simulation.obstacles().id.size(), 1U);
  EXPECT_EQ(simulation.obstacles().id[0], MovingObstacleId{0});
  EXPECT_EQ(simulation.save(), start);
}

// A player walks towards robots, as the host says: within the limits that it declares, no robot in
// motion touches it.
TEST(Host, moves_a_player_whom_robots_evade) {
  Scenario scene;
  for (int k = 0; k < 8; ++k)
    scene.robots.push_back(robot_at({-12.0, 2.5 * k - 9.0}, {12.0, 2.5 * k - 9.0}));
  scene.sensing_radius = 25.0;
  Simulation simulation(scene, 1);
  MetricsOptions all;
  Metrics metrics(scene, all);
  metrics.observe(simulation);
  MovingObstacle player{.position = {0, 0}, .max_deviation = 2.0, .max_speed = 1.0};
  player.radius = 0.4;
  const MovingObstacleId id = simulation.add_moving_obstacle(player);
  for (int k = 0; k < 400; ++k) {
    const double angle = 0.05 * k;
    const ObstacleView movers = simulation.obstacles();
    player.position = movers.position[0];
    player.velocity = {0.9 * std::cos(angle), 0.9 * std::sin(angle)};
    simulation.change_moving_obstacle(id, player);
    simulation.step();
    metrics.observe(simulation);
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.obstacle_collisions_in_motion, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.arrived, 8U);
  simulation.remove_moving_obstacle(id);
  EXPECT_TRUE(simulation.obstacles().id.empty());
  run(simulation, 1.0);
}

TEST(Host, is_refused_movers_that_nobody_could_evade) {
  Simulation simulation(two_lanes(), 1);
  run(simulation, 5.0);
  const Vec2 p = simulation.robot(0).position;
  const std::string refused = said([&] {
    simulation.add_moving_obstacle({.position = {p.x + 1.3, p.y}});
  });
  EXPECT_NE(refused.find("moving obstacle 0"), std::string::npos) << refused;
  EXPECT_TRUE(simulation.obstacles().id.empty());
  EXPECT_EQ(said([&] {
              simulation.add_moving_obstacle({.position = {0, 50}, .radius = -1.0});
            }),
            "moving obstacle 0: radius: found -1, must be > 0 m");
  EXPECT_EQ(said([&] { simulation.remove_moving_obstacle({3}); }),
            "moving obstacle 3: found none of that id");
  EXPECT_EQ(said([&] { simulation.change_moving_obstacle({3}, {}); }),
            "moving obstacle 3: found none of that id");
}

// As a scene with them from the start.
TEST(Host, adds_movers_as_a_scene_has_them) {
  Scenario scene = two_lanes();
  const std::vector<MovingObstacle> movers{
      {.position = {0, -20}, .velocity = {0, 0.8}, .max_deviation = 0.5, .max_speed = 1.0},
      {.position = {5, 15}, .max_deviation = 1.0, .max_speed = 0.9, .path = {{5, -5}, {5, 15}}}};
  scene.sensing_radius = 30.0;
  Simulation added(scene, 1);
  for (const MovingObstacle& mover : movers) added.add_moving_obstacle(mover);
  scene.moving_obstacles = movers;
  Simulation whole(scene, 1);
  run(added, 40.0), run(whole, 40.0);
  EXPECT_EQ(added.state_hash(), whole.state_hash());
}

std::vector<std::size_t> by_force(const Simulation& simulation, Vec2 center, double radius) {
  const FleetView fleet = simulation.fleet();
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const double distance =
        norm(center - disc_center(fleet.setup[k])) - disc_radius(fleet.setup[k]);
    if (distance <= radius) found.emplace_back(distance, k);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> ranks;
  for (const auto& [distance, rank] : found) ranks.push_back(rank);
  return ranks;
}

// A small office with robots of several sizes and a mover.
Simulation furnished() {
  Scenario scene;
  scene.obstacles = {{{{{{-15, -15}, {15, -15}, {15, 15}, {-15, 15}}, true}}, 0.0, Fill::bounds},
                     {{{{{2, 2}, {5, 2}, {5, 6}, {2, 6}}, true}}, 0.1, Fill::solid},
                     {{{{{-8, -3}}, false}}, 1.0, Fill::none}};
  scene.moving_obstacles = {{.position = {-5, 8}, .velocity = {0.5, 0}, .radius = 0.7}};
  for (int k = 0; k < 20; ++k) {
    RobotSetup robot = robot_at({-12.0 + 1.3 * k, -10.0 + 0.3 * (k % 4)}, {12.0 - 1.2 * k, 11.0});
    robot.radius = 0.25 + 0.02 * (k % 7);
    scene.robots.push_back(robot);
  }
  return Simulation(scene, 1);
}

TEST(Host, asks_which_robots_are_near) {
  Simulation simulation = furnished();
  for (int step = 0; step < 40; ++step) {
    simulation.step();
    const Vec2 p{9.0 * std::sin(1.7 * step), 9.0 * std::cos(2.3 * step)};
    for (const double radius : {0.0, 0.4, 3.0, 50.0})
      EXPECT_EQ(simulation.robots_within(p, radius), by_force(simulation, p, radius)) << step;
    std::vector<std::size_t> all = by_force(simulation, p, 1e6);
    all.resize(7);
    EXPECT_EQ(simulation.nearest_robots(p, 7), all);
  }
  EXPECT_EQ(simulation.nearest_robots({500, 500}, 99).size(), 20U);
  EXPECT_TRUE(simulation.nearest_robots({0, 0}, 0).empty());
  EXPECT_EQ(said([&] {
              static_cast<void>(simulation.robots_within({NAN, 0}, 1.0));
            }),
            "robots_within: center.0: found nan, must be a finite number");
}

TEST(Host, asks_what_a_ray_meets_and_where_room_is) {
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

TEST(Host, edits_many_robots_at_once_or_none) {
  Simulation one = furnished(), many = furnished();
  const std::vector<RobotId> some{{3}, {7}, {11}};
  const std::vector<Vec2> goals{{0, 0}, {1, 8}, {-9, 9}}, velocities{{1, 0}, {0, 1}, {-1, 0}};
  many.set_goals(some, goals), many.set_preferred_velocities(some, velocities);
  for (std::size_t k = 0; k < 3; ++k)
    one.set_goal(some[k], goals[k]), one.set_preferred_velocity(some[k], velocities[k]);
  run(one, 3.0), run(many, 3.0);
  EXPECT_EQ(one.state_hash(), many.state_hash());
  const std::vector<std::byte> before = many.save();
  const std::vector<RobotSetup> setups{robot_at({-12, 13}, {12, 13}),
                                       robot_at({-12, 13.2}, {0, 0})};
  EXPECT_NE(said([&] { many.add_robots(setups); }), "") << "the second one stands on the first";
  EXPECT_EQ(many.save(), before);
  EXPECT_EQ(said([&] {
              many.remove_robots(std::vector<RobotId>{{3}, {9}, {3}});
            }),
            "robot 3: found it twice, must be there once");
  EXPECT_NE(said([&] {
              many.set_goals(std::vector<RobotId>{{3}, {99}}, std::span(goals).first(2));
            }),
            "");
  EXPECT_EQ(said([&] { many.set_goals(some, std::span(goals).first(2)); }),
            "goals: found 2, must be 3, one for each robot");
  EXPECT_EQ(many.save(), before);
  EXPECT_EQ(many.add_robots(std::span(setups).first(1)), (std::vector<RobotId>{{20}}));
  many.remove_robots(some);
  EXPECT_EQ(many.size(), 18U);
}

// Robots go around movers at rest: what is saved between an edit and a step knows it.
TEST(Host, saves_between_an_edit_of_movers_and_a_step) {
  for (const bool walled : {false, true}) {
    Scenario scene = two_lanes();
    if (walled) scene.obstacles = {{{{{{-5, 8}, {5, 8}}, false}}, 0.0, Fill::none}};
    Simulation simulation(scene, 1);
    run(simulation, 1.0);
    MovingObstacle mover{.position = {0, 14}, .max_deviation = 1.0, .max_speed = 1.0};
    const auto expect_same = [&](const char* what) {
      Simulation again(simulation.save(), 1);
      Simulation other(scene, 1);
      other.restore(simulation.save());
      for (int k = 0; k < 50; ++k) simulation.step(), again.step(), other.step();
      EXPECT_EQ(simulation.state_hash(), again.state_hash()) << what << walled;
      EXPECT_EQ(simulation.state_hash(), other.state_hash()) << what << walled;
    };
    const MovingObstacleId id = simulation.add_moving_obstacle(mover);
    expect_same("came at rest");
    mover.velocity = {0, 0.5};
    simulation.change_moving_obstacle(id, mover);
    expect_same("moves on");
    mover.position = {1, 20}, mover.velocity = {};
    simulation.change_moving_obstacle(id, mover);
    expect_same("came to rest");
    simulation.remove_moving_obstacle(id);
    expect_same("is gone");
  }
}

// Values that say what holds anyway are those that are left out.
TEST(Host, changes_nothing_by_values_spelled_out) {
  Scenario scene;
  for (int k = 0; k < 5; ++k) scene.robots.push_back(robot_at({4.0 * k, 0}, {4.0 * k, 20}));
  Simulation simulation(scene, 1);
  for (int k = 0; k < 5; ++k) {
    RobotSetup setup = simulation.setup(static_cast<std::size_t>(k));
    setup.method = Method::avo, setup.max_braking = setup.max_acceleration;
    simulation.change_robot({static_cast<std::uint64_t>(k)}, setup);
    setup.max_speed = 1.0 + 0.1 * k;
    simulation.change_robot({static_cast<std::uint64_t>(k)}, setup);
  }
  simulation.remove_robots(std::vector<RobotId>{{0}, {2}, {4}});
  simulation.add_robot(robot_at({30, 0}, {30, 5}));
  run(simulation, 2.0);
  EXPECT_EQ(simulation.size(), 3U);
}

TEST(Host, keeps_movers_and_robots_in_sight) {
  Scenario scene = two_lanes();
  Simulation grows(scene, 1);
  const double before = grows.sensing_radius();
  const MovingObstacle fast{.position = {0, 90}, .velocity = {0, -9}, .radius = 3.0};
  grows.add_moving_obstacle(fast);
  EXPECT_GT(grows.sensing_radius(), before + 3.0);
  scene.sensing_radius = before;
  Simulation fixed(scene, 1);
  EXPECT_NE(said([&] { fixed.add_moving_obstacle(fast); }).find("has to be seen from"),
            std::string::npos);
  // it stops from 2 m/s with a fiftieth of its brakes
  run(fixed, 5.0);
  RobotSetup setup = fixed.setup(0);
  setup.max_speed = 0.5, setup.max_acceleration = 0.02;
  EXPECT_NE(said([&] { fixed.change_robot({0}, setup); }).find("has to be seen from"),
            std::string::npos);
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
  RobotSetup setup = simulation.setup(1);
  setup.max_speed = setup.preferred_speed = 20.0;
  const std::string refused = said([&] { simulation.change_robot({1}, setup); });
  EXPECT_NE(refused.find("too fast for their distance"), std::string::npos) << refused;
  setup.max_speed = setup.preferred_speed = 0.5;
  EXPECT_EQ(said([&] { simulation.change_robot({1}, setup); }), "");
}

TEST(Host, leads_an_airplane_past_its_goal) {
  Scenario scene;
  RobotSetup plane = robot_at({0, 0}, {30, 0});
  plane.max_speed = plane.preferred_speed = 8.0, plane.velocity = {8, 0};
  plane.model = Airplane{.min_speed = 5.0, .after_goal = AfterGoal::leave};
  scene.robots = {plane};
  Simulation simulation(scene, 1);
  simulation.set_preferred_velocity({0}, Vec2{8, 0});
  run(simulation, 12.0);
  ASSERT_EQ(simulation.size(), 1U);
  EXPECT_GT(simulation.robot(0).position.x, 60.0);
  simulation.set_preferred_velocity({0}, std::nullopt);
  run(simulation, 120.0);
  EXPECT_EQ(simulation.size(), 0U) << "it came back to its goal, and left";
}

TEST(Host, lets_no_ray_through_a_corner) {
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

TEST(Host, may_look_and_order_in_turn) {
  Simulation simulation = furnished();
  const std::vector<std::size_t> before = simulation.nearest_robots({0, 0}, 5);
  simulation.set_preferred_velocity({1}, Vec2{1, 0});
  simulation.set_goal({2}, {5, 9});
  EXPECT_EQ(simulation.nearest_robots({0, 0}, 5), before);
  simulation.step();
  simulation.move_robot({1}, {0, 0});
  EXPECT_EQ(simulation.nearest_robots({0, 0}, 1), std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace avo
