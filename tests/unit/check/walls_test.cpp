// SPDX-License-Identifier: Apache-2.0
// Robots and static obstacles: what counts as a contact, which, when, and how near they came.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "check/box_tree.h"
#include "check/wall_path.h"
#include "support/generators.h"
#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::Random;
using test::refusal;

CheckReport against(const std::vector<CheckedRobot>& robots, const std::vector<Moment>& recording,
                    std::vector<CheckedWall> walls, const CheckOptions& options = {}) {
  Check check(robots, {}, options);
  check.set_walls(std::move(walls));
  for (const Moment& moment : recording) check.add(moment.time, moment.rows);
  return check.report();
}

const CheckedWall kAxis{{-10, 0}, {10, 0}};

// Comes down to 0.25 m from the wall between two rows that are 1 m away: y = 1 - 3 u (1 - u).
const std::vector<Moment> kGrazing{{0.0, {{0, {0, 1}, {0, -3}}}}, {1.0, {{0, {0, 1}, {0, 3}}}}};

TEST(CheckWalls, a_grazing_pass_that_no_row_shows_is_a_contact) {
  const CheckReport report = against({free_robot(0.5)}, kGrazing, {kAxis});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_FALSE(report.safe());
  EXPECT_NEAR(report.static_contacts.worst, 0.25, 1e-9);
  EXPECT_NEAR(*report.least_static_clearance, -0.25, 1e-14);
  ASSERT_TRUE(report.static_contacts.first);
  // 1 - 3 u (1 - u) = 0.5
  EXPECT_NEAR(report.static_contacts.first->time, 0.5 - std::sqrt(0.25 - 0.5 / 3.0), 1e-8);
  EXPECT_EQ(report.static_contacts.first->robot, 0);
  EXPECT_EQ(report.static_contacts.first->other, 0);
  EXPECT_EQ(report.overlaps.count, 0);
}

TEST(CheckWalls, touching_begins_at_the_tolerance) {
  EXPECT_TRUE(against({free_robot(0.25)}, kGrazing, {kAxis}).safe());
  EXPECT_TRUE(against({free_robot(0.25 * (1.0 + 0.9e-9))}, kGrazing, {kAxis}).safe());
  EXPECT_FALSE(against({free_robot(0.25 * (1.0 + 1.1e-9))}, kGrazing, {kAxis}).safe());
  CheckOptions wide;
  wide.relative_tolerance = 0.5;
  EXPECT_TRUE(against({free_robot(0.49)}, kGrazing, {kAxis}, wide).safe());
}

TEST(CheckWalls, a_wall_is_as_thick_as_its_radius) {
  CheckedWall thick = kAxis;
  thick.radius = 0.1;
  EXPECT_TRUE(against({free_robot(0.15)}, kGrazing, {thick}).safe());
  const CheckReport report = against({free_robot(0.2)}, kGrazing, {thick});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_NEAR(*report.least_static_clearance, -0.05, 1e-14);
}

TEST(CheckWalls, a_disc_is_a_wall_without_length) {
  const CheckedWall disc{{0.3, 0.25 - 0.4}, {0.3, 0.25 - 0.4}, 0.4};
  EXPECT_TRUE(against({free_robot(0.0999)}, kGrazing, {disc}).safe());
  const CheckReport report = against({free_robot(0.2)}, kGrazing, {disc});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_NEAR(*report.least_static_clearance, 0.5 - 0.6, 1e-14);
}

// Robots at rest 0.4 m from their goals.
struct Waiting {
  Vec2 position, goal;
};

CheckReport arrivals(const std::vector<Waiting>& waiting, std::vector<CheckedWall> walls) {
  std::vector<CheckedRobot> robots;
  std::vector<CheckedState> rows;
  for (const Waiting& robot : waiting) {
    rows.push_back({static_cast<std::int64_t>(robots.size()), robot.position, {}});
    robots.push_back(free_robot(0.1));
    robots.back().goal = robot.goal;
  }
  return against(robots, {{0.0, rows}}, std::move(walls));
}

