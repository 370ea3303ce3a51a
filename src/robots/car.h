// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V).
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "robots/model.h"

namespace avo::inline robots {

MotionStep advance_car(const Car& car, const MotionLimits& limits, const MotionState& state,
                       const Plan& plan, double time_step);
/// The same for several robots that are all cars, with their results.
void advance_cars(std::span<ModelStep* const> steps, double time_step);
/// See advance_discs() in robots/model.h.
void advance_discs(const Car& car, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step, std::span<MotionStep> discs);
/// src/robots/within.cpp
MotionState within_arc(const Car& car, const MotionState& from, const MotionState& to, double time,
                       double duration);
Stray stray_of_car(const Car& car, double max_acceleration, double time_step);
SensingError unforeseen_of_car(const Car& car, double max_acceleration, double time_step);
double top_speed_of(const Car& car, const Robot& robot, double u);
Vec2 within_own_limits(const Car& car, const Robot& robot, double time, Vec2 v);
Vec2 approached(const Car& car, const Robot& robot, double time, double increment, Vec2 w);
Vec2 turning_first(const Car& car, const Robot& robot, Vec2 v);
void append_own_half_planes(const Car& car, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes);

/// src/robots/steering.cpp
Vec2 steered(const Car& car, const Robot& robot, const Approach& approach);
/// m/s: along `ahead`, its heading or the opposite direction, towards its target.
Vec2 steered_along(const Car& car, const Robot& robot, Vec2 ahead);
Vec2 within_steering(const Car& car, const Robot& robot, Vec2 v);

/// src/robots/maneuver.cpp
std::optional<Vec2> maneuver(const Car& car, const Robot& robot, const Approach& approach,
                             bool is_beside, const ClearPlaces& is_clear, ManeuverMemory& memory);
double room_for_maneuvers(const Car& car);

inline double offset_of(const Car& car) {
  return car.body ? car.body->offset : 0.0;
}

/// Returns whether it can turn without driving.
inline bool turns_in_place(const Car& car) {
  return !car.max_curvature;
}
/// [1, √2]: see ModelTraits.
inline double reach_of(const Car& car) {
  return car.acceleration_set == AccelerationSet::exact ? std::numbers::sqrt2 : 1.0;
}
inline bool has_own_half_planes(const Car& car) {
  return !turns_in_place(car) || reach_of(car) > 1.0;
}
/// 1/m, while it drives. Others expect a disc to move about as far as two steps at its axle's speed
/// (keeps_reach() in src/certificate). So a disc ahead of the axle may sweep aside as fast as the
/// car drives, and no car could stay on a sharper curve. Where the curvature has no bound, the
/// sweep adds a quarter to its speed at most. Discs of a footprint have no such limit, because
/// others expect them anywhere within the disc that covers them. Where the curvature has no bound,
/// they sweep aside as fast as the car drives at most.
inline double sharpest(const Car& car) {
  if (car.footprint && !car.max_curvature) return 1.0 / farthest_center(car.footprint);
  const double offset = std::abs(offset_of(car));
  if (offset == 0.0) return car.max_curvature.value_or(std::numeric_limits<double>::infinity());
  return car.max_curvature ? std::min(*car.max_curvature, 1.0 / offset) : 0.25 / offset;
}
/// Near v = 0 Eq. (25) asks for unbounded curvature. Below the speed that one step of braking takes
/// off, a car that would have to turn by more than this first stops. It then turns in place about
/// its rear axle (front wheels across), which does not move the axle.
inline constexpr double kTurnInPlace = 0.25;  // rad
/// Returns whether it is so near its goal that it does not turn round for the rest.
inline bool is_there(const Car& car, const Robot& robot, const Approach& approach) {
  constexpr double kNearEnough = 0.05;  // times the radius of the circle that it turns on
  constexpr double kPrecise = 0.01;     // times its own radius: it does not turn round for less
  const double circle = turns_in_place(car) ? std::abs(offset_of(car)) : 1.0 / sharpest(car);
  const double near = std::max(kNearEnough * circle, kPrecise * robot.radius);
  return robot.distance_to_goal <= std::min(near, approach.near_enough);
}
}  // namespace avo::inline robots
