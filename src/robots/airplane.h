// SPDX-License-Identifier: Apache-2.0
// Airplanes: what model.cpp asks of them. For the flight itself see src/robots/flight.h.
#pragma once
#include <vector>

#include "robots/flight.h"

namespace avo::inline robots {

FlightStep fly(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
               const Plan& plan, double time_step);
FlightStep fly_along(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
                     Vec2 heading, Vec2 acceleration, double time_step);
double usable_acceleration(const Airplane& airplane);

void append_own_half_planes(const Airplane& airplane, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes);
Vec2 steered(const Airplane& airplane, const Robot& robot);
Vec2 within_steering(const Airplane& airplane, const Robot& robot, Vec2 v);

}  // namespace avo::inline robots
