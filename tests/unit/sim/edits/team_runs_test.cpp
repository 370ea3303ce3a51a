// SPDX-License-Identifier: Apache-2.0
// Queues, followers, patrols and crowds that leave, as they move.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo/teams.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::robot_at;

// `count` robots behind each other along -x, with one goal.
Scenario row_of(std::size_t count, Vec2 goal) {
  Scenario scene;
  for (std::size_t k = 0; k < count; ++k) {
    RobotSetup robot = robot_at({-2.0 * static_cast<double>(k), 0.3 * static_cast<double>(k % 3)},
                                goal + Vec2{0.0, 2.0 * static_cast<double>(k)});
    robot.radius = 0.3;
    scene.robots.push_back(robot);
  }
  return scene;
}

std::vector<RobotId> all_of(const Scenario& scene) {
  std::vector<RobotId> robots(scene.robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) robots[k] = {k};
  return robots;
}

Vec2 place(const Simulation& simulation, std::size_t id) {
  return simulation.robot({id}).position;
}

TEST(TeamRuns, a_queue_moves_up_and_serves_in_order) {
  Scenario scene = row_of(5, {10, 10});
  scene.teams = {make_team(
      all_of(scene), Queue{.line = {{6, 0}, {3, 0}, {3, -9}}, .spacing = 1.2, .service = 4.0})};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  std::vector<double> left(5, -1.0);  // s, when each is far from the head again
  std::vector<bool> was_there(5, false);
  while (simulation.time() < 90.0) {
    simulation.step();
    metrics.observe(simulation);
    int at_head = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      const double off = norm(place(simulation, k) - Vec2{6, 0});
      if (off < 0.5) was_there[k] = true, ++at_head;
      if (was_there[k] && off > 1.5 && left[k] < 0.0) left[k] = simulation.time();
    }
    EXPECT_LE(at_head, 1);
  }
  EXPECT_TRUE(std::is_sorted(left.begin(), left.end())) << "the nearest to the head is first";
  for (std::size_t k = 1; k < 5; ++k) EXPECT_GT(left[k] - left[k - 1], 4.0);
  EXPECT_GT(left[0], 4.0);
  EXPECT_TRUE(simulation.all_at_goal()) << "each went on to its own goal";
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
}

TEST(TeamRuns, a_queue_without_service_waits_for_its_host) {
  const Scenario scene = row_of(3, {10, 10});
  Simulation simulation(scene, 1);
  Team team = make_team(all_of(scene), Queue{.line = {{6, 0}, {0, 0}}, .spacing = 1.2});
  const auto run = [&](double seconds) {
    const double until = simulation.time() + seconds;
    while (simulation.time() < until) lead(simulation, team), simulation.step();
  };
  run(30.0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(norm(place(simulation, k) - Vec2{6.0 - 1.2 * static_cast<double>(k), 0}), 0.5);
  EXPECT_EQ(serve(simulation, team), RobotId{0});
  const RobotId late = simulation.add_robot(robot_at({-9, 4}, {0, 20}));
  team.members.push_back({late});
  simulation.remove_robot({1});
  run(30.0);
  EXPECT_LT(norm(place(simulation, 2) - Vec2{6, 0}), 0.5) << "it moved up by two";
  EXPECT_LT(norm(place(simulation, 3) - Vec2{4.8, 0}), 0.5);
  EXPECT_LT(norm(place(simulation, 0) - Vec2{10, 10}), 0.5);
  disband(simulation, team);
  EXPECT_EQ(simulation.robot(late).goal, (Vec2{0, 20}));
  EXPECT_TRUE(team.members.empty());
}

TEST(TeamRuns, followers_keep_to_the_trail_and_come_to_rest) {
  Scenario scene = row_of(6, {20, 12});
  for (RobotSetup& robot : scene.robots) robot.preferred_speed = 1.2;
  scene.obstacles = {{{{{{8, -4}, {8, 9}}, false}}, 0.0, Fill::none}};  // the route rounds its end
  scene.teams = {make_team(all_of(scene), Follow{.spacing = 1.5})};
  Simulation simulation(scene, 1);
  double worst = 0.0, sum = 0.0;  // m, gaps between neighbors in the row
  int gaps = 0;
  while (simulation.time() < 60.0) {
    simulation.step();
    if (simulation.time() < 8.0 || simulation.is_at_goal({0})) continue;
    for (std::size_t k = 1; k < 6; ++k) {
      const double gap = norm(place(simulation, k) - place(simulation, k - 1));
      worst = std::max(worst, gap), sum += gap, ++gaps;
    }
  }
  ASSERT_GT(gaps, 100);
  EXPECT_LT(worst, 2.6);
  EXPECT_NEAR(sum / gaps, 1.5, 0.2);
  EXPECT_TRUE(simulation.all_at_goal());
  for (std::size_t k = 1; k < 6; ++k)
    EXPECT_NEAR(norm(place(simulation, k) - place(simulation, k - 1)), 1.5, 0.8) << k;
}

TEST(TeamRuns, slots_stay_about_their_leader) {
  Scenario scene = row_of(5, {60, 0});
  scene.robots[0].preferred_speed = 1.2;
  const std::vector<Vec2> slots{{-1.5, 1.5}, {-1.5, -1.5}, {-3, 3}, {-3, -3}};
  scene.teams = {make_team(all_of(scene), Follow{.slots = slots})};
  Simulation simulation(scene, 1);
  test::run_for(simulation, 25.0);
  const Vec2 leader = place(simulation, 0);
  EXPECT_GT(leader.x, 20.0);
  for (const Vec2 slot : slots) {
    double off = 1e9;
    for (std::size_t k = 1; k < 5; ++k)
      off = std::min(off, norm(place(simulation, k) - leader - slot));
    EXPECT_LT(off, 0.3) << slot.x << " " << slot.y;
  }
  test::run_for(simulation, 45.0);
  EXPECT_TRUE(simulation.all_at_goal());
}

// Beside a corridor the slots are behind its walls.
TEST(TeamRuns, robots_whose_slots_are_hidden_follow_the_trail) {
  Scenario scene = row_of(4, {60, 0});
  scene.robots[0].preferred_speed = 1.0;
  scene.obstacles = {
      {{{{{6, 1.2}, {40, 1.2}}, false}, {{{6, -1.2}, {40, -1.2}}, false}}, 0.0, Fill::none}};
  scene.teams = {make_team(all_of(scene), Follow{.slots = {{-1, 3}, {-1, -3}, {-2, 4}}})};
  Simulation simulation(scene, 1);
  while (place(simulation, 0).x < 28.0 && simulation.time() < 60.0) simulation.step();
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(std::abs(place(simulation, k).y), 1.2) << k;
    EXPECT_GT(place(simulation, k).x, 15.0) << k;
  }
}

