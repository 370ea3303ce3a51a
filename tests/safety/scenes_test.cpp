// SPDX-License-Identifier: Apache-2.0
// The scenes are what they say: where each robot stands, how long the straight course takes, and
// how dense the scene is.
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "alone_scenes.h"
#include "avo/assumptions.h"
#include "avo/error.h"
#include "avo/simulation.h"
#include "avo_io/sweep.h"
#include "density.h"
#include "evadable.h"
#include "families.h"
#include "placement.h"
#include "wall_scenes.h"

namespace avo::safety {
namespace {

double nearest_pair(const std::vector<Vec2>& points) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, norm(points[i] - points[j]));
  }
  return nearest;
}

RobotSetup robot_at(Vec2 position, double radius) {
  RobotSetup robot;
  robot.position = robot.goal = position;
  robot.radius = radius;
  return robot;
}

Scene scene_of(const std::string& name) {
  for (const Family& family : families(1e4))
    if (family.name == name) return family.make(2);
  throw Error("found no row " + name);
}

TEST(Families, have_names_of_their_own_and_start_clear_and_at_rest) {
  std::set<std::string> names;
  for (const Family& family : families(1e4)) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    const Scenario scenario = family.make(3).scenario;
    EXPECT_NO_THROW(validate(scenario)) << family.name;
    const auto& robots = scenario.robots;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      // airplanes cannot be at rest
      const bool moves = !can_rest(robots[i].model) || family.name == "alone-surprised";
      EXPECT_EQ(robots[i].velocity == Vec2{}, !moves) << family.name;
      for (std::size_t j = 0; j < i; ++j) {
        const double gap = norm(disc_center(robots[i]) - disc_center(robots[j])) -
                           disc_radius(robots[i]) - disc_radius(robots[j]);
        EXPECT_GT(gap, 0.01) << family.name << " " << i << " " << j;
      }
      for (const MovingObstacle& obstacle : scenario.moving_obstacles) {
        EXPECT_GT(norm(disc_center(robots[i]) - obstacle.position),
                  disc_radius(robots[i]) + obstacle.radius);
      }
      for (const Wall& wall : walls_of(scenario.obstacles)) {
        EXPECT_GT(wall_clearance(disc_center(robots[i]), wall), disc_radius(robots[i]) + 0.04)
            << family.name;
      }
    }
  }
}

TEST(Families, seeds_decide_where_they_say_so) {
  for (const Family& family : families(1e4)) {
    const auto start = [&](std::uint64_t seed) {
      const Scenario scenario = family.make(seed).scenario;
      const RobotSetup& robot = scenario.robots.back();
      if (family.name.starts_with("alone-") || family.name == "eight-movers")
        return std::pair(scenario.moving_obstacles[0].position, robot.goal);
      return std::pair(scenario.robots[1].position, scenario.robots[1].goal);
    };
    EXPECT_TRUE(start(1) == start(1)) << family.name;
    EXPECT_EQ(start(1) != start(2), family.seeded) << family.name;
  }
}

TEST(Families, random_squares_have_the_density_asked_for) {
  const Scenario scenario = scene_of("random-60").scenario;
  double extent = 0.0;
  std::vector<Vec2> starts, goals;
  for (const RobotSetup& robot : scenario.robots) {
    extent = std::max({extent, std::abs(robot.position.x), std::abs(robot.position.y)});
    starts.push_back(robot.position);
    goals.push_back(robot.goal);
  }
  EXPECT_NEAR(extent, 0.5 * std::sqrt(60.0 * kPi * 0.25 / 0.12), 0.5);
  EXPECT_GE(nearest_pair(starts), 1.3);
  EXPECT_GE(nearest_pair(goals), 1.5);
}

TEST(Families, unequal_robots_are_unequal) {
  for (const Scenario& scenario : {mixed(1).scenario, crush(false, 1e3, 1).scenario}) {
    const auto [weak, strong] = std::minmax_element(
        scenario.robots.begin(), scenario.robots.end(),
        [](const auto& a, const auto& b) { return a.max_acceleration < b.max_acceleration; });
    EXPECT_LT(weak->max_acceleration, 0.5);
    EXPECT_GT(strong->max_acceleration, 2.8);
    const auto [small, large] =
        std::minmax_element(scenario.robots.begin(), scenario.robots.end(),
                            [](const auto& a, const auto& b) { return a.radius < b.radius; });
    EXPECT_GT(large->radius, 1.9 * small->radius);
  }
}

