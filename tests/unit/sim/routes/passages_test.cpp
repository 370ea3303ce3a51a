// SPDX-License-Identifier: Apache-2.0
// Fleets come to narrow passages. These tests check which robots wait, which ones go, and that all
// arrive.
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "avo/simulation.h"
#include "navigation/prospect.h"
#include "sim/claims.h"
#include "sim/travels.h"
#include "sim/world.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

// On both sides of a wall along x = 0, in columns, on their ways to mirrored places.
Scenario both_ways(const std::vector<Wall>& walls, int robots, RightOfWay right_of_way) {
  Scenario scene;
  scene.obstacles = {test::pieces(walls)};
  scene.right_of_way = right_of_way;
  scene.max_neighbors = 10;
  for (int k = 0; k < robots; ++k) {
    const double side = k % 2 == 0 ? -1.0 : 1.0;
    const int n = k / 2;
    const Vec2 place{8.0 + 1.7 * (n / 4) + 0.1 * (n % 3), 2.4 * (n % 4) - 3.6 + 0.13 * side};
    RobotSetup robot =
        test::robot_at({side * place.x, place.y}, {-side * (place.x + 0.2), -place.y});
    robot.preferred_speed = 1.5;
    scene.robots.push_back(robot);
  }
  return scene;
}

int arrived_after(const Scenario& scene, double time) {
  Simulation simulation(scene, 1);
  while (!simulation.all_at_goal() && simulation.time() < time) simulation.step();
  int arrived = 0;
  for (std::size_t k = 0; k < scene.robots.size(); ++k)
    arrived += simulation.is_at_goal({k}) ? 1 : 0;
  return arrived;
}

TEST(RobotsAtPassages, TwelveGetThroughADoorBothWays) {
  const std::vector<Wall> walls = test::doorway(1.6);
  EXPECT_EQ(arrived_after(both_ways(walls, 12, RightOfWay::seen), 70.0), 12);
  EXPECT_LT(arrived_after(both_ways(walls, 12, RightOfWay::none), 70.0), 12);
}

TEST(RobotsAtPassages, TwelveGetThroughACorridorOfOneLaneBothWays) {
  const std::vector<Wall> walls = test::corridor(1.6);
  EXPECT_EQ(arrived_after(both_ways(walls, 12, RightOfWay::seen), 150.0), 12);
  EXPECT_EQ(arrived_after(both_ways(walls, 20, RightOfWay::seen), 150.0), 20);
  EXPECT_LT(arrived_after(both_ways(walls, 20, RightOfWay::none), 150.0), 20);
}

// The robot that comes second waits beside the exit, and never stands in the door meanwhile.
TEST(RobotsAtPassages, OneOfTwoGoesFirst) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {test::robot_at({-8, 0}, {9, 0}), test::robot_at({9, 0}, {-8, 0})};
  Simulation simulation(scene, 1);
  double least = 2.0;  // m/s, of the first one in the corridor
  while (simulation.fleet().position[0].x < 5.0 && simulation.time() < 60.0) {
    simulation.step();
    const Vec2 first = simulation.fleet().position[0], second = simulation.fleet().position[1];
    EXPECT_GT(second.x, 5.0) << "not yet";
    if (first.x > -5.0 && first.x < 5.0)
      least = std::min(least, norm(simulation.fleet().velocity[0]));
  }
  EXPECT_GT(least, 0.8);
  EXPECT_LT(simulation.time(), 20.0);
  while (!simulation.all_at_goal() && simulation.time() < 60.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
}

// A robot at its goal in a corridor of one lane lets everybody through, and comes back.
void expect_room_is_made(Vec2 idle, const std::vector<Vec2>& starts) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {test::robot_at(idle, idle)};
  for (const Vec2 start : starts)
    scene.robots.push_back(test::robot_at(start, {-start.x, start.y}));
  EXPECT_EQ(arrived_after(scene, 90.0), static_cast<int>(scene.robots.size()));
}

TEST(RobotsAtPassages, WhoRestsInsideMakesRoomAndComesBack) {
  for (const double x : {-5.3, -3.0, 0.0, 1.0, 4.0, 5.3}) {
    SCOPED_TRACE(x);
    expect_room_is_made({x, 0}, {{-11, 0}});
    expect_room_is_made({x, 0}, {{-11, 0.5}, {-11, -1.5}, {11, 3}});
    for (const double off : {-3.0, -1.0, 0.5})
      expect_room_is_made({x, 0}, {{-11.5, -2}, {11, off}});
  }
}

