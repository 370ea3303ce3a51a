// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V).
#pragma once
#include <vector>

#include "robots/model.h"

namespace avo {

MotionStep advance_car(const Car& car, const MotionLimits& limits, const MotionState& state,
                       const Plan& plan, double time_step);
Stray stray_of_car(const Car& car, double max_acceleration, double time_step);
void append_own_half_planes(const Car& car, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes);

/// src/robots/steering.cpp
Vec2 steered(const Car& car, const Robot& robot);
Vec2 within_steering(const Car& car, const Robot& robot, Vec2 v);

/// Not bound to drive on in order to turn.
inline bool turns_in_place(const Car& car) {
  return car.max_curvature == std::numeric_limits<double>::infinity();
}
inline double offset_of(const Car& car) {
  return car.body ? car.body->offset : 0.0;
}

}  // namespace avo