TEST(Families, unequal_robots_see_as_far_as_they_need) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Scenario& scenario : {mixed(seed).scenario, crush(false, 1e3, seed).scenario}) {
      EXPECT_TRUE(broken_assumptions(scenario).none());
      most = std::max(most, sensing_radius_of(scenario));
    }
  }
  EXPECT_GT(most, 15.0);  // the others' radius would not do
}

TEST(Families, among_walls_keep_what_their_certificate_assumes) {
  for (const Family& family : families(1e4)) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Scenario scenario = family.make(seed).scenario;
      if (scenario.obstacles.empty()) continue;
      scenario.certificate = Certificate::braking_trajectories;
      EXPECT_TRUE(broken_assumptions(scenario).none()) << family.name << " " << seed;
    }
  }
}

TEST(Families, alone_have_1_to_10_movers_and_all_time_steps) {
  std::set<std::size_t> counts;
  std::set<double> time_steps;
  for (std::uint64_t seed = 1; seed <= 90; ++seed) {
    const Scene scene = alone_crossing(seed);
    EXPECT_TRUE(scene.alone);
    counts.insert(scene.scenario.moving_obstacles.size());
    time_steps.insert(scene.scenario.time_step);
  }
  EXPECT_EQ(counts.size(), 10U);
  EXPECT_EQ(*counts.rbegin(), 10U);
  EXPECT_EQ(*time_steps.begin(), 0.02);
  EXPECT_EQ(*time_steps.rbegin(), 0.25);
}

// A mover that comes straight at a robot at rest, that far away.
Scenario comes(double away, double speed, double radius) {
  Scenario scenario = usual_scenario();
  scenario.robots = {usual_robot({}, {}, kSpeed)};
  MovingObstacle mover;
  mover.position = {-away - radius - 0.5, 0.0}, mover.velocity = {speed, 0.0};
  mover.radius = radius;
  scenario.moving_obstacles = {mover};
  scenario.duration = 6.0;
  return scenario;
}

// Aside by 1 m takes a little more than √2 s at 1 m/s².
TEST(Evadable, is_what_some_motion_evades) {
  EXPECT_TRUE(is_evadable(comes(4.0, 2.0, 0.5)));
  EXPECT_TRUE(is_evadable(comes(3.0, 2.0, 0.5)));
  EXPECT_FALSE(is_evadable(comes(1.0, 2.0, 0.5)));
  EXPECT_TRUE(is_evadable(comes(1.0, 0.5, 0.5))) << "there is more time";
  EXPECT_TRUE(is_evadable(comes(3.0, 2.0, 8.0))) << "the robot runs, and becomes as fast";
  EXPECT_FALSE(is_evadable(comes(1.5, 2.0, 8.0))) << "too late";
  Scenario row = comes(6.0, 3.0, 0.5);
  EXPECT_TRUE(is_evadable(row));
  for (const double y : {-3.8, -1.9, 1.9, 3.8}) {
    row.moving_obstacles.push_back(row.moving_obstacles[0]);
    row.moving_obstacles.back().position.y = y;
  }
  EXPECT_FALSE(is_evadable(row)) << "between them is no room";
}

// On a path it turns back; by its velocity it would not.
TEST(Evadable, knows_paths) {
  Scenario scenario = comes(4.0, 1.0, 8.0);
  MovingObstacle& mover = scenario.moving_obstacles[0];
  mover.max_deviation = 2.0, mover.max_speed = 2.0;
  mover.path = {mover.position + Vec2{3.0, 0.0}, mover.position};
  mover.radius = 1.0;
  EXPECT_TRUE(is_evadable(scenario));
  mover.radius = 8.0, mover.path[0].x += 30.0, mover.max_speed = 4.0;
  EXPECT_FALSE(is_evadable(scenario));
}

// The robots but the last one are at their goals, and stand around the goal of the last one.
TEST(Families, goals_are_among_robots_at_their_goals) {
  const std::pair<const char*, std::size_t> rows[] = {{"ring", 9}, {"deep", 37}};
  for (const auto& [name, count] : rows) {
    const std::vector<RobotSetup> robots = scene_of(name).scenario.robots;
    ASSERT_EQ(robots.size(), count) << name;
    EXPECT_EQ(robots.back().goal, Vec2{}) << name;
    EXPECT_GE(norm(robots.back().position), 10.0 - 1e-12) << name;
    int around = 0;  // robots too near to the goal and to each other for a passage
    for (std::size_t i = 0; i + 1 < count; ++i) {
      EXPECT_LT(norm(robots[i].goal - robots[i].position), 0.1) << name;
      around += norm(robots[i].position) < 1.4 ? 1 : 0;
    }
    EXPECT_EQ(around, name == std::string("ring") ? 8 : 6) << name;
  }
}