TEST(CheckWalls, nobody_arrives_where_a_wall_lies_before_the_goal) {
  const CheckReport report = arrivals({{{0, 0.2}, {0, -0.2}},        // across the wall
                                       {{3, 0.2}, {3, 0.6}},         // beside it
                                       {{10.2, 0.2}, {10.2, -0.2}},  // past its end
                                       {{4, 0.5}, {4, 0.5}}},        // at the goal itself
                                      {kAxis, {{-9, 5}, {9, 5}}});
  EXPECT_EQ(report.arrived, 3);
  EXPECT_EQ(report.at_goal_at_end, 3);
  EXPECT_EQ(report.not_arrived, std::vector<std::int64_t>{0});
  EXPECT_FALSE(report.last_arrival);
}

TEST(CheckWalls, thick_walls_hide_goals_that_their_lines_do_not) {
  const std::vector<Waiting> past_the_end{{{10.2, 0.2}, {10.2, -0.2}}};
  EXPECT_EQ(arrivals(past_the_end, {kAxis}).arrived, 1);
  EXPECT_EQ(arrivals(past_the_end, {{kAxis.a, kAxis.b, 0.19}}).arrived, 1);
  EXPECT_EQ(arrivals(past_the_end, {{kAxis.a, kAxis.b, 0.21}}).arrived, 0);
}

// Past the end of a wall only the end counts.
TEST(CheckWalls, end_points_are_round) {
  const CheckedWall to_the_left{{0.3, 0.25 - 0.4}, {20, 0.25 - 0.4}};
  EXPECT_NEAR(*against({free_robot(0.2)}, kGrazing, {to_the_left}).least_static_clearance, 0.3,
              1e-14);
  std::vector<Moment> along{{0.0, {{0, {-5, 0}, {1, 0}}}}, {1.0, {{0, {-4, 0}, {1, 0}}}}};
  EXPECT_NEAR(*against({free_robot(0.2)}, along, {{{-3, 0}, {-2, 0}, 0.1}}).least_static_clearance,
              0.7, 1e-14);
}

TEST(CheckWalls, a_robot_counts_once_whatever_it_touches) {
  std::vector<Moment> recording;
  for (int k = 0; k <= 6; ++k)
    recording.push_back(
        {1.0 * k, {{0, {2.0 * k, 0}, {2, 0}}, {1, {2.0 * k, 30}, {2, 0}}, {2, {0, 60}, {}}}});
  const std::vector<CheckedWall> walls{{{7, -1}, {7, 40}}, {{3, -1}, {3, 1}}, {{5, -1}, {5, 1}}};
  const CheckReport report = against(std::vector<CheckedRobot>(3, free_robot()), recording, walls);
  EXPECT_EQ(report.static_contacts.count, 2);
  EXPECT_EQ(report.static_contacts.first->robot, 0);
  EXPECT_EQ(report.static_contacts.first->other, 1);
  EXPECT_NEAR(report.static_contacts.first->time, 1.25, 1e-8);
  EXPECT_NEAR(report.static_contacts.worst, 0.5, 1e-8) << "right through it";
}

// A fast robot is on the other side in every row.
TEST(CheckWalls, a_wall_that_is_jumped_over_between_rows_is_touched) {
  const std::vector<Moment> through{{0.0, {{0, {0, -50}, {0, 100}}}},
                                    {1.0, {{0, {0, 50}, {0, 100}}}}};
  const CheckReport report = against({free_robot(0.1)}, through, {kAxis});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_NEAR(report.static_contacts.first->time, 0.499, 1e-9);
  EXPECT_NEAR(*report.least_static_clearance, -0.1, 1e-12);
}

TEST(CheckWalls, straight_lines_are_judged_as_such) {
  CheckedRobot robot = free_robot(0.5);
  robot.straight = true;
  EXPECT_EQ(*against({robot}, kGrazing, {kAxis}).least_static_clearance, 0.5);
}

