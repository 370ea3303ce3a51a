// SPDX-License-Identifier: Apache-2.0
// What models answer about robots.
#include "robots/model.h"

#include <gtest/gtest.h>
#include <numbers>

#include "robots/flight.h"

namespace avo {
namespace {

constexpr double kWide = 0.2;  // 1/m, a curvature

TEST(Models, are_told_apart_by_what_they_can_do) {
  const MotionModel models[] = {Holonomic{}, Car{}, DifferentialDrive{}, Airplane{}};
  const bool rest[] = {true, true, true, false}, heading[] = {false, true, false, true};
  for (std::size_t k = 0; k < std::size(models); ++k) {
    EXPECT_EQ(can_rest(models[k]), rest[k]) << k;
    EXPECT_EQ(moves_along_heading(models[k]), heading[k]) << k;
    EXPECT_EQ(is_holonomic(models[k]), k == 0) << k;
    EXPECT_EQ(circle_of(models[k], {}, {1.0, 0.0}).has_value(), !rest[k]) << k;
    EXPECT_EQ(room_to_turn(models[k], 2.0) > 0.0, !rest[k]) << k;
    EXPECT_EQ(model_traits(models[k]).has_limits_within_steps, k == 2) << k;
  }
}

TEST(Models, of_cars_answer_by_their_parameters) {
  const ModelTraits turning = model_traits(Car{});
  EXPECT_TRUE(turning.turns_in_place);
  EXPECT_FALSE(turning.has_own_half_planes || turning.can_reverse || may_exceed_reach(turning));
  EXPECT_EQ(turning.maneuver_room, 0.0);
  EXPECT_EQ(turning.speed_ratio, 1.0);

  const ModelTraits wide = model_traits(Car{.max_curvature = kWide, .reverse = true});
  EXPECT_FALSE(wide.turns_in_place || may_exceed_reach(wide));
  EXPECT_TRUE(wide.has_own_half_planes && wide.can_reverse);
  EXPECT_GT(wide.maneuver_room, 1.0 / kWide);

  const ModelTraits long_one = model_traits(Car{.max_curvature = kWide, .body = CarBody{-1.5}});
  EXPECT_TRUE(long_one.swings && may_exceed_reach(long_one));
  EXPECT_EQ(long_one.speed_ratio, 1.0 + 1.5 * kWide);
  EXPECT_EQ(long_one.reach, 1.0);

  const ModelTraits exact = model_traits(Car{.acceleration_set = AccelerationSet::exact});
  EXPECT_EQ(exact.reach, std::numbers::sqrt2);
  EXPECT_TRUE(exact.has_own_half_planes && may_exceed_reach(exact));
  EXPECT_FALSE(exact.swings);
}

TEST(Models, that_fly_have_a_least_speed_and_may_leave) {
  const Airplane stays{.min_speed = 3.0, .lateral_acceleration = 2.0};
  const Airplane leaves{.after_goal = AfterGoal::leave};
  EXPECT_EQ(model_traits(stays).least_speed, 3.0);
  EXPECT_FALSE(model_traits(stays).leaves_at_goal);
  EXPECT_TRUE(model_traits(leaves).leaves_at_goal);
  EXPECT_EQ(model_traits(Holonomic{}).least_speed, 0.0);
  // 3 rad in a step at most: 2 m/s² at 3 m/s for 4.5 s
  EXPECT_TRUE(turns_slowly(stays, 4.5));
  EXPECT_FALSE(turns_slowly(stays, 4.6));
}

}  // namespace
}  // namespace avo
