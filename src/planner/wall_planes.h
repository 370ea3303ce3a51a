// SPDX-License-Identifier: Apache-2.0
// What walls ask of the target of the first program: no more speed towards one than braking can
// take off before it.
#pragma once
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"

namespace avo {

/// m/s: the largest V with V Δt + l(V) <= gap.
double speed_before(double gap, double max_acceleration, const StepLaw& law);

/// A half-plane n . v' >= -V for each wall that the robot can reach with this decision, n away from
/// it, V by its gap. 0 is in all of them.
void append_speed_planes(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                         std::vector<HalfPlane>& half_planes);

}  // namespace avo