TEST(CheckWalls, what_the_path_may_be_off_is_granted_between_rows_only) {
  CheckedRobot robot = free_robot(0.5);
  robot.interpolation_error = 0.26;
  EXPECT_TRUE(against({robot}, kGrazing, {kAxis}).safe());
  robot.interpolation_error = 0.2;
  const CheckReport report = against({robot}, kGrazing, {kAxis});
  EXPECT_NEAR(report.static_contacts.worst, 0.05, 1e-8);
  EXPECT_NEAR(*report.least_static_clearance, -0.25, 1e-14);
  robot.radius = 1.1;
  robot.interpolation_error = 5.0;
  const CheckReport at_rows = against({robot}, kGrazing, {kAxis});
  EXPECT_NEAR(at_rows.static_contacts.worst, 0.1, 1e-8);
  EXPECT_EQ(at_rows.static_contacts.first->time, 0.0);
}

TEST(CheckWalls, a_robot_may_not_appear_in_one) {
  const CheckReport report =
      against({free_robot(), free_robot()},
              {{0.0, {{0, {0, 5}, {}}}}, {1.0, {{0, {0, 5}, {}}, {1, {0, 0.2}, {9, 9}}}}}, {kAxis});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_EQ(report.static_contacts.first->robot, 1);
  EXPECT_EQ(report.static_contacts.first->time, 1.0);
  EXPECT_NEAR(*report.least_static_clearance, -0.3, 1e-15);
}

TEST(CheckWalls, without_walls_there_is_no_clearance) {
  const CheckReport report = against({free_robot()}, kGrazing, {});
  EXPECT_EQ(report.static_contacts.count, 0);
  EXPECT_EQ(report.least_static_clearance, std::nullopt);
}

// A door that closes behind a robot, and one that opens before it.
TEST(CheckWalls, may_change_between_steps) {
  Check check({free_robot()});
  const auto at = [&check](double time) {
    const CheckedState row{0, {time, 0}, {1, 0}};
    check.add(time, std::span(&row, 1));
  };
  const CheckedWall before{{0, -1}, {0, 1}}, behind{{6, -1}, {6, 1}};
  check.set_walls({behind});
  for (int k = 1; k <= 5; ++k) at(k);
  check.set_walls({before});
  for (int k = 6; k <= 9; ++k) at(k);
  EXPECT_TRUE(check.report().safe());
  EXPECT_EQ(*check.report().least_static_clearance, 0.5);
  check.set_walls({behind, before, {{9.2, 0}, {9.2, 0}}});
  at(10);
  EXPECT_EQ(check.report().static_contacts.first->time, 9.0) << "in the row before";
  EXPECT_EQ(check.report().static_contacts.first->other, 2);
}

TEST(CheckWalls, bad_walls_are_refused_and_change_nothing) {
  Check check({free_robot()});
  check.set_walls({kAxis});
  EXPECT_EQ(refusal([&] {
              check.set_walls({kAxis, {{0, 1e13}, {}}});
            }),
            "walls.1.a.1: found 1e+13, must be <= 1e+12 m");
  EXPECT_EQ(refusal([&] {
              check.set_walls({{{}, {}, -1.0}});
            }),
            "walls.0.radius: found -1, must be >= 0 m");
  EXPECT_EQ(refusal([&] {
              check.set_walls({{{}, {std::nan(""), 0}}});
            }),
            "walls.0.b.0: found nan, must be a finite number");
  for (const Moment& moment : kGrazing) check.add(moment.time, moment.rows);
  EXPECT_EQ(check.report().static_contacts.count, 1);
}

TEST(CheckWalls, far_from_the_origin_nothing_is_lost) {
  const Vec2 far{3e8, -7e8};
  std::vector<Moment> recording = kGrazing;
  for (Moment& moment : recording) moment.rows[0].position = moment.rows[0].position + far;
  const CheckReport report =
      against({free_robot(0.5)}, recording, {{kAxis.a + far, kAxis.b + far}});
  EXPECT_NEAR(*report.least_static_clearance, -0.25, 1e-14);
}

