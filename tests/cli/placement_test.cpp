// SPDX-License-Identifier: Apache-2.0
// Groups become robots: where they start, where they go, the same on every machine.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <tuple>

#include "avo/reachability.h"
#include "avo_io/scene.h"
#include "io/scene/circle_point.h"
#include "io/scene/random.h"

namespace avo_test {
namespace {

using avo::Scenario;
using avo::Vec2;

Scenario with_group(const std::string& group, const std::vector<std::string>& overrides = {}) {
  return avo_io::parse_scenario("version: 1\ngroups:\n  - " + group + "\n", "f", overrides);
}

TEST(Placement, circle_points_are_those_of_cosine_and_sine) {
  for (const int n : {1, 2, 3, 7, 8, 10, 16, 100, 101, 997}) {
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * k / n;
      const Vec2 point = avo_io::circle_point(k, n);
      EXPECT_NEAR(point.x, std::cos(angle), 2e-15) << k << "/" << n;
      EXPECT_NEAR(point.y, std::sin(angle), 2e-15) << k << "/" << n;
      EXPECT_NEAR(norm(point), 1.0, 3e-16) << k << "/" << n;
    }
  }
}

TEST(Placement, circle_points_turn_by_90_degrees_bit_for_bit) {
  for (const int n : {4, 8, 12, 100, 1000})
    for (int k = 0; k < n; ++k)
      EXPECT_EQ(avo_io::circle_point(k + n / 4, n), perpendicular(avo_io::circle_point(k, n)));
}

/// Built-in circle-N, see the paper's §VI-B.
class CircleTest : public testing::TestWithParam<int> {};

TEST_P(CircleTest, has_its_radius_goals_and_time_enough) {
  const int n = GetParam();
  const Scenario scenario = avo_io::load_scenario("circle-" + std::to_string(n));
  EXPECT_EQ(scenario.name, "circle-" + std::to_string(n));
  ASSERT_EQ(scenario.robots.size(), static_cast<std::size_t>(n));
  const double radius = std::fmax(20.0, 2.25 * n / (2.0 * std::acos(-1.0)));
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const avo::RobotSetup& robot = scenario.robots[i];
    EXPECT_NEAR(norm(robot.position), radius, 1e-12 * radius);
    EXPECT_EQ(robot.goal, Vec2{} - robot.position);
    EXPECT_EQ(robot.velocity, Vec2{});
    const Vec2 next = scenario.robots[(i + 1) % scenario.robots.size()].position;
    EXPECT_GT(cross(robot.position, next) + (n == 2 ? 1.0 : 0.0), 0.0) << "counter-clockwise";
  }
  EXPECT_GT(scenario.duration, 2.0 * radius / 2.0 + 50.0);
  EXPECT_EQ(
      scenario.duration,
      std::ceil(60.0 + 2.0 * norm(scenario.robots[0].goal - scenario.robots[0].position) / 2.0));
  EXPECT_TRUE(avo::advice(scenario).empty()) << avo::advice(scenario)[0];
}

INSTANTIATE_TEST_SUITE_P(N, CircleTest, testing::Values(2, 3, 10, 55, 56, 100, 250, 1000));

TEST(Placement, circle_names_out_of_range_are_refused) {
  for (const char* name :
       {"circle-0", "circle-1", "circle-1000001", "circle-99999999999999999999999"})
    EXPECT_THROW(avo_io::load_scenario(name), avo_io::OverrideError) << name;
  for (const char* name : {"circle-", "circle-x", "circle-010", "circle--5", "circle-1e3"})
    EXPECT_THROW(avo_io::load_scenario(name), avo_io::FileError) << name;
}

TEST(Placement, grid_goes_row_by_row) {
  const Scenario scenario = with_group(
      "{number: 5, placement: {grid: {corner: [1, 2], spacing: 3, columns: 2}}, goals: antipodal}");
  const Vec2 expected[] = {{1, 2}, {4, 2}, {1, 5}, {4, 5}, {1, 8}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(scenario.robots[i].position, expected[i]);
    EXPECT_EQ(scenario.robots[i].goal, (Vec2{5, 10} - expected[i])) << "mirrored in (2.5, 5)";
  }
}

