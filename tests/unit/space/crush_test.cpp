// SPDX-License-Identifier: Apache-2.0
// The certificate in space against robots that want contact: each takes the worst velocity that the
// certificate admits. Judged by space::Check, which shares no formula with it. AVO_CRUSHES sets how
// many times as many crushes are tried (1), and each test then tells what was tried (scripts/soak).
#include "unit/space/crush.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

#include "space/certificate.h"

namespace avo::space::tests {
namespace {

/// What robots of a crush have.
struct Kind {
  double least_radius = 0.5, most_radius = 0.5;  // m
  double least_vertical = 1.0, most_vertical = 1.0;
  double most_downwash = 0.0;  // m
  double most_priority = 1.0;
  bool brakes_differ = false;
  SensingError error = {};
  double lost = 0.0;  // m, by which they err in their own places
  int most_age = 0;   // steps
  int boxes = 0;
  int most_robots = 24;
  double most_speed = 3.0;  // m/s
};

/// Draws robots and boxes of a kind that do not touch.
class Scatter {
 public:
  Scatter(const Kind& kind, std::uint64_t seed) : kind_(kind), draws_(seed) {
    const int count = kind.most_robots / 3 + draws_.below(2 * kind.most_robots / 3 + 1);
    for (int k = 0; k < count; ++k) place();
    draw_boxes();
  }
  Crush crush(double time_step) const {
    PlannerOptions options;
    options.time_step = time_step;
    options.control_time = std::max(2.0, time_step);
    options.time_horizon = std::max(3.0, time_step);
    options.sensing_error = kind_.error;
    options.localization_error = kind_.lost;
    return {robots_, boxes_, options, draws_, kind_.most_age};
  }

 private:
  static double gap(const Robot& a, const Robot& b) {
    Vec3 p = a.position - b.position;
    p.z -= std::clamp(p.z, -b.downwash, a.downwash);
    return norm(p) - a.radius - b.radius;
  }

  void place() {
    Robot robot;
    robot.radius = draws_.between(kind_.least_radius, kind_.most_radius);
    robot.vertical = draws_.between(kind_.least_vertical, kind_.most_vertical);
    robot.downwash = draws_.between(0.0, kind_.most_downwash);
    robot.priority = draws_.between(1.0, kind_.most_priority);
    robot.max_acceleration = draws_.between(0.5, 1.5);
    robot.max_speed = draws_.between(1.0, kind_.most_speed);
    if (kind_.brakes_differ) robot.max_braking = robot.max_acceleration * draws_.between(0.6, 1.6);
    for (double radius = 3.0;; radius *= 1.01) {
      robot.position = draws_.within(radius);
      const double room = 0.01 + 2.0 * kind_.error.position;
      if (std::all_of(robots_.begin(), robots_.end(),
                      [&](const Robot& other) { return gap(robot, other) > room; }))
        break;
    }
    robots_.push_back(robot);
  }

  void draw_boxes() {
    while (static_cast<int>(boxes_.size()) < kind_.boxes) {
      Box box;
      box.heading = draws_.between(-3.0, 3.0);
      const Vec3 center = draws_.within(6.0);
      Vec3 half{draws_.between(0.0, 2.0), draws_.between(0.0, 2.0), draws_.between(0.0, 2.0)};
      if (draws_.below(2) == 0) half.x = 0.0;  // thin ones can be passed over by a step
      box.min = center - half, box.max = center + half;
      if (draws_.below(3) == 0) box.min.z = -Box::kFar;
      if (draws_.below(3) == 0) box.max.x = Box::kFar;
      box.radius = draws_.between(0.0, 0.2);
      const bool is_free = std::all_of(robots_.begin(), robots_.end(), [&](const Robot& robot) {
        return nearest(robot.position, robot.position, box).distance >
               robot.radius + box.radius + 0.01;
      });
      if (is_free) boxes_.push_back(box);
    }
  }

