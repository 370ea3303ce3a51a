// SPDX-License-Identifier: Apache-2.0
// Robots of space with one goal come to rest around it.
#include "space/shared_goals.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "avo/space/check.h"
#include "avo/space/explanation.h"
#include "avo/space/simulation.h"
#include "core/executor.h"
#include "unit/space/draws.h"
#include "unit/space/runs.h"

namespace avo::space::tests {
namespace {

// Robots that come from all sides, 10 to 20 m away.
Scenario rally(int count, std::uint64_t seed) {
  Scenario scene;
  scene.duration = 60.0;
  Draws draws(seed);
  while (static_cast<int>(scene.robots.size()) < count) {
    RobotSetup robot;
    robot.position = draws.between(10.0, 20.0) * draws.direction();
    const bool is_free = std::none_of(
        scene.robots.begin(), scene.robots.end(),
        [&](const RobotSetup& other) { return norm(other.position - robot.position) < 1.2; });
    if (is_free) scene.robots.push_back(robot);
  }
  return scene;
}

// s: when a robot that is alone comes to rest at its goal.
double last_alone(const Scenario& scene) {
  double last = 0.0;
  for (const RobotSetup& robot : scene.robots)
    last = std::max(last, norm(robot.goal - robot.position) / robot.preferred_speed +
                              robot.max_speed / robot.max_acceleration);
  return last;
}

bool all_rest(const Simulation& simulation) {
  const std::span<const Robot> robots = simulation.robots();
  return std::all_of(robots.begin(), robots.end(),
                     [](const Robot& robot) { return robot.velocity == Vec3{}; });
}

// How many count as arrived where they are now, for a judge that knows places alone.
std::int64_t judged_arrived(const Simulation& simulation) {
  std::vector<CheckedRobot> checked;
  std::vector<CheckedState> rows;
  for (std::size_t k = 0; k < simulation.size(); ++k) {
    const Robot& robot = simulation.robots()[k];
    checked.push_back({.downwash = robot.downwash, .goal = simulation.goal({k})});
    rows.push_back({static_cast<std::int64_t>(k), robot.position, robot.velocity});
  }
  Check check(std::move(checked));
  check.add(0.0, rows);
  check.add(0.1, rows);
  return check.report().arrived;
}

// The simulation runs until all robots rest at their goals, and then on. No robot moves again.
void expect_rest(const Scenario& scene) {
  Simulation simulation(scene);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const double most = 2.0 * last_alone(scene) + 10.0;
  while (!(simulation.steps() > 0 && simulation.all_at_goal() && all_rest(simulation)) &&
         simulation.time() < most) {
    simulation.step();
    metrics.observe(simulation);
  }
  EXPECT_TRUE(all_rest(simulation));
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_EQ(judged_arrived(simulation), static_cast<std::int64_t>(simulation.size()));
  std::vector<Vec3> places;
  for (const Robot& robot : simulation.robots()) places.push_back(robot.position);
  for (int k = 0; k < 50; ++k) simulation.step();
  for (std::size_t k = 0; k < places.size(); ++k)
    EXPECT_EQ(simulation.robots()[k].position, places[k]) << "robot " << k;
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
}

TEST(SharedGoalsInSpace, come_to_rest_around_their_goal) {
  for (const int count : {2, 4, 8, 27}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(std::to_string(count) + " robots, seed " + std::to_string(seed));
      expect_rest(rally(count, seed));
    }
  }
}

TEST(SharedGoalsInSpace, come_to_rest_with_downwash) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenario scene = rally(12, seed);
    for (RobotSetup& robot : scene.robots) robot.downwash = 1.0;
    expect_rest(scene);
  }
}

// Thirteen balls that touch reach 1 m from the middle one. They leave more room, and not much more.
TEST(SharedGoalsInSpace, stand_close_together) {
  Simulation simulation(rally(13, 4));
  while (simulation.time() < 40.0) simulation.step();
  for (const Robot& robot : simulation.robots()) EXPECT_LE(norm(robot.position), 2.2);
}