TEST(Placement, line_includes_its_ends) {
  const Scenario scenario = with_group(
      "{number: 3, placement: {line: {from: [0, 0], to: [4, 8]}}, goals: {offset: {by: [10, "
      "-1]}}}");
  EXPECT_EQ(scenario.robots[0].position, (Vec2{0, 0}));
  EXPECT_EQ(scenario.robots[1].position, (Vec2{2, 4}));
  EXPECT_EQ(scenario.robots[2].position, (Vec2{4, 8}));
  EXPECT_EQ(scenario.robots[2].goal, (Vec2{14, 7}));
}

const std::string kRandom =
    "{number: 60, radius: 0.4, placement: {random: {min: [-10, 0], max: [10, 15], clearance: 0.3}},"
    " goals: {random: {min: [20, 20], max: [40, 30], clearance: 0.1}}}";

TEST(Placement, random_keeps_clear_of_all_within_the_rectangle) {
  const Scenario scenario = avo_io::parse_scenario(
      "version: 1\nmoving_obstacles: [{position: [0, 8], radius: 3}]\n"
      "robots: [{position: [5, 5], goal: [0, 0], radius: 1.5}]\ngroups:\n  - " +
          kRandom + "\n",
      "f");
  ASSERT_EQ(scenario.robots.size(), 61U);
  for (std::size_t i = 1; i < scenario.robots.size(); ++i) {
    const avo::RobotSetup& a = scenario.robots[i];
    EXPECT_TRUE(a.position.x >= -10 && a.position.x <= 10 && a.position.y >= 0 &&
                a.position.y <= 15);
    EXPECT_TRUE(a.goal.x >= 20 && a.goal.x <= 40 && a.goal.y >= 20 && a.goal.y <= 30);
    EXPECT_GE(norm(a.position - Vec2{0, 8}), 0.4 + 3 + 0.3);
    EXPECT_GE(norm(a.position - Vec2{5, 5}), 0.4 + 1.5 + 0.3);
    for (std::size_t j = 1; j < i; ++j) {
      EXPECT_GE(norm(a.position - scenario.robots[j].position), 0.8 + 0.3);
      EXPECT_GE(norm(a.goal - scenario.robots[j].goal), 0.8 + 0.1);
    }
  }
}

TEST(Placement, random_is_by_seed_alone) {
  const Scenario one = with_group(kRandom);
  const Scenario again = with_group(kRandom, {"seed=1"});
  const Scenario other = with_group(kRandom, {"seed=2"});
  EXPECT_EQ(one.robots[17].position, again.robots[17].position);
  EXPECT_EQ(one.robots[17].goal, again.robots[17].goal);
  EXPECT_FALSE(one.robots[17].position == other.robots[17].position);
}

TEST(Placement, random_numbers_are_the_same_for_ever) {
  avo_io::Random random(1, 0);
  EXPECT_EQ(random.next(), 9723500816601330998U);
  EXPECT_EQ(random.next(), 16554305226361030140U);
  avo_io::Random stream(1, 1);
  EXPECT_NE(stream.next(), 9723500816601330998U);
}

TEST(Placement, random_numbers_fill_their_interval_evenly) {
  avo_io::Random random(7, 3);
  int counts[10] = {};
  for (int i = 0; i < 100000; ++i) {
    const double u = random.unit();
    ASSERT_TRUE(u >= 0.0 && u < 1.0);
    ++counts[static_cast<int>(10.0 * u)];
  }
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
}

TEST(Placement, permutation_sends_everybody_elsewhere_once) {
  for (const int seed : {1, 2, 3, 4, 5}) {
    const Scenario scenario =
        with_group("{number: 12, placement: {grid: {spacing: 2, columns: 4}}, goals: permutation}",
                   {"seed=" + std::to_string(seed)});
    std::set<std::tuple<double, double>> starts, goals;
    for (const avo::RobotSetup& robot : scenario.robots) {
      EXPECT_FALSE(robot.position == robot.goal);
      starts.emplace(robot.position.x, robot.position.y);
      goals.emplace(robot.goal.x, robot.goal.y);
    }
    EXPECT_EQ(starts, goals);
    EXPECT_EQ(goals.size(), 12U);
  }
}

TEST(Placement, formations_are_slots_to_which_ways_do_not_cross) {
  const Scenario scenario = with_group(
      "{number: 6, placement: {grid: {spacing: 2, columns: 6}}, goals: {formation: {shape: column, "
      "center: [5, 20], spacing: 1.5, heading: 0}}}");
  std::set<double> along;
  for (const avo::RobotSetup& robot : scenario.robots) {
    EXPECT_NEAR(robot.goal.y, 20.0, 1e-9);
    along.insert(robot.goal.x);
  }
  ASSERT_EQ(along.size(), 6U);
  EXPECT_NEAR(*along.rbegin() - *along.begin(), 7.5, 1e-9);
  for (std::size_t k = 1; k < 6; ++k)
    EXPECT_LT(scenario.robots[k - 1].goal.x, scenario.robots[k].goal.x) << "in their order";
}