  Kind kind_;
  Draws draws_;
  std::vector<Robot> robots_;
  std::vector<Box> boxes_;
};

int times_as_many() {
  const char* number = std::getenv("AVO_CRUSHES");
  return number != nullptr ? std::max(std::atoi(number), 1) : 1;
}

// Time steps from 0.05 to 1 s.
void expect_no_contact(const Kind& kind, int few, double close = 0.02) {
  const int times = times_as_many(), crushes = few * times;
  std::int64_t robot_steps = 0;
  double clearance = 1e9;
  for (int k = 0; k < crushes; ++k) {
    Crush crush = Scatter(kind, static_cast<std::uint64_t>(100 + k))
                      .crush(0.05 * std::pow(20.0, k / std::max(1.0, crushes - 1.0)));
    for (int step = 0; step < 60; ++step) crush.step();
    const CheckReport report = crush.report();
    ASSERT_EQ(report.overlaps.count, 0) << k << ": " << report.overlaps.worst;
    ASSERT_EQ(report.static_contacts.count, 0) << k << ": " << report.static_contacts.worst;
    ASSERT_EQ(report.accelerations.count, 0) << k << ": " << report.accelerations.worst;
    ASSERT_EQ(report.speeds.count, 0) << k;
    robot_steps += report.robot_steps;
    clearance = std::min(clearance, report.least_clearance.value_or(1e9));
  }
  // they do come close: otherwise nothing has been tried
  EXPECT_LT(clearance, close + 2.0 * kind.error.position) << robot_steps;
  if (times > 1)
    std::printf("crushes: %s | %lld | %.2g m\n",
                ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                static_cast<long long>(robot_steps), clearance);
}

TEST(SpaceCrush, balls_do_not_touch) {
  expect_no_contact({}, 6);
}

TEST(SpaceCrush, mixed_sizes_limits_priorities_and_brakes_do_not_touch) {
  expect_no_contact({.least_radius = 0.05,
                     .most_radius = 0.8,
                     .least_vertical = 0.4,
                     .most_vertical = 2.0,
                     .most_priority = 4.0,
                     .brakes_differ = true},
                    8);
}

TEST(SpaceCrush, nobody_is_in_the_downwash_of_another) {
  expect_no_contact({.least_radius = 0.1, .most_radius = 0.5, .most_downwash = 1.5}, 8);
}

TEST(SpaceCrush, boxes_are_not_touched) {
  expect_no_contact({.least_vertical = 0.5, .most_vertical = 1.5, .boxes = 12}, 6);
}

TEST(SpaceCrush, thin_boxes_are_not_passed_through) {
  expect_no_contact(
      {.least_radius = 0.05, .most_radius = 0.2, .boxes = 20, .most_robots = 9, .most_speed = 8.0},
      8, 0.5);
}

TEST(SpaceCrush, boxes_are_not_touched_by_robots_that_do_not_know_their_places) {
  expect_no_contact({.least_vertical = 0.5, .most_vertical = 1.5, .lost = 0.1, .boxes = 12}, 8);
  expect_no_contact({.least_radius = 0.05,
                     .most_radius = 0.2,
                     .lost = 0.02,
                     .boxes = 20,
                     .most_robots = 9,
                     .most_speed = 8.0},
                    8, 0.5);
}

TEST(SpaceCrush, sensing_errors_cost_no_contact) {
  expect_no_contact({.least_vertical = 0.6, .most_vertical = 1.4, .error = {0.04, 0.08}}, 6);
}

TEST(SpaceCrush, sensing_errors_bring_nobody_into_a_downwash) {
  expect_no_contact({.least_radius = 0.1,
                     .most_radius = 0.5,
                     .most_downwash = 1.5,
                     .error = {0.02, 0.04},
                     .most_age = 1},
                    8, 0.3);
}

TEST(SpaceCrush, neighbors_that_were_sensed_steps_ago_are_not_touched) {
  expect_no_contact({.least_vertical = 0.6,
                     .most_vertical = 1.4,
                     .brakes_differ = true,
                     .error = {0.01, 0.02},
                     .most_age = 3},
                    6, 0.5);
}

}  // namespace
}  // namespace avo::space::tests
