// SPDX-License-Identifier: Apache-2.0
// Formations and the assignment of robots to slots.
#include "avo/teams.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;

std::vector<Vec2> random_points(std::size_t count, Random& random) {
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back({random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)});
  return points;
}

double sum_of_ways(const std::vector<Vec2>& from, const std::vector<Vec2>& to,
                   const std::vector<std::size_t>& chosen) {
  double sum = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k) sum += norm(to[chosen[k]] - from[k]);
  return sum;
}

bool do_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

TEST(Teams, assigns_the_slots_of_least_sum) {
  Random random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t robots = 1 + static_cast<std::size_t>(trial % 6);
    const std::vector<Vec2> from = random_points(robots, random);
    const std::vector<Vec2> to =
        random_points(robots + static_cast<std::size_t>(trial % 3), random);
    const std::vector<std::size_t> chosen = assign_slots(from, to);
    EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), robots);
    std::vector<std::size_t> order(to.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double least = 1e9;
    do {
      least = std::min(least, sum_of_ways(from, to, order));
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(sum_of_ways(from, to, chosen), least, 1e-5 * least) << trial;
  }
}

TEST(Teams, assigned_ways_do_not_cross) {
  Random random(4);
  for (int trial = 0; trial < 5; ++trial) {
    const std::vector<Vec2> from = random_points(60, random), to = random_points(60, random);
    const std::vector<std::size_t> chosen = assign_slots(from, to);
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(do_cross(from[i], to[chosen[i]], from[k], to[chosen[k]])) << i << " " << k;
  }
}

// The sums of the ways of robots in a row along the row are equal in any order.
TEST(Teams, a_row_that_moves_along_itself_keeps_its_order) {
  std::vector<Vec2> from, to;
  for (int k = 0; k < 12; ++k) from.push_back({1.0 * k, 0}), to.push_back({20.0 + k, 0});
  const std::vector<std::size_t> chosen = assign_slots(from, to);
  for (std::size_t k = 0; k < chosen.size(); ++k) EXPECT_EQ(chosen[k], k);
  // in whatever order the robots are listed
  const std::vector<Vec2> back(from.rbegin(), from.rend());
  const std::vector<std::size_t> again = assign_slots(back, to);
  for (std::size_t k = 0; k < again.size(); ++k) EXPECT_EQ(again[k], back.size() - 1 - k);
}

TEST(Teams, slots_of_formations_are_a_spacing_apart_about_their_mean) {
  for (const Formation formation :
       {Formation::line, Formation::column, Formation::wedge, Formation::block, Formation::ring}) {
    for (const std::size_t count : {1U, 2U, 3U, 7U, 16U, 23U}) {
      const std::vector<Vec2> slots = formation_slots(formation, count, 1.5);
      ASSERT_EQ(slots.size(), count);
      Vec2 sum;
      for (const Vec2 slot : slots) sum = sum + slot;
      EXPECT_LT(norm(sum), 1e-9) << to_string(formation) << count;
      for (std::size_t i = 0; i < count; ++i) {
        double nearest = 1e9;
        for (std::size_t k = 0; k < count; ++k)
          if (k != i) nearest = std::min(nearest, norm(slots[i] - slots[k]));
        EXPECT_GE(nearest, 1.5 - 1e-9) << to_string(formation) << count;
        // the last row of a block is in its middle
        const bool is_last_row = formation == Formation::block && i + 5 >= count;
        EXPECT_TRUE(count == 1 || is_last_row || nearest < 1.5 + 1e-9) << to_string(formation);
      }
    }
  }
  EXPECT_TRUE(formation_slots(Formation::ring, 0, 1.0).empty());
  const std::vector<Vec2> column = formation_slots(Formation::column, 2, 2.0);
  const std::vector<Vec2> placed = place_slots(column, {5, 1}, 1.5707963267948966);
  EXPECT_NEAR(norm(placed[0] - Vec2{5, 2}), 0.0, 1e-12) << "the first one is ahead";
}

