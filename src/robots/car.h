// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V).
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "robots/model.h"

namespace avo {

MotionStep advance_car(const Car& car, const MotionLimits& limits, const MotionState& state,
                       const Plan& plan, double time_step);
/// src/robots/within.cpp
MotionState within_arc(const Car& car, const MotionState& from, const MotionState& to, double time,
                       double duration);
Stray stray_of_car(const Car& car, double max_acceleration, double time_step);
SensingError unforeseen_of_car(const Car& car, double max_acceleration, double time_step);
double top_speed_of(const Car& car, const Robot& robot, double u);
Vec2 within_own_limits(const Car& car, const Robot& robot, double time, Vec2 v);
Vec2 turning_first(const Car& car, const Robot& robot, Vec2 v);
void append_own_half_planes(const Car& car, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes);

/// src/robots/steering.cpp
Vec2 steered(const Car& car, const Robot& robot, const Approach& approach);
/// m/s: along `ahead`, its heading or against it, towards where it goes.
Vec2 steered_along(const Car& car, const Robot& robot, Vec2 ahead);
Vec2 within_steering(const Car& car, const Robot& robot, Vec2 v);

/// src/robots/maneuver.cpp
std::optional<Vec2> maneuver(const Car& car, const Robot& robot, const Approach& approach,
                             const ClearPlaces& is_clear);
double room_for_maneuvers(const Car& car);

inline double offset_of(const Car& car) {
  return car.body ? car.body->offset : 0.0;
}

/// Not bound to drive on in order to turn.
inline bool turns_in_place(const Car& car) {
  return !car.max_curvature;
}
/// 1/m, while it drives. A disc ahead of the axle would sweep aside faster than others expect where
/// the curvature has no bound; on such a curve it adds a quarter to its speed at most.
inline double sharpest(const Car& car) {
  if (car.max_curvature) return *car.max_curvature;
  const double offset = offset_of(car);
  return offset == 0.0 ? std::numeric_limits<double>::infinity() : 0.25 / std::abs(offset);
}
/// m, of its axle's smallest circle at constant speed. There others expect a disc to come as far as
/// two steps of that speed lead (keeps_reach() in src/certificate): what is farther off the axle
/// than the turning circle's radius takes a wider one.
inline double turning_radius(const Car& car) {
  return std::max(1.0 / sharpest(car), std::abs(offset_of(car)));
}
/// So near its goal that it does not turn round for what is left.
inline bool is_there(const Car& car, const Robot& robot, const Approach& approach) {
  constexpr double kNearEnough = 0.05;  // times the turning circle's radius
  return robot.distance_to_goal <=
         std::min(kNearEnough * turning_radius(car), approach.near_enough);
}
}  // namespace avo