TEST(RobotsAtPassages, OncomingRobotsPassInTheirLanes) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(2.4))};
  scene.robots = {test::robot_at({-12, 0}, {12, 0}), test::robot_at({12, 0}, {-12, 0})};
  for (RobotSetup& robot : scene.robots) robot.preferred_speed = 1.5;
  Simulation simulation(scene, 1);
  double least = 2.0;
  bool passed = false;
  while (!simulation.all_at_goal() && simulation.time() < 60.0) {
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < 2; ++k) {
      if (std::abs(fleet.position[k].x) < 5.0) least = std::min(least, norm(fleet.velocity[k]));
    }
    if (std::abs(fleet.position[0].x - fleet.position[1].x) > 0.2) continue;
    passed = true;
    EXPECT_LT(fleet.position[0].y, -0.5);
    EXPECT_GT(fleet.position[1].y, 0.5);
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_TRUE(passed);
  EXPECT_GT(least, 1.0);
  EXPECT_LT(simulation.time(), 24.0 / 1.5 + 5.0);
}

// More robots than one thread takes.
TEST(RobotsAtPassages, AreTheSameForAnyNumberOfThreadsAndAfterARestore) {
  const Scenario scene = test::crowd_at_doors(300, RightOfWay::seen);
  Simulation one(scene, 1), two(scene, 2), none(test::crowd_at_doors(300, RightOfWay::none), 1);
  for (int k = 0; k < 60; ++k) one.step(), two.step(), none.step();
  EXPECT_EQ(one.state_hash(), two.state_hash());
  EXPECT_NE(one.state_hash(), none.state_hash()) << "the rules matter";
  Simulation continued(one.save(), 2);
  for (int k = 0; k < 40; ++k) one.step(), continued.step();
  EXPECT_EQ(one.state_hash(), continued.state_hash());
  two.restore(two.save());
  for (int k = 0; k < 40; ++k) two.step();
  EXPECT_EQ(one.state_hash(), two.state_hash());
}

TEST(RobotsAtPassages, PerceiveIsWhatTheStepDecidesOn) {
  for (const double width : {1.6, 2.4}) {
    Simulation simulation(both_ways(test::corridor(width), 20, RightOfWay::seen), 1);
    for (int k = 0; k < 200; ++k) {
      if (k % 10 == 0) {
        test::expect_as_perceived(simulation);
      } else {
        simulation.step();
      }
    }
  }
}

// A crowd behind a wall takes no places among the nearest, or it does for both.
TEST(RobotsAtPassages, PerceiveIsWhatTheStepDecidesOnBesideACrowdBehindAWall) {
  Scenario scene;
  scene.obstacles = {test::pieces({{{0, -40}, {0, 40}}})};
  scene.max_neighbors = 4;
  for (int k = 0; k < 12; ++k) {
    const Vec2 place{1.0 + 1.2 * (k % 3) + 0.01 * k, 1.3 * (k / 3)};
    scene.robots.push_back(test::robot_at(place, {place.x, -place.y - 8.0}));
  }
  for (int k = 0; k < 6; ++k) {
    const Vec2 place{-1.0 - 0.3 * k, 9.0 - 2.5 * k};
    scene.robots.push_back(test::robot_at(place, {place.x, -place.y}));
  }
  Simulation simulation(scene, 1);
  for (int k = 0; k < 60; ++k) test::expect_as_perceived(simulation);
}

TEST(Claims, OutsideOnlyInSightOfTheMouth) {
  // from (-3, 3) the mouth of the door at x = 0 is behind a piece of wall
  std::vector<Wall> walls = test::doorway(1.6);
  walls.push_back({{-1.5, 0.7}, {-1.5, 3.0}});
  for (const bool is_hidden : {false, true}) {
    Scenario scene;
    scene.obstacles = {test::pieces(walls)};
    RobotSetup robot = test::robot_at(is_hidden ? Vec2{-3, 2.5} : Vec2{-3, -2.5}, {9, 0});
    robot.velocity = is_hidden ? Vec2{0.5, -0.5} : Vec2{0.5, 0.5};
    scene.robots = {robot};
    World world(scene, std::make_unique<SerialExecutor>());
    world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
    find_walls(world);
    ASSERT_FALSE(world.routes.front().passages.empty());
    std::vector<Claims> claims;
    SerialExecutor serial;
    collect_claims(world, serial, claims);
    bool claims_door = false;
    for (const Claimant& claimant : claims.front().claimants) {
      const Passage& passage = world.routes.front().passages[claimant.claim.passage];
      claims_door = claims_door || norm(passage.axis[1]) < 0.1;
    }
    EXPECT_EQ(claims_door, !is_hidden);
  }
}

