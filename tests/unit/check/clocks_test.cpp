// SPDX-License-Identifier: Apache-2.0
// Whether robots with clocks of their own hold their accelerations between their decisions.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::Moment;
using test::report_of;

struct Change {
  double time;  // s, from when on it accelerates so
  Vec2 acceleration;
};

// A robot from rest that changes its acceleration at these times, with rows at all times given.
std::vector<Moment> driven(const std::vector<Change>& changes, const std::vector<double>& times) {
  std::vector<Moment> recording;
  for (const double time : times) {
    Vec2 p, v;
    for (std::size_t k = 0; k < changes.size() && changes[k].time < time; ++k) {
      const double end = k + 1 < changes.size() ? std::min(changes[k + 1].time, time) : time;
      const double t = end - changes[k].time;
      p = p + t * v + (0.5 * t * t) * changes[k].acceleration;
      v = v + t * changes[k].acceleration;
    }
    recording.push_back({time, {{0, p, v}}});
  }
  return recording;
}

CheckedRobot with_step(double time_step) {
  CheckedRobot robot;
  robot.time_step = time_step;
  return robot;
}

const std::vector<double> kTimes{0.0, 0.03, 0.05, 0.09, 0.13, 0.15, 0.2, 0.23, 0.25, 0.33};
const std::vector<Change> kOwn{{0.03, {1, 0}}, {0.13, {-0.5, 0.5}}, {0.23, {0, -1}}};

TEST(CheckClocks, changes_a_time_step_apart_are_its_own_whatever_the_phase) {
  const CheckReport report = report_of({with_step(0.1)}, driven(kOwn, kTimes));
  EXPECT_EQ(report.changes.count, 0);
  EXPECT_TRUE(report.safe());
  EXPECT_EQ(report_of({with_step(0.05)}, driven(kOwn, kTimes)).changes.count, 0);
}

TEST(CheckClocks, a_change_at_any_other_time_counts) {
  std::vector<Change> changes = kOwn;
  changes.insert(changes.begin() + 2, {0.15, {-0.5, 0.499}});
  const CheckReport report = report_of({with_step(0.1)}, driven(changes, kTimes));
  EXPECT_EQ(report.changes.count, 1);
  EXPECT_NEAR(report.changes.first->time, 0.15, 1e-15);
  EXPECT_NEAR(report.changes.first->amount, 0.001, 1e-9);
  EXPECT_FALSE(report.safe());
  EXPECT_TRUE(report_of({{}}, driven(changes, kTimes)).safe()) << "nobody has said how it decides";
  EXPECT_GT(report_of({with_step(0.07)}, driven(kOwn, kTimes)).changes.count, 0);
}

// Two decisions a nanosecond apart, of which one is its own.
TEST(CheckClocks, instants_a_nanosecond_apart_are_told_apart) {
  const std::vector<double> times{0.0, 0.03, 0.08, 0.13, 0.130000001, 0.18, 0.23, 0.28};
  EXPECT_EQ(report_of({with_step(0.1)}, driven(kOwn, times)).changes.count, 0);
  std::vector<Change> late = kOwn;
  late[1].time = 0.130000001;
  EXPECT_EQ(report_of({with_step(0.1)}, driven(late, times)).changes.count, 1);
}

TEST(CheckClocks, late_times_and_far_places_are_no_changes) {
  std::vector<Moment> recording = driven(kOwn, kTimes);
  for (Moment& moment : recording) {
    moment.time += 1e5;
    moment.rows[0].position = moment.rows[0].position + Vec2{1e6, -1e6};
  }
  EXPECT_EQ(report_of({with_step(0.1)}, recording).changes.count, 0);
}

TEST(CheckClocks, a_gap_in_the_rows_is_not_judged) {
  std::vector<Change> changes = kOwn;
  changes.insert(changes.begin() + 2, {0.15, {1, 0}});
  std::vector<Moment> recording = driven(changes, kTimes);
  recording[4].rows.clear();
  EXPECT_EQ(report_of({with_step(0.1)}, recording).changes.count, 0);
}

// A car with curvature 0.5 /m that speeds up by 1 m/s²: its acceleration turns all the time.
std::vector<Moment> arc(const std::vector<double>& times, double later_curvature) {
  std::vector<Moment> recording;
  for (const double t : times) {
    const double speed = 1.0 + t, s = t + 0.5 * t * t, s_1 = 0.13 + 0.5 * 0.13 * 0.13;
    const double angle = s <= s_1 ? 0.5 * s : 0.5 * s_1 + later_curvature * (s - s_1);
    recording.push_back({t, {{0, {s, 0.0}, {speed * std::cos(angle), speed * std::sin(angle)}}}});
  }
  return recording;
}

TEST(CheckClocks, a_car_holds_its_curvature_and_its_change_of_speed) {
  CheckedRobot car = with_step(0.2);
  car.kinematics = CheckedCar{};
  car.max_acceleration = 4.0;
  const std::vector<double> times{0.0, 0.03, 0.05, 0.09, 0.13, 0.15, 0.2, 0.23, 0.25, 0.33};
  EXPECT_EQ(report_of({car}, arc(times, 0.5)).changes.count, 0);
  const CheckReport turned = report_of({car}, arc(times, 0.6));
  EXPECT_EQ(turned.changes.count, 0) << "the first change tells its phase";
  car.kinematics = CheckedHolonomic{};
  EXPECT_GT(report_of({car}, arc(times, 0.5)).changes.count, 0) << "no robot but a car";
  CheckedRobot other = with_step(0.02);
  other.kinematics = CheckedCar{};
  other.max_acceleration = 4.0;
  std::vector<Moment> twice = arc(times, 0.6);
  for (std::size_t k = 6; k < twice.size(); ++k)  // and again at 0.2 s, 0.07 s later
    twice[k].rows[0].velocity = (1.0 + 0.5 * (times[k] - 0.2)) * twice[k].rows[0].velocity;
  EXPECT_GT(report_of({other}, twice).changes.count, 0);
}

TEST(CheckClocks, a_time_step_has_to_be_one) {
  EXPECT_EQ(test::refusal([] { report_of({with_step(0.0)}, {}); }),
            "robots.0.time_step: found 0, must be > 0 s");
}

}  // namespace
}  // namespace avo