TEST(SharedGoalsInSpace, are_perceived_as_the_step_decides) {
  const Scenario scene = rally(8, 5);
  Simulation simulation(scene);
  int stay = 0, head = 0;
  while (simulation.time() < 25.0) {
    std::vector<Plan> expected;
    for (std::size_t k = 0; k < simulation.size(); ++k) {
      const Explanation why = simulation.explain({k});
      expected.push_back(why.decision.plan);
      stay += why.sentence.find("stays near it") != std::string::npos ? 1 : 0;
      head += why.sentence.find("goes to a free place near it") != std::string::npos ? 1 : 0;
    }
    simulation.step();
    for (std::size_t k = 0; k < simulation.size(); ++k)
      ASSERT_EQ(simulation.plans()[k].next_velocity, expected[k].next_velocity)
          << "robot " << k << " at " << simulation.time() << " s";
  }
  EXPECT_GT(stay, 0);
  EXPECT_GT(head, 0);
}

TEST(SharedGoalsInSpace, let_a_robot_with_another_goal_out) {
  Simulation simulation(rally(8, 6));
  while (simulation.time() < 30.0) simulation.step();
  std::size_t inner = 0;
  for (std::size_t k = 0; k < simulation.size(); ++k)
    if (norm(simulation.robots()[k].position) < norm(simulation.robots()[inner].position))
      inner = k;
  simulation.set_goal({inner}, {0.0, 0.0, 15.0});
  EXPECT_FALSE(simulation.is_at_goal({inner}));
  while (simulation.time() < 90.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_TRUE(all_rest(simulation));
}

// Robots with these goals share this, where no robot stands anywhere yet.
std::vector<SpaceShares> shared(const std::vector<Robot>& robots, const std::vector<Vec3>& goals) {
  SharedGoals found;
  found.set(robots, goals);
  std::vector<SpaceShares> shares;
  for (std::size_t k = 0; k < robots.size(); ++k) shares.push_back(found.of(k));
  return shares;
}

TEST(SharedGoalsInSpace, are_goals_that_both_robots_cannot_have) {
  constexpr auto nothing = SpaceShares::nothing, room = SpaceShares::room, goal = SpaceShares::goal;
  const std::vector<Robot> robots(4);
  const std::vector<Vec3> apart{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(shared(robots, apart), std::vector(4, nothing));
  const std::vector<Vec3> goals{{0, 0, 0}, {5, 0, 0}, {0.5, 0.5, 0.5}, {5, 0, 0}};
  EXPECT_EQ(shared(robots, goals), (std::vector{room, goal, room, goal}));
  std::vector<Robot> blowing(4);
  blowing[3].downwash = 1.5;
  const std::vector<Vec3> above{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 2}};
  EXPECT_EQ(shared(blowing, above), (std::vector{room, nothing, nothing, room}));
}

// Robot 2 has a goal of its own, until robot 1 rests on it, for which there was no room.
TEST(SharedGoalsInSpace, are_those_on_which_robots_rest_that_had_no_room) {
  std::vector<Robot> robots(3);
  const std::vector<Vec3> goals{{0, 0, 0}, {0, 0, 0}, {1.5, 0, 0}};
  robots[1].position = {1.02, 0, 0}, robots[2].position = {5, 0, 0};
  std::vector<std::uint8_t> has_stood{1, 0, 0};
  SharedGoals shares;
  shares.set(robots, goals);
  shares.note(robots, has_stood);
  EXPECT_EQ(shares.of(2), SpaceShares::nothing);
  has_stood[1] = 1, robots[1].velocity = {0.1, 0, 0};
  shares.note(robots, has_stood);
  EXPECT_EQ(shares.of(2), SpaceShares::nothing) << "it moves";
  robots[1].velocity = {};
  shares.note(robots, has_stood);
  EXPECT_EQ(shares.of(2), SpaceShares::room);
  shares.set(robots, goals);
  EXPECT_EQ(shares.of(2), SpaceShares::nothing) << "goals are new";
}

// Some robots find other robots on their goals, and the goals of these other robots are elsewhere.
// All robots count as arrived.
TEST(SharedGoalsInSpace, differ_and_overlap) {
  for (const std::uint64_t seed : {6U, 9U, 13U, 20U, 35U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenario scene = rally(36, seed);
    Draws draws(seed + 100);
    for (RobotSetup& robot : scene.robots) robot.goal = draws.within(2.0);
    expect_rest(scene);
  }
}

// Two robots rest on either side of the goal, so that the place nearest to it is out of sight.
TEST(SharedGoalsInSpace, have_places_where_two_robots_hide_the_nearest) {
  Scenario scene{.duration = 60.0};
  scene.robots.resize(3);
  scene.robots[0].position = {1, 0, 0}, scene.robots[1].position = {-1, 0.5, 0};
  for (const Vec3 start : {Vec3{0, 0, 9}, {0.1, 0.3, 9}, {0, 0, -9}, {2, 8, 3}}) {
    scene.robots[2].position = start;
    expect_rest(scene);
  }
}

// Slow robots see others at rest on the goal from afar.
TEST(SharedGoalsInSpace, are_reached_by_robots_of_any_speed) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenario scene = rally(5, seed);
    Draws draws(seed);
    for (RobotSetup& robot : scene.robots)
      robot.max_speed = robot.preferred_speed = seed % 2 == 0 ? 0.5 : draws.between(0.4, 3.0);
    expect_rest(scene);
  }
}