TEST(Families, columns_of_the_block_exchange_places) {
  const std::vector<RobotSetup> robots = scene_of("block-swap").scenario.robots;
  ASSERT_EQ(robots.size(), 64U);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const std::size_t partner = i / 8 % 2 == 0 ? i + 8 : i - 8;
    EXPECT_LT(norm(robots[i].goal - robots[partner].position), 0.2) << i;
  }
}

// One robot of that radius in the scene's walls, from one place to another.
bool gets_through(const Scene& scene, double radius, Vec2 from, Vec2 to) {
  Scenario scenario = scene.scenario;
  scenario.certificate = Certificate::none;
  scenario.robots.resize(1);
  scenario.robots[0].position = from;
  scenario.robots[0].goal = to;
  scenario.robots[0].radius = radius;
  return Simulation(scenario, 1).unreachable().empty();
}

TEST(Families, passages_are_as_wide_as_they_say) {
  const auto expect_width = [](const Scene& scene, double width, Vec2 from, Vec2 to) {
    EXPECT_TRUE(gets_through(scene, 0.5 * width - 1e-8, from, to)) << width;
    EXPECT_FALSE(gets_through(scene, 0.5 * width + 1e-8, from, to)) << width;
  };
  expect_width(scene_of("doorway-1.6"), 1.6, {-8.0, 3.0}, {8.0, -3.0});
  expect_width(scene_of("corridor-1.6"), 1.6, {-12.0, 3.0}, {12.0, -3.0});
  expect_width(scene_of("corridor-2.4"), 2.4, {-12.0, 3.0}, {12.0, -3.0});
  expect_width(scene_of("office-1.6"), 1.6, {3.0, 4.5}, {27.0, -4.5});
  expect_width(scene_of("office-1.2"), 1.2, {3.0, 4.5}, {27.0, -4.5});
  for (const Vec2 cell : {Vec2{1.5, 28.5}, {28.5, 1.5}, {28.5, 28.5}, {13.5, 16.5}})
    expect_width(scene_of("maze"), 3.0, {1.5, 1.5}, cell);
  // of gaps between walls, only robots that fit get through; the widest gap is for 0.5 m
  expect_width(wall_gaps(1e3, 1), 1.0 + 1e-6, {-5.0, 0.0}, {5.0, 0.0});
}

TEST(Families, passages_are_used_both_ways) {
  for (const char* name : {"doorway-1.6", "corridor-1.6", "corridor-2.4"}) {
    int to_the_right = 0, to_the_left = 0;
    for (const RobotSetup& robot : scene_of(name).scenario.robots) {
      EXPECT_LT(robot.position.x * robot.goal.x, 0.0);
      ++(robot.goal.x > 0.0 ? to_the_right : to_the_left);
    }
    EXPECT_EQ(to_the_right, 25) << name;
    EXPECT_EQ(to_the_left, 25) << name;
  }
}

// So that rows that YAML says and the others can be compared.
TEST(Families, that_are_read_have_the_usual_settings) {
  const Scenario usual = usual_scenario();
  for (const char* name :
       {"circle-100", "circle-100-jitter", "swap", "streams", "permutation", "random-30", "doorway",
        "ring", "deep", "block-swap", "clump-100", "doorway-1.6", "corridor-2.4", "office-1.2",
        "maze", "dropped-5%-circle"}) {
    const Scenario scenario = scene_of(name).scenario;
    EXPECT_EQ(scenario.time_step, usual.time_step) << name;
    EXPECT_EQ(scenario.sensing_radius, usual.sensing_radius) << name;
    EXPECT_EQ(scenario.max_neighbors, usual.max_neighbors) << name;
    EXPECT_EQ(scenario.arrival_distance, usual.arrival_distance) << name;
    for (const RobotSetup& robot : scenario.robots) {
      const RobotSetup like =
          usual_robot({}, {}, std::string_view(name).starts_with("circle-") ? 2.0 : kSpeed);
      EXPECT_EQ(robot.radius, like.radius) << name;
      EXPECT_EQ(robot.max_speed, like.max_speed) << name;
      EXPECT_EQ(robot.max_acceleration, like.max_acceleration) << name;
      EXPECT_EQ(robot.preferred_speed, like.preferred_speed) << name;
    }
  }
}

