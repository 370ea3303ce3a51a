// SPDX-License-Identifier: Apache-2.0
// Moving obstacles: contacts in motion and at rest.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/error.h"
#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::report_of;

// A robot at rest in the origin at the times 0, 1, ...
std::vector<Moment> resting(int steps) {
  std::vector<Moment> recording;
  for (int k = 0; k <= steps; ++k) recording.push_back({1.0 * k, {{0, {0, 0}, {0, 0}}}});
  return recording;
}

TEST(CheckObstacles, a_robot_at_rest_is_run_over) {
  const std::vector<CheckedMover> walker{{.position = {-5, 0}, .velocity = {1, 0}}};
  const CheckReport report = report_of({free_robot()}, resting(8), walker);
  EXPECT_EQ(report.mover_contacts_at_rest, 1);
  EXPECT_EQ(report.mover_contacts_moving.count, 0);
  EXPECT_TRUE(report.broken());
  EXPECT_FALSE(report.safe());
  EXPECT_EQ(report.least_clearance, std::nullopt) << "of robots only";
  const CheckReport allowed =
      report_of({free_robot()}, resting(8), walker, {.movers_at_rest = true});
  EXPECT_EQ(allowed.mover_contacts_at_rest, 1);
  EXPECT_TRUE(allowed.safe());
}

// A robot that may be run over at rest may not be hit in motion.
TEST(CheckObstacles, to_be_run_over_at_rest_is_all_that_is_allowed) {
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {1, 0}}}}, {1.0, {{0, {1, 0}, {1, 0}}}}};
  const CheckReport report =
      report_of({free_robot()}, recording, {{.position = {1.5, 0}}}, {.movers_at_rest = true});
  EXPECT_EQ(report.mover_contacts_moving.count, 1);
  EXPECT_FALSE(report.safe());
}

// The second robot is touched at rest at 1.5 s and drives off at 3 s, still in contact: it moved.
TEST(CheckObstacles, each_hit_is_listed_once_with_whether_the_robot_moved) {
  std::vector<Moment> recording;
  for (int k = 0; k <= 6; ++k) {
    const double left = k > 3 ? 0.5 * (k - 3) : 0.0;
    recording.push_back(
        {1.0 * k, {{0, {0, 0}, {0, 0}}, {1, {3.0 + left, 0}, {k > 3 ? 0.5 : 0.0, 0}}}});
  }
  const CheckReport report = report_of({free_robot(), free_robot()}, recording,
                                       {{.position = {0, -6}, .velocity = {0, 2}},
                                        {.position = {0.5, 0}, .velocity = {1, 0}},
                                        {.position = {0, 50}}});
  ASSERT_EQ(report.mover_hits.size(), 3U);
  const auto expect_hit = [&](std::size_t k, double time, int robot, int obstacle, bool moved) {
    const CheckedHit& hit = report.mover_hits[k];
    EXPECT_NEAR(hit.time, time, 1e-6) << k;
    EXPECT_EQ(hit.robot, robot) << k;
    EXPECT_EQ(hit.other, obstacle) << k;
    EXPECT_EQ(hit.moved, moved) << k;
  };
  expect_hit(0, 0.0, 0, 1, false);
  expect_hit(1, 1.5, 1, 1, true);
  expect_hit(2, 2.5, 0, 0, false);
  EXPECT_NEAR(report.mover_hits[2].depth, 1.0, 1e-9) << "it passes over the robot's center";
  EXPECT_EQ(report.mover_contacts_moving.count, 1);
  EXPECT_EQ(report.mover_contacts_at_rest, 2);
  EXPECT_TRUE(report.one_sided_hits.empty());
}

// x = -8 + t²/2 comes within 1 m at t = sqrt(14): in the fourth step, by the clock of the scene.
TEST(CheckObstacles, a_robot_in_motion_may_not) {
  std::vector<Moment> recording;
  for (int k = 2; k <= 6; ++k) recording.push_back({1.0 * k, {{0, {0, 0.001 * k}, {0, 0.001}}}});
  const CheckReport report =
      report_of({free_robot()}, recording, {{.position = {-8, 0}, .acceleration = {1, 0}}});
  EXPECT_EQ(report.mover_contacts_moving.count, 1);
  EXPECT_EQ(report.mover_contacts_at_rest, 0);
  ASSERT_TRUE(report.mover_contacts_moving.first.has_value());
  EXPECT_NEAR(report.mover_contacts_moving.first->time, std::sqrt(14.0), 1e-5);
  EXPECT_EQ(report.mover_contacts_moving.first->robot, 0);
  EXPECT_EQ(report.mover_contacts_moving.first->other, 0);
  EXPECT_FALSE(report.safe());
}