TEST(Placement, a_task_makes_a_team_of_its_group) {
  const Scenario scenario = with_group(
      "{number: 4, placement: {grid: {spacing: 2, columns: 4}}, goals: {offset: {by: [9, 0]}}, "
      "task: {queue: {line: [[1, 2], [3, 4]], service: 2}}}");
  ASSERT_EQ(scenario.teams.size(), 1U);
  EXPECT_EQ(std::get<avo::Queue>(scenario.teams[0].task),
            (avo::Queue{.line = {{1, 2}, {3, 4}}, .service = 2.0}));
  ASSERT_EQ(scenario.teams[0].members.size(), 4U);
  EXPECT_EQ(scenario.teams[0].members[3].robot, avo::RobotId{3});
  EXPECT_TRUE(std::holds_alternative<avo::Follow>(
      with_group("{number: 2, placement: {grid: {spacing: 2, columns: 4}}, goals: permutation, "
                 "task: follow}")
          .teams[0]
          .task));
}

TEST(Placement, jitter_moves_starts_and_goals_by_chance_and_nothing_else) {
  const std::string group =
      "{number: 40, model: car, car: {heading: random}, placement: {circle: {spacing: 5}}, "
      "goals: antipodal";
  const Scenario plain = with_group(group + "}");
  const Scenario scenario = with_group(group + ", jitter: 0.3}");
  const Scenario other = with_group(group + ", jitter: 0.3}", {"seed=2"});
  double most = 0.0, least = 0.0;  // m
  std::set<double> seen;
  for (std::size_t i = 0; i < 40; ++i) {
    const auto& robot = scenario.robots[i];
    EXPECT_EQ(robot.heading, plain.robots[i].heading);
    EXPECT_NE(robot.position, other.robots[i].position);
    const Vec2 start = robot.position - plain.robots[i].position;
    const Vec2 goal = robot.goal - plain.robots[i].goal;
    for (const double off : {start.x, start.y, goal.x, goal.y}) {
      most = std::fmax(most, off);
      least = std::fmin(least, off);
      seen.insert(off);
    }
  }
  EXPECT_EQ(seen.size(), 160U) << "each by a number of its own";
  EXPECT_LE(most, 0.3);
  EXPECT_GT(most, 0.28);
  EXPECT_GE(least, -0.3);
  EXPECT_LT(least, -0.28);
}

// Two rooms without a door between them, and a closed box of 0.8 m in the first one.
std::string two_rooms_with(const std::string& group) {
  return "version: 1\nseed: 3\nobstacles:\n"
         "  - {polyline: [[-10, -5], [10, -5], [10, 5], [-10, 5], [-10, -5]]}\n"
         "  - {polyline: [[0, -5], [0, 5]]}\n"
         "  - {polygon: [[-6, 0], [-5.2, 0], [-5.2, 0.8], [-6, 0.8]]}\n"
         "groups:\n  - " +
         group + "\n";
}

Scenario in_two_rooms(const std::string& group) {
  return avo_io::parse_scenario(two_rooms_with(group), "f", {});
}

TEST(Placement, random_goals_that_no_way_leads_to_are_drawn_again_and_no_others) {
  const std::string group =
      "{number: 16, radius: 0.3, placement: {grid: {corner: [-9, -4], spacing: 1.1, columns: 4}}, "
      "goals: {random: {min: [-9, -4], max: [9, 4], clearance: 0.4}}}";
  const Scenario scene = in_two_rooms(group);
  EXPECT_TRUE(out_of_reach(scene).empty());
  const std::vector<avo::Wall> walls = walls_of(scene.obstacles);
  avo::Reachability with_clearance(walls, 0.7), reachability(walls, 0.3);
  avo_io::Random random(3, 0);
  std::vector<Vec2> drawn;  // as if no test asked for routes
  while (drawn.size() < 16) {
    const double x = random.between(-9, 9);
    const Vec2 place{x, random.between(-4, 4)};
    const bool is_clear = std::none_of(drawn.begin(), drawn.end(),
                                       [&](Vec2 other) { return norm(place - other) < 1.0; });
    if (is_clear && with_clearance.connects(place, place)) drawn.push_back(place);
  }
  int again = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const avo::RobotSetup& robot = scene.robots[i];
    const bool is_kept = reachability.connects(robot.position, drawn[i]);
    EXPECT_EQ(robot.goal == drawn[i], is_kept) << i;
    again += is_kept ? 0 : 1;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GE(norm(robot.goal - scene.robots[k].goal), 1.0 - 1e-9);
  }
  EXPECT_GE(again, 4);
  EXPECT_LE(again, 12);
}