TEST(TeamRuns, another_robot_leads_when_the_leader_is_gone) {
  Scenario scene = row_of(4, {20, 0});
  scene.teams = {make_team(all_of(scene), Follow{})};
  Simulation simulation(scene, 1);
  test::run_for(simulation, 4.0);
  simulation.remove_robot({0});
  test::run_for(simulation, 40.0);
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_LT(norm(place(simulation, 1) - scene.robots[1].goal), 0.5);
}

TEST(TeamRuns, a_patrol_passes_its_points_for_ever) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({10, 10}, {0, 0})};
  const std::vector<Vec2> points{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  scene.teams = {make_team(all_of(scene), Patrol{.points = points})};
  Simulation simulation(scene, 1);
  std::vector<int> passed;  // by robot 0
  double slowest = 1e9;
  while (simulation.time() < 60.0) {
    simulation.step();
    for (int k = 0; k < 4; ++k)
      if (norm(place(simulation, 0) - points[static_cast<std::size_t>(k)]) < 1.0 &&
          (passed.empty() || passed.back() != k))
        passed.push_back(k);
    if (simulation.time() > 5.0) slowest = std::min(slowest, norm(simulation.robot({0}).velocity));
  }
  EXPECT_GE(passed.size(), 8U);
  for (std::size_t k = 1; k < passed.size(); ++k) EXPECT_EQ(passed[k], (passed[k - 1] + 1) % 4);
  EXPECT_GT(slowest, 0.5) << "m/s: it does not stop at a point";
  EXPECT_GT(norm(place(simulation, 0) - place(simulation, 1)), 5.0) << "they began apart";
}

TEST(TeamRuns, a_crowd_leaves_by_the_nearest_exits) {
  Scenario scene;
  for (int k = 0; k < 60; ++k) {
    RobotSetup robot = robot_at({1.0 + 1.1 * (k % 10), 1.0 + 1.3 * (k / 10)}, {6, 5});
    robot.radius = 0.3;
    robot.goal = robot.position;
    scene.robots.push_back(robot);
  }
  // a hall with a door of 3 m in the east and one of 1.5 m in the west
  scene.obstacles = {
      {{{{{0, 5}, {0, 9}, {12, 9}, {12, 6}}, false}, {{{12, 3}, {12, 0}, {0, 0}, {0, 3.5}}, false}},
       0.0,
       Fill::none}};
  const std::vector<Vec2> exits{{13, 3}, {13, 6}, {-1, 3.5}, {-1, 5}};
  scene.teams = {make_team(all_of(scene), Flow{.exits = exits, .spacing = 0.8})};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  int east = 0, west = 0;
  for (const Vec2 goal : (simulation.step(), simulation.fleet().goal))
    (goal.x > 6 ? east : west) += 1;
  EXPECT_EQ(east, 30);
  EXPECT_EQ(west, 30);
  while (simulation.size() > 0 && simulation.time() < 120.0) {
    metrics.observe(simulation);
    simulation.step();
  }
  EXPECT_EQ(simulation.size(), 0U);
  EXPECT_LT(simulation.time(), 90.0);
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
}