// Crowds of 15 with goals that overlap, some of them the same, beside robots with goals of their
// own.
Scenario crowds(std::uint64_t seed) {
  Scenario scene;
  Draws draws(seed);
  for (int k = 0; k < 300; ++k) {
    RobotSetup& robot = scene.robots.emplace_back();
    const Vec3 middle{8.0 * (k / 15 % 5), 8.0 * (k / 75), 0.0};
    robot.position = {2.0 * (k % 20), 2.0 * (k / 20), 8.0};
    robot.goal = middle + (k % 3 == 0 ? Vec3{} : draws.within(1.6));
  }
  return scene;
}

TEST(SharedGoalsInSpace, are_the_same_whatever_the_number_of_threads) {
  for (const bool is_noisy : {false, true}) {
    SCOPED_TRACE(is_noisy);
    Scenario scene = crowds(2);
    ASSERT_GE(scene.robots.size(), kFewestParallel);
    if (is_noisy) scene.sensing.noise.position = 0.01, scene.sensing.delay = 1;
    Simulation one(scene, 1), three(scene, 3);
    int stay = 0;
    for (int k = 0; k < 140; ++k) {
      one.step(), three.step();
      ASSERT_EQ(one.state_hash(), three.state_hash()) << "step " << k;
      for (std::size_t r = 0; r < one.size(); ++r) {
        ASSERT_EQ(one.is_at_goal({r}), three.is_at_goal({r})) << "robot " << r << ", step " << k;
        const bool is_far = norm(one.robots()[r].position - one.goal({r})) > scene.arrival_distance;
        stay += is_far && one.is_at_goal({r}) ? 1 : 0;
      }
    }
    EXPECT_GT(stay, is_noisy ? 0 : 100) << "robots rest at places near their goals";
  }
}

// A judge that knows places alone.
TEST(SharedGoalsInSpace, have_arrived_where_robots_at_rest_lead_to_the_goal) {
  const auto arrived = [](Vec3 outer, Vec3 velocity) {
    Check check({CheckedRobot{.goal = Vec3{}}, CheckedRobot{.goal = Vec3{}}}, {});
    for (const double time : {0.0, 0.1})
      check.add(time,
                std::vector<CheckedState>{{0, {}, {}}, {1, outer + time * velocity, velocity}});
    return check.report().arrived;
  };
  EXPECT_EQ(arrived({0.0, 0.0, 1.9}, {}), 2);
  EXPECT_EQ(arrived({0.0, 0.0, 2.1}, {}), 1) << "a robot fits through";
  EXPECT_EQ(arrived({0.0, 0.0, 1.9}, {0.01, 0.0, 0.0}), 1) << "it moves";
}

TEST(SharedGoalsInSpace, may_be_taken_by_a_robot_that_rests_around_its_own) {
  const auto arrived = [](Vec3 middle_goal, Vec3 outer_goal) {
    Check check({CheckedRobot{.goal = Vec3{}}, CheckedRobot{.goal = middle_goal},
                 CheckedRobot{.goal = outer_goal}});
    for (const double time : {0.0, 0.1})
      check.add(time, std::vector<CheckedState>{
                          {0, {}, {}}, {1, {1.1, 0.0, 0.0}, {}}, {2, {2.2, 0.0, 0.0}, {}}});
    return check.report().arrived;
  };
  EXPECT_EQ(arrived({}, {1.6, 0.0, 0.0}), 3);
  EXPECT_EQ(arrived({9.0, 0.0, 0.0}, {1.6, 0.0, 0.0}), 1) << "that one is on its route";
  EXPECT_EQ(arrived({2.2, 0.0, 0.0}, {1.1, 0.0, 0.0}), 1) << "both are on their routes";
}

}  // namespace
}  // namespace avo::space::tests