// Against all robots and walls one by one: thin, thick, long and without length, crowded and
// scattered.
TEST(CheckWalls, agree_with_all_of_them_one_by_one) {
  Random random(15);
  for (const double half : {3.0, 30.0, 300.0}) {
    for (int run = 0; run < 10 && !HasFailure(); ++run) {
      std::vector<CheckedWall> walls;
      for (int k = 0; k < 40 * run; ++k) {
        const Vec2 a{random.uniform(-half, half), random.uniform(-half, half)};
        const double length = random.below(3) == 0 ? 0.0 : random.log_uniform(0.1, half);
        const double radius = random.below(2) == 0 ? 0.0 : random.log_uniform(0.01, 1.0);
        walls.push_back({a, a + length * random.direction(), radius});
      }
      std::vector<CheckedRobot> robots;
      for (int i = 0; i < 20; ++i) robots.push_back(free_robot(random.log_uniform(0.05, 0.5)));
      std::vector<Moment> recording{{0.0, {}}, {1.0, {}}};
      double least = 1.0 / 0.0, worst = 0.0;
      std::set<std::int64_t> touched;
      for (std::int64_t i = 0; i < 20; ++i) {
        const auto any = [&] {
          return Vec2{random.uniform(-half, half), random.uniform(-half, half)};
        };
        const Vec2 from = any(), v0 = test::in_disc(random, 9.0), v1 = test::in_disc(random, 9.0);
        const Vec2 to = random.below(4) == 0 ? any() : from + test::in_disc(random, 4.0);
        recording[0].rows.push_back({i, from, v0});
        recording[1].rows.push_back({i, to, v1});
        for (const CheckedWall& wall : walls) {
          const Vec2 c0 = from - wall.a, c3 = to - wall.a;
          const judge::WallPath path{{{c0, c0 + (1.0 / 3.0) * v0, c3 - (1.0 / 3.0) * v1, c3}},
                                     wall.b - wall.a};
          const double contact = robots[static_cast<std::size_t>(i)].radius + wall.radius;
          const double distance = judge::nearest_instant(path).distance;
          least = std::min(least, distance - contact);
          worst = std::max(worst, contact * (1.0 - 1e-9) - distance);
          if (distance < contact * (1.0 - 1e-9)) touched.insert(i);
        }
      }
      const CheckReport report = against(robots, recording, walls);
      EXPECT_EQ(report.static_contacts.count, static_cast<std::int64_t>(touched.size()));
      EXPECT_EQ(report.least_static_clearance.value_or(1.0 / 0.0), least);
      EXPECT_EQ(report.static_contacts.worst, worst);
    }
  }
}

TEST(CheckWalls, may_change_between_two_times) {
  const auto row = [](double time, double x) { return Moment{time, {{0, {x, 0}, {1, 0}}}}; };
  const CheckedWall door{{1.5, -1}, {1.5, 1}};
  for (const int closed : {0, 1, 2}) {
    Check check({free_robot(0.25)});
    for (int k = 0; k <= 3; ++k) {
      // the step from k - 1 to k
      check.set_walls(k - 1 == closed ? std::vector{door} : std::vector<CheckedWall>{});
      const Moment moment = row(k, k);
      check.add(moment.time, moment.rows);
    }
    EXPECT_EQ(check.report().static_contacts.count, closed == 1 ? 1 : 0);
    EXPECT_DOUBLE_EQ(*check.report().least_static_clearance, closed == 1 ? -0.25 : 0.25);
  }
}

TEST(BoxTree, visits_all_boxes_that_are_near) {
  Random random(16);
  for (const std::size_t number : {0, 1, 4, 5, 100, 1000}) {
    std::vector<judge::BoundingBox> boxes;
    const auto any = [&random](std::size_t owner) {
      judge::BoundingBox box{{}, {}, owner};
      for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = random.uniform(-10.0, 10.0);
        box.high[k] = box.low[k] + random.log_uniform(1e-3, 20.0);
      }
      return box;
    };
    for (std::size_t i = 0; i < number; ++i) boxes.push_back(any(i));
    const judge::BoxTree tree(boxes);
    for (int k = 0; k < 50; ++k) {
      const judge::BoundingBox box = any(0);
      const double reach = random.uniform(0.0, 3.0);
      std::multiset<std::size_t> expected, visited;
      for (const judge::BoundingBox& each : boxes)
        if (judge::gap(each, box) < reach) expected.insert(each.owner);
      tree.visit(
          box, [reach] { return reach; }, [&visited](std::size_t owner) { visited.insert(owner); });
      EXPECT_EQ(visited, expected);
    }
  }
}

}  // namespace
}  // namespace avo