TEST(TeamRuns, nobody_leaves_but_at_an_exit) {
  Scenario scene = row_of(3, {0, 0});
  scene.moving_obstacles = {{.position = {20, 0}, .radius = 2.0}};  // stands in the exit
  scene.teams = {make_team(all_of(scene), Flow{.exits = {{20, -1}, {20, 1}}})};
  Simulation simulation(scene, 1);
  test::run_for(simulation, 40.0);
  EXPECT_EQ(simulation.size(), 3U) << "the exit is blocked";
  simulation.remove_moving_obstacle({0});
  simulation.set_goal({0}, place(simulation, 0));  // undone by the team
  test::run_for(simulation, 20.0);
  EXPECT_EQ(simulation.size(), 0U);
}

TEST(TeamRuns, a_patrol_goes_on_past_points_that_cannot_be_passed) {
  Scenario scene = row_of(1, {0, 0});
  const Chain box{{{9, -1}, {11, -1}, {11, 1}, {9, 1}}, true};
  scene.obstacles = {{{box}, 0.0, Fill::none}};
  scene.moving_obstacles = {{.position = {0, 10}, .radius = 1.5}};  // stands on a point
  const std::vector<Vec2> points{{0, 0}, {10, 0}, {0, 10}, {-10, 0}};
  scene.teams = {make_team(all_of(scene), Patrol{.points = points})};
  Simulation simulation(scene, 1);
  int rounds = 0;
  bool is_far = false;
  while (simulation.time() < 120.0) {
    simulation.step();
    const double off = norm(place(simulation, 0) - Vec2{-10, 0});
    if (off > 6.0) is_far = true;
    if (is_far && off < 1.5) is_far = false, ++rounds;
  }
  EXPECT_GE(rounds, 2);
}

TEST(TeamRuns, serve_tells_of_a_robot_whose_service_has_just_ended) {
  const Scenario scene = row_of(3, {10, 10});
  Simulation simulation(scene, 1);
  Team team = make_team(all_of(scene), Queue{.line = {{0, 0}, {-9, 0}}, .service = 0.5});
  lead(simulation, team);
  lead(simulation, team);
  for (int step = 0; step < 6; ++step) simulation.step();
  EXPECT_EQ(serve(simulation, team), RobotId{0});
  EXPECT_EQ(team.members.size(), 2U);
  disband(simulation, team);
  EXPECT_EQ(simulation.robot({2}).goal, scene.robots[2].goal);
}

TEST(TeamRuns, nobody_passes_an_exit_and_turns_back) {
  Scenario scene;
  for (int k = 0; k < 12; ++k) {
    RobotSetup robot = robot_at({6.0 + 1.5 * (k % 4), -10.0 + 1.5 * (k / 4)}, {0, 0});
    robot.radius = 0.3;
    scene.robots.push_back(robot);
  }
  scene.obstacles = {{{{{{13, -20}, {13, -8.2}}, false}, {{{13, -5.8}, {13, 6}}, false}}}};
  scene.teams = {make_team(all_of(scene), Flow{.exits = {{14, -8.2}, {14, -5.8}}})};
  Simulation simulation(scene, 1);
  double farthest = 0.0;  // m
  while (simulation.size() > 0 && simulation.time() < 60.0) {
    simulation.step();
    for (const Vec2 robot : simulation.fleet().position) farthest = std::max(farthest, robot.x);
  }
  EXPECT_EQ(simulation.size(), 0U);
  EXPECT_LT(farthest, 14.6);
}

Scenario all_tasks() {
  Scenario scene = row_of(16, {20, 5});
  const std::vector<RobotId> robots = all_of(scene);
  const std::span<const RobotId> all(robots);
  scene.teams = {make_team(all.subspan(0, 4), Queue{.line = {{8, 0}, {0, -8}}, .service = 2.0}),
                 make_team(all.subspan(4, 4), Follow{.slots = {{-2, 1}, {-2, -1}}}),
                 make_team(all.subspan(8, 4), Patrol{.points = {{-20, 10}, {0, 10}}}),
                 make_team(all.subspan(12, 4), Flow{.exits = {{-30, -12}, {-20, -12}}})};
  return scene;
}

TEST(TeamRuns, are_saved_and_restored) {
  Simulation simulation(all_tasks(), 1), other(all_tasks(), 3);
  test::run_for(simulation, 7.0);
  const std::vector<std::byte> saved = simulation.save();
  test::run_for(simulation, 20.0);
  Simulation resumed(saved, 2);
  EXPECT_EQ(resumed.save(), saved);
  test::run_for(resumed, 20.0);
  EXPECT_EQ(resumed.save(), simulation.save());
  other.restore(saved);
  test::run_for(other, 20.0);
  EXPECT_EQ(other.save(), simulation.save());
  std::vector<std::byte> cut(saved.begin(), saved.end() - 16);
  EXPECT_THROW(Simulation(cut, 1), Error);
}

TEST(TeamRuns, the_host_leads_as_the_scene_does) {
  Scenario scene = all_tasks();
  Simulation led(scene, 1);
  std::vector<Team> teams;
  std::swap(teams, scene.teams);
  Simulation hosted(scene, 1);
  for (int step = 0; step < 300; ++step) {
    led.step();
    for (Team& team : teams) lead(hosted, team);
    hosted.step();
    ASSERT_EQ(led.state_hash(), hosted.state_hash()) << step;
  }
}

}  // namespace
}  // namespace avo
