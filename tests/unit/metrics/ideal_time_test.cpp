// SPDX-License-Identifier: Apache-2.0
// Times of trapezoidal profiles, by hand: at 1 m/s^2, 2 m/s at the most, to 0.5 m before the goal.
#include "metrics/ideal_time.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace avo {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

IdealTrip trip_of(double distance, double speed = 0.0) {
  return {
      .distance = distance, .margin = 0.5, .speed = speed, .top_speed = 2.0, .acceleration = 1.0};
}

TEST(IdealTime, of_a_trapezoid) {
  // 2 s to 2 m/s, 16 m at it, 1 s of braking to where 0.5 m are left
  EXPECT_NEAR(ideal_time(trip_of(20.0)), 2.0 + 8.0 + 1.0, 1e-12);
  EXPECT_NEAR(ideal_time(trip_of(20.0, 2.0)), 9.0 + 1.0, 1e-12);
  EXPECT_NEAR(ideal_time(trip_of(20.0, 1.0)), 1.0 + (20.0 - 1.5 - 2.0) / 2.0 + 1.0, 1e-12);
}

TEST(IdealTime, of_a_triangle) {
  // braking begins in the middle, at √3 m/s
  EXPECT_NEAR(ideal_time(trip_of(3.0)), std::sqrt(3.0) + (std::sqrt(3.0) - 1.0), 1e-12);
  // from 1 m/s to √3.5 m/s, and back to 1 m/s
  EXPECT_NEAR(ideal_time(trip_of(3.0, 1.0)), 2.0 * (std::sqrt(3.5) - 1.0), 1e-12);
  // it has arrived before braking begins: 0.3 m from rest
  EXPECT_NEAR(ideal_time(trip_of(0.8)), std::sqrt(0.6), 1e-12);
  EXPECT_NEAR(ideal_time(trip_of(1.2)), std::sqrt(1.2) + (std::sqrt(1.2) - 1.0), 1e-12);
}

TEST(IdealTime, from_other_speeds) {
  // away from the goal: 1 s to rest, 0.5 m farther
  EXPECT_NEAR(ideal_time(trip_of(19.5, -1.0)), 1.0 + 11.0, 1e-12);
  // too fast: 1 s and 2.5 m down to 2 m/s
  EXPECT_NEAR(ideal_time(trip_of(20.0, 3.0)), 1.0 + 15.5 / 2.0 + 1.0, 1e-12);
  // too fast to stop at all: 7 t - t²/2 = 19.5
  EXPECT_NEAR(ideal_time(trip_of(20.0, 7.0)), 7.0 - std::sqrt(10.0), 1e-12);
}

TEST(IdealTime, of_what_passes_its_goal) {
  IdealTrip trip = trip_of(20.0);
  trip.stops = false;
  EXPECT_NEAR(ideal_time(trip), 2.0 + 17.5 / 2.0, 1e-12);
  trip.speed = 3.0;
  EXPECT_NEAR(ideal_time(trip), 1.0 + 17.0 / 2.0, 1e-12);
}

TEST(IdealTime, of_no_way_and_of_none_that_ends) {
  EXPECT_EQ(ideal_time(trip_of(0.0)), 0.0);
  EXPECT_EQ(ideal_time(trip_of(0.5, -3.0)), 0.0);
  EXPECT_EQ(ideal_time(trip_of(kInfinite)), kInfinite);
  IdealTrip trip = trip_of(20.0);
  trip.top_speed = 0.0;
  EXPECT_EQ(ideal_time(trip), kInfinite);
}

// Continuous in all that it depends on, where one case goes over into another one.
TEST(IdealTime, has_no_jumps) {
  for (const double distance : {0.6, 1.0, 2.0, 4.0, 20.0}) {
    double before = ideal_time(trip_of(distance, -4.0));
    for (double speed = -4.0; speed < 8.0; speed += 1e-3) {
      const double now = ideal_time(trip_of(distance, speed));
      EXPECT_LE(now, before + 1e-12) << distance << " " << speed;
      EXPECT_GE(now, before - 0.02) << distance << " " << speed;
      before = now;
    }
  }
}

}  // namespace
}  // namespace avo