// The files that make the same runs by `avo sweep`, with their numbers of runs.
TEST(Families, are_sweeps_as_well) {
  const std::pair<const char*, int> sweeps[] = {
      {"circles", 240}, {"squares", 800}, {"crowds", 120}, {"passages", 100}};
  for (const auto& [name, runs] : sweeps) {
    const auto sweep = avo_io::load_sweep(std::string(AVO_SAFETY_SWEEPS "/") + name + ".yaml");
    EXPECT_EQ(run_count(sweep), runs) << name;
  }
}

TEST(Families, among_walls_come_with_both_motions_and_with_cars) {
  int held = 0, cars = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    held += random_walls(1e3, seed).scenario.motion == Motion::held ? 1 : 0;
    for (const RobotSetup& robot : walls_and_cars(1e3, seed).scenario.robots) {
      cars += is_holonomic(robot.model) ? 0 : 1;
    }
  }
  EXPECT_EQ(held, 10);
  EXPECT_EQ(cars, 20 * 15);
}

TEST(Placement, permutations_leave_nobody_in_place) {
  Random random(1, 1);
  for (int n = 2; n < 40; ++n) {
    const std::vector<Vec2> points = block({}, n, 1, 1.0);
    const std::vector<Vec2> dealt = dealt_anew(points, random);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_FALSE(points[i] == dealt[i]);
    EXPECT_EQ(nearest_pair(dealt), 1.0);
  }
}

TEST(StraightTime, is_that_of_the_slowest_from_rest_to_rest) {
  Scenario scenario;
  scenario.robots.push_back(usual_robot({}, {30.0, 0.0}, 1.5));
  EXPECT_DOUBLE_EQ(straight_time(scenario), 21.5);  // 20 s to drive, 1.5 s to start and stop
  scenario.robots[0].goal = {0.0, 0.25};            // too short for 1.5 m/s
  EXPECT_DOUBLE_EQ(straight_time(scenario), 1.0);
}

TEST(SeeFarEnough, widens_for_robots_that_brake_longer) {
  Scenario scenario = mixed(1).scenario;
  const double for_braking = sensing_radius_of(scenario);
  for (RobotSetup& robot : scenario.robots) robot.max_acceleration *= 0.4;
  see_far_enough(scenario);
  EXPECT_GT(sensing_radius_of(scenario), 1.5 * for_braking);
  EXPECT_FALSE(broken_assumptions(scenario).unseen);
}

TEST(Density, of_the_densest_arrangement_is_that_of_the_densest_packing) {
  Scenario scenario;
  for (const Vec2 p : triangular_block(41, 47, 1.0)) scenario.robots.push_back(robot_at(p, 0.5));
  const double dense = densest_disc(Simulation(scenario, 1).fleet());
  EXPECT_GT(dense, kDensestPacking - 0.001);
  EXPECT_LT(dense, kDensestPacking + 0.01);
}

TEST(Density, counts_parts_of_robots) {
  // the disc about 0 that reaches the centers of the outer two, r = 1: of each it holds less than
  // half, and all of the middle one
  Scenario scenario;
  for (const double x : {-1.0, 0.0, 1.0}) scenario.robots.push_back(robot_at({x, 0.0}, 0.25));
  const double c = 0.125, a = std::acos(c), b = std::acos(1.0 - 0.5 * 0.0625);
  const double lens = 0.0625 * a + b - 0.5 * std::sqrt(0.0625 * (4.0 - 0.0625));
  const double two = (0.0625 * kPi + 2.0 * lens) / kPi;
  EXPECT_NEAR(densest_disc(Simulation(scenario, 1).fleet()), two, 1e-12);
}

TEST(Density, is_that_of_a_quarter_of_the_robots_or_more) {
  Scenario scenario;
  for (const double x : {-9.0, -5.0, -2.0, -1.0, 1.0, 2.0, 5.0, 9.0}) {
    scenario.robots.push_back(robot_at({x, 0.0}, 0.25));
  }
  // within 2 m: two and nearly two halves; within 1 m it would be 0.06, within 5 m 0.01
  EXPECT_NEAR(densest_disc(Simulation(scenario, 1).fleet()), 3.0 * 0.0625 / 4.0, 0.003);
}

}  // namespace
}  // namespace avo::safety
