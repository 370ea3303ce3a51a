// SPDX-License-Identifier: Apache-2.0
// The judge of space on motion with a known outcome.
#include <cmath>
#include <gtest/gtest.h>

#include "avo/error.h"
#include "avo/space/check.h"

namespace avo::space::tests {
namespace {

CheckReport judged(const std::vector<CheckedRobot>& robots, const std::vector<Box>& boxes,
                   const std::vector<std::vector<CheckedState>>& rows) {
  Check check(robots, boxes);
  double time = 0.0;
  for (const auto& at : rows) check.add(time, at), time += 1.0;
  return check.report();
}

TEST(SpaceJudge, finds_a_passage_between_two_rows) {
  // A passes B by 0.9 m in the middle of the step
  const CheckReport report = judged(
      {{}, {}}, {},
      {{{0, {-1, 0, 0.9}, {2, 0, 0}}, {1, {}, {}}}, {{0, {1, 0, 0.9}, {2, 0, 0}}, {1, {}, {}}}});
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_NEAR(report.overlaps.worst, 0.1, 1e-11);
  EXPECT_NEAR(*report.least_clearance, -0.1, 1e-11);
}

TEST(SpaceJudge, downwash_reaches_below_and_not_above) {
  const auto passes_at = [](double height) {
    return judged({{.downwash = 2.0}, {}}, {},
                  {{{0, {}, {}}, {1, {-3, 0, height}, {1, 0, 0}}},
                   {{0, {}, {}}, {1, {3, 0, height}, {1, 0, 0}}}})
        .overlaps.count;
  };
  EXPECT_EQ(passes_at(-2.9), 1);
  EXPECT_EQ(passes_at(-3.1), 0);
  EXPECT_EQ(passes_at(0.9), 1);
  EXPECT_EQ(passes_at(1.1), 0);
}

TEST(SpaceJudge, judges_limits_along_each_axis) {
  const auto accelerates = [](Vec3 change) {
    return judged({{.max_acceleration = 1.0, .max_speed = 9.0, .vertical = 0.5}}, {},
                  {{{0, {}, {}}}, {{0, 0.5 * change, change}}})
        .accelerations.count;
  };
  EXPECT_EQ(accelerates({1, 0, 0}), 0);
  EXPECT_EQ(accelerates({1.01, 0, 0}), 1);
  EXPECT_EQ(accelerates({0, 0, 0.5}), 0);
  EXPECT_EQ(accelerates({0, 0, 0.51}), 1);
  EXPECT_EQ(accelerates({0.8, 0, 0.4}), 1);
  const CheckReport climbs =
      judged({{.max_speed = 9.0, .climb = 1.0}}, {}, {{{0, {}, {0, 0, 1.1}}}});
  EXPECT_EQ(climbs.speeds.count, 1);
}

TEST(SpaceJudge, finds_boxes_that_are_touched_within_a_step) {
  const Box wall{{0.2, -Box::kFar, -Box::kFar}, {0.4, Box::kFar, Box::kFar}, 0.0, 0.0};
  const CheckReport report =
      judged({{}}, {wall}, {{{0, {-1.2, 0, 0}, {4, 0, 0}}}, {{0, {-1.2, 0, 0}, {-4, 0, 0}}}});
  EXPECT_EQ(report.static_contacts.count, 1);
  EXPECT_EQ(report.static_contacts.first->other, 0);
}

TEST(SpaceJudge, counts_no_arrival_behind_a_box) {
  const auto arrived = [](double heading, Vec3 goal) {
    const Box plate{{0.2, -3, -3}, {0.4, 3, 3}, heading, 0.0};
    CheckedRobot robot;
    robot.radius = 0.1;
    robot.goal = goal;
    return judged({robot}, {plate}, {{{0, {}, {}}}}).arrived;
  };
  EXPECT_EQ(arrived(0.0, {0.45, 0, 0}), 0);
  EXPECT_EQ(arrived(0.0, {-0.45, 0, 0}), 1);
  EXPECT_EQ(arrived(3.141592653589793, {-0.45, 0, 0}), 0);
  EXPECT_EQ(arrived(0.0, {0.3, 0, 0}), 1) << "a goal in a box is out of reach, and near is enough";
}

TEST(SpaceJudge, counts_every_overlap_beside_a_deeper_one) {
  const std::vector<CheckedState> rows{
      {0, {0, 0, 0}, {}}, {1, {0.1, 0, 0}, {}}, {2, {9, 0, 0}, {}}, {3, {9.9, 0, 0}, {}}};
  EXPECT_EQ(judged({{}, {}, {}, {}}, {}, {rows, rows}).overlaps.count, 2);
}

TEST(SpaceJudge, grants_braking_to_robots_that_slow_down_alone) {
  const auto changes = [](Vec3 from, Vec3 to) {
    return judged({{.max_speed = 20.0, .max_braking = 5.0}}, {},
                  {{{0, {}, from}}, {{0, 0.5 * (from + to), to}}})
        .accelerations.count;
  };
  EXPECT_EQ(changes({6, 0, 0}, {1.5, 0, 0}), 0);
  EXPECT_EQ(changes({}, {5, 0, 0}), 1);
  EXPECT_EQ(changes({1, 0, 0}, {6, 0, 0}), 1);
  EXPECT_EQ(changes({1, 0, 0}, {-4, 0, 0}), 1);
}

TEST(SpaceJudge, refuses_what_it_cannot_judge) {
  EXPECT_THROW(Check(std::vector<CheckedRobot>{{.downwash = -1}}), Error);
  EXPECT_THROW(Check(std::vector<CheckedRobot>{{.climb = -1}}), Error);
  EXPECT_THROW(Check(std::vector<CheckedRobot>{{.goal = Vec3{std::nan(""), 0, 0}}}), Error);
  EXPECT_THROW(Check({{}}, {{{1, 0, 0}, {0, 1, 1}, 0.0, 0.0}}), Error);
  EXPECT_THROW(Check({{}}, {}, {.relative_tolerance = -1}), Error);
}

TEST(SpaceJudge, comes_to_an_end_far_from_the_origin) {
  const double far = 3e11;
  const CheckReport report =
      judged({{}, {}}, {{{far + 0.4, -1, -1}, {far + 2, 1, 1}, 0.0, 0.0}},
             {{{0, {far, 0, 0}, {0.3, 0.1, 0}}, {1, {far, 0.9, 0}, {0.3, 0, 0}}},
              {{0, {far, 0, 0}, {0.3, 0.1, 0}}, {1, {far, 0.9, 0}, {0.3, 0, 0}}}});
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_EQ(report.static_contacts.count, 2);
}

TEST(SpaceJudge, positions_that_do_not_follow_the_velocities_are_jumps) {
  const CheckReport report = judged({{}}, {}, {{{0, {}, {}}}, {{0, {1, 0, 0}, {}}}});
  EXPECT_EQ(report.jumps.count, 1);
}

TEST(SpaceJudge, tells_who_arrived) {
  const CheckReport report = judged(
      {{.goal = Vec3{1, 0, 0}}, {.goal = Vec3{0, 0, 9}}}, {},
      {{{0, {0, 5, 0}, {}}, {1, {5, 0, 0}, {}}}, {{0, {1, 0.2, 0}, {}}, {1, {5, 0, 0}, {}}}});
  EXPECT_EQ(report.with_goal, 2);
  EXPECT_EQ(report.arrived, 1);
  EXPECT_EQ(report.not_arrived, std::vector<std::int64_t>{1});
  EXPECT_FALSE(report.last_arrival.has_value());
}

}  // namespace
}  // namespace avo::space::tests