TEST(Claims, EndInsideWhereTheGoalIs) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {test::robot_at({0, 0}, {0, 0})};
  World world(scene, std::make_unique<SerialExecutor>());
  world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
  find_walls(world);
  const Travel& travel = world.travels[0];
  const auto claim =
      look_ahead(world.routes.front().passages, *travel.graph, *travel.map, {}, travel.target)
          .claim;
  ASSERT_TRUE(claim && claim->inside);
  EXPECT_TRUE(claim->ends);
}

// The corner at which the route leaves the passage may be as far off as the passage is long.
TEST(Claims, InsideHoldHoweverLongThePassageIs) {
  Scenario scene;
  scene.obstacles = {test::pieces({{{-20, 0.8}, {20, 0.8}}, {{-20, -0.8}, {20, -0.8}}})};
  for (const double x : {-19.0, 0.0, 19.0})
    scene.robots.push_back(test::robot_at({x, 0}, {25, -6}));
  World world(scene, std::make_unique<SerialExecutor>());
  world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
  find_walls(world);
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    const Travel& travel = world.travels[k];
    const auto claim = look_ahead(world.routes.front().passages, *travel.graph, *travel.map,
                                  scene.robots[k].position, travel.target)
                           .claim;
    ASSERT_TRUE(claim) << k;
    EXPECT_TRUE(claim->inside && !claim->ends) << k;
    const Vec2 out =
        axis_point(world.routes.front().passages[claim->passage], claim->forward, 0.0).direction;
    EXPECT_NEAR(out.x, 1.0, 1e-12) << k;
  }
}

// Around the end of its wall a place is as near to the axis as some inside, and the robot sees the
// lane beside that.
TEST(Claims, LanesAreNotThoseOfAPassageBehindAWall) {
  const std::vector<Wall> walls{{{0, 1.5}, {10, 1.5}}, {{0, -1.5}, {10, -1.5}}};
  const Passages passages(walls, std::vector{0.5}, kClaimRange);
  const CornerGraph graph = corner_graph(walls, 0.5);
  LegScratch scratch;
  const auto lane_from = [&](Vec2 p, Vec2 goal) {
    const PathMap map = path_map(graph, goal);
    const Leg leg = next_leg(graph, map, p, 0.5, PathMap::kNothing, true, scratch);
    return look_ahead(passages, graph, map, p, leg.target).lane;
  };
  for (double y = 1.1; y < 1.45; y += 0.1) {
    EXPECT_TRUE(lane_from({10.75, y}, {2.0, 0.0})) << y;
    EXPECT_FALSE(lane_from({10.75, y}, {6.0, 2.05})) << y;
  }
}

// Each passage's own ones, however many parts there are.
TEST(Claims, AreListedByPassage) {
  World world(test::crowd_at_doors(100, RightOfWay::seen), std::make_unique<SerialExecutor>());
  world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
  for (int k = 0; k < 60; ++k) step(world);
  std::vector<Claims> claims;
  SerialExecutor serial;
  collect_claims(world, serial, claims);
  ASSERT_EQ(claims.front().first.size(), world.routes.front().passages.size() + 1);
  EXPECT_GE(claims.front().claimants.size(), 50u);
  std::size_t listed = 0;
  for (std::uint32_t number = 0; number < world.routes.front().passages.size(); ++number) {
    listed += claims.front().of(number).size();
    for (const Claimant& claimant : claims.front().of(number))
      EXPECT_EQ(claimant.claim.passage, number);
  }
  EXPECT_EQ(listed, claims.front().claimants.size());
  EXPECT_EQ(claims.front().first.front(), 0u);
  EXPECT_EQ(claims.front().first.back(), claims.front().claimants.size());
}

}  // namespace
}  // namespace avo