TEST(Placement, random_starts_that_reach_no_goal_are_drawn_again) {
  for (const char* goals : {"{offset: {by: [7, 0]}}", "antipodal", "permutation",
                            "{random: {min: [-10, -5], max: [10, 5]}}"}) {
    const Scenario scene = in_two_rooms(
        "{number: 20, radius: 0.3, placement: {random: {min: [-10, -5], max: [10, 5]}}, goals: " +
        std::string(goals) + "}");
    const bool can_be_mended = std::string(goals) != "antipodal";  // about the wall between
    EXPECT_EQ(out_of_reach(scene).empty(), can_be_mended) << goals;
    EXPECT_EQ(scene.robots.size(), 20u);
  }
}

TEST(Placement, headings_of_cars) {
  const std::string group =
      "{number: 4, placement: {line: {from: [0, 0], to: [9, 0]}}, goals: {offset: {by: [0, 5]}}, ";
  for (const auto& robot : with_group(group + "car: {wheelbase: 0.5}}").robots)
    EXPECT_NEAR(robot.heading, std::acos(0.0), 1e-15) << "towards the goal";
  for (const auto& robot : with_group(group + "car: {heading: 0.25}}").robots)
    EXPECT_EQ(robot.heading, 0.25);
  const Scenario random = with_group(group + "car: {heading: random}}");
  EXPECT_NE(random.robots[0].heading, random.robots[1].heading);
  for (const auto& robot : random.robots) {
    EXPECT_EQ(std::get<avo::Car>(robot.model).wheelbase, 1.0);
    EXPECT_LE(std::fabs(robot.heading), std::acos(-1.0));
  }
}

TEST(Placement, robots_come_before_groups_and_groups_in_order) {
  const Scenario scenario = avo_io::parse_scenario(R"yaml(version: 1
groups:
  - {number: 2, radius: 0.3, placement: {line: {from: [0, 0], to: [5, 0]}}, goals: antipodal}
  - {number: 2, radius: 0.4, placement: {line: {from: [0, 9], to: [5, 9]}}, goals: antipodal}
robots:
  - {position: [0, 20], goal: [1, 20], radius: 0.2}
)yaml",
                                                   "f");
  ASSERT_EQ(scenario.robots.size(), 5U);
  const double radii[] = {0.2, 0.3, 0.3, 0.4, 0.4};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(scenario.robots[i].radius, radii[i]);
}

TEST(Placement, built_in_scenes_are_what_the_paper_says) {
  const Scenario exchange = avo_io::load_scenario("positions-exchange");
  ASSERT_EQ(exchange.robots.size(), 2U);
  EXPECT_EQ(exchange.robots[0].goal, exchange.robots[1].position);
  EXPECT_EQ(exchange.robots[1].goal, exchange.robots[0].position);
  const Scenario moving = avo_io::load_scenario("moving-obstacle");
  EXPECT_EQ(moving.robots.size(), 1U);
  EXPECT_EQ(moving.moving_obstacles.size(), 1U);
  const Scenario cars = avo_io::load_scenario("cars-100");
  ASSERT_EQ(cars.robots.size(), 100U);
  for (const auto& robot : cars.robots) EXPECT_FALSE(is_holonomic(robot.model));
  for (const Scenario& scenario : {exchange, moving, cars, avo_io::load_scenario("circle-100")}) {
    // the method's own, whatever the method
    EXPECT_EQ(scenario.method, avo::Method::avo);
    EXPECT_FALSE(scenario.control_time);
    EXPECT_FALSE(scenario.time_horizon);
    EXPECT_EQ(scenario.time_step, 0.1);
    EXPECT_TRUE(avo::advice(scenario).empty()) << scenario.name;
    for (const auto& robot : scenario.robots) {
      EXPECT_EQ(robot.max_speed, 2.0);
      EXPECT_EQ(robot.max_acceleration, 1.0);
    }
  }
  EXPECT_EQ(avo_io::load_scenario("circle-100").max_neighbors, 10);
}

}  // namespace
}  // namespace avo_test