// It turns round before the robot, and comes back.
TEST(CheckObstacles, one_that_is_placed_is_where_it_was_placed) {
  Check check({free_robot()}, {{.position = {-8, 0}, .velocity = {4, 0}}});
  const CheckedState rest{0, {0, 0}, {0, 0}};
  check.place_mover(0, {-8, 0}, {4, 0});
  check.add(0.0, std::vector{rest});
  check.place_mover(0, {-3, 0}, {0, 0});
  check.add(2.0, std::vector{rest});
  check.place_mover(0, {-8, 0}, {-4, 0});
  check.add(4.0, std::vector{rest});
  EXPECT_EQ(check.report().mover_contacts_at_rest, 0);  // as told it would have been at 1.75 s
  check.place_mover(0, {-0.5, 0}, {0, 0});
  check.add(6.0, std::vector{rest});
  EXPECT_EQ(check.report().mover_contacts_at_rest, 1);
  check.add(8.0, std::vector{CheckedState{0, {1, 0}, {1, 0}}});
  EXPECT_EQ(check.report().mover_contacts_moving.count, 1);
  EXPECT_NEAR(check.report().mover_contacts_moving.first->time, 6.0, 1e-9);
  EXPECT_THROW(check.place_mover(1, {}, {}), Error);
}

// It brakes at 1 m/s^2 and rests from 1 s on; the obstacle arrives after that, or a bit before.
TEST(CheckObstacles, braking_in_time_is_rest) {
  const std::vector<Moment> recording{
      {0.0, {{0, {0, 0}, {1, 0}}}}, {1.0, {{0, {0.5, 0}, {0, 0}}}}, {2.0, {{0, {0.5, 0}, {0, 0}}}}};
  // touches x = 1 at 1 s, or 1e-6 s before
  const auto hit = [&](double position) {
    return report_of({free_robot()}, recording,
                     {{.position = {position, 0}, .velocity = {-10, 0}}});
  };
  EXPECT_EQ(hit(11.5 + 1e-5).mover_contacts_moving.count, 0);
  EXPECT_EQ(hit(11.5 + 1e-5).mover_contacts_at_rest, 1);
  // half a nanosecond before, at half a nanometer a second
  EXPECT_EQ(hit(11.5 - 5e-9).mover_contacts_moving.count, 0);
  EXPECT_EQ(hit(11.5 - 1e-5).mover_contacts_moving.count, 1);
  EXPECT_EQ(hit(11.5 - 1e-5).mover_contacts_at_rest, 0);
}

TEST(CheckObstacles, whoever_starts_while_in_contact_is_in_motion) {
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {0, 0}}}},
                                      {1.0, {{0, {0, 0}, {0, 0}}}},
                                      {2.0, {{0, {-0.5, 0}, {-1, 0}}}},
                                      {3.0, {{0, {-2, 0}, {-2, 0}}}}};
  const CheckReport report = report_of({free_robot()}, recording, {{.position = {0.9, 0}}});
  EXPECT_EQ(report.mover_contacts_moving.count, 1);
  EXPECT_EQ(report.mover_contacts_at_rest, 0) << "the pair counts once";
  EXPECT_EQ(report.mover_contacts_moving.first->time, 1.0);
}

TEST(CheckObstacles, rest_is_a_billionth_of_the_speed_limit) {
  CheckedRobot robot;
  robot.max_speed = 2.0;
  const auto creep = [&](double speed) {
    return report_of({robot},
                     {{0.0, {{0, {0, 0}, {speed, 0}}}}, {1.0, {{0, {speed, 0}, {speed, 0}}}}},
                     {{.position = {0.5, 0}}});
  };
  EXPECT_EQ(creep(1.9e-9).mover_contacts_at_rest, 1);
  EXPECT_EQ(creep(2.1e-9).mover_contacts_moving.count, 1);
}

// Rows say that it rests, but it moved in between.
TEST(CheckObstacles, moving_between_rows_is_motion) {
  const CheckReport report =
      report_of({free_robot()}, {{0.0, {{0, {0, 0}, {}}}}, {1.0, {{0, {2, 0}, {}}}}},
                {{.position = {1, 0.5}}});
  EXPECT_EQ(report.mover_contacts_moving.count, 1);
}

TEST(CheckObstacles, pairs_are_counted_each_once) {
  std::vector<Moment> recording;
  for (int k = 0; k <= 3; ++k)
    recording.push_back({1.0 * k, {{0, {0, 0}, {}}, {1, {10.0 + 0.1 * k, 0}, {0.1, 0}}}});
  const CheckReport report = report_of({free_robot(), free_robot()}, recording,
                                       {{.position = {0.5, 0}},
                                        {.position = {-0.5, 0}},
                                        {.position = {10.5, 0}},
                                        {.position = {5, 0}},
                                        {.position = {5, 0.5}}});
  EXPECT_EQ(report.mover_contacts_at_rest, 2);
  EXPECT_EQ(report.mover_contacts_moving.count, 1) << "obstacles among themselves do not count";
  EXPECT_EQ(report.mover_contacts_moving.first->other, 2);
  EXPECT_EQ(report.overlaps.count, 0);
}

TEST(CheckObstacles, exact_contact_and_errors_are_as_for_robots) {
  EXPECT_EQ(report_of({free_robot()}, resting(2), {{.position = {1, 0}}}).mover_contacts_at_rest,
            0);
  const std::vector<CheckedMover> near{{.position = {0.999, 0}}};
  EXPECT_EQ(report_of({free_robot()}, resting(2), near).mover_contacts_at_rest, 1);
  CheckedRobot robot = free_robot();
  robot.interpolation_error = 0.0011;
  EXPECT_EQ(report_of({robot}, resting(2), near).mover_contacts_at_rest, 0);
}

}  // namespace
}  // namespace avo