TEST(Teams, slots_are_refused_at_places_that_are_none) {
  const std::vector<Vec2> slots{{1, 0}};
  EXPECT_EQ(refusal([&] {
              place_slots(slots, {NAN, 0}, 0.0);
            }),
            "center.0: found nan, must be a finite number");
  EXPECT_EQ(refusal([&] {
              place_slots(slots, {0, 0}, 1e300);
            }),
            "heading: found 1e+300, must be <= 1e+06 rad");
}

TEST(Teams, forms_up_without_contact) {
  Scenario scene;
  for (int k = 0; k < 16; ++k)
    scene.robots.push_back(test::robot_at({1.7 * (k % 4), 1.9 * (k / 4)}, {0, 0}));
  Simulation simulation(scene, 1);
  std::vector<RobotId> robots(16);
  for (std::size_t k = 0; k < 16; ++k) robots[k] = {k};
  const std::vector<Vec2> slots =
      place_slots(formation_slots(Formation::wedge, 16, 1.6), {30, 5}, 0.0);
  form_up(simulation, robots, slots);
  test::run_for(simulation, 60.0);
  EXPECT_TRUE(simulation.all_at_goal());
  std::set<std::pair<double, double>> goals;
  for (const Vec2 goal : simulation.fleet().goal) goals.insert({goal.x, goal.y});
  EXPECT_EQ(goals.size(), 16U);
}

TEST(Teams, refuse_tasks_out_of_range) {
  const auto refused = [](const TeamTask& task) { return refusal([&] { validate(task); }); };
  EXPECT_EQ(refused(Queue{.line = {{0, 0}}}), "line: found 1 points, must be at least 2");
  EXPECT_EQ(refused(Queue{.line = {{0, 0}, {0, 0}}}),
            "line.1: found the point before it, must be another point");
  EXPECT_EQ(refused(Queue{.line = {{0, 0}, {1, 0}}, .spacing = 0}),
            "spacing: found 0, must be > 0 m");
  EXPECT_EQ(refused(Queue{.line = {{0, 0}, {1, 0}}, .service = -1}),
            "service: found -1, must be >= 0 s");
  EXPECT_EQ(refused(Patrol{}), "points: found 0 points, must be at least 1");
  EXPECT_EQ(refused(Flow{.exits = {{0, 0}, {1, 0}, {2, 0}}}),
            "exits: found 3 points, must be two for each exit");
  EXPECT_EQ(refused(Flow{.exits = {{0, 0}, {1, 0}, {0, 5}, {100, 5}}, .spacing = 0.01}),
            "spacing: found 0.01, must be >= 0.1 m, a thousandth of exit 1");
  EXPECT_EQ(refused(Follow{.slots = {{NAN, 0}}}), "slots.0.0: found nan, must be a finite number");
  EXPECT_EQ(refusal([] { assign_slots(std::vector<Vec2>(2), std::vector<Vec2>(1)); }),
            "slots: found 1, must be at least 2, one for each robot");
  Scenario scene = test::two_lanes();
  scene.teams = {make_team(std::vector<RobotId>{{0}, {2}}, Patrol{.points = {{0, 0}}})};
  EXPECT_EQ(refusal([&] { Simulation simulation(scene, 1); }),
            "teams.0.members: found robot 2, must be 0 to 1");
  scene.teams = {make_team(std::vector<RobotId>{{0}}, Patrol{.points = {{0, 0}}}),
                 make_team(std::vector<RobotId>{{0}}, Patrol{.points = {{0, 0}}})};
  EXPECT_EQ(refusal([&] { Simulation simulation(scene, 1); }),
            "teams.1.members: found robot 0 again, must be in one team at most");
  scene.teams = {make_team(std::vector<RobotId>{{0}}, Patrol{.points = {}})};
  EXPECT_EQ(refusal([&] { Simulation simulation(scene, 1); }),
            "teams.0.points: found 0 points, must be at least 1");
}

}  // namespace
}  // namespace avo
