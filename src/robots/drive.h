// SPDX-License-Identifier: Apache-2.0
// Differential drives (docs/certificate/wheels.md, "Differential drives").
#pragma once
#include <optional>
#include <span>

#include "robots/model.h"

namespace avo::inline robots {

/// One step: the point q moves as decided, and the wheels follow.
MotionStep advance_drive(const DifferentialDrive& drive, const MotionState& state, const Plan& plan,
                         double time_step);

/// The same for several robots; at most kMostModelSteps.
void advance_drives(std::span<ModelStep* const> steps, double time_step);

/// See within() in robots/model.h.
MotionState within_step(const DifferentialDrive& drive, const MotionState& from,
                        const MotionState& to, double time, double duration);

/// src/robots/drive_heading.cpp; heading: unit. See robots/model.h.
BrakingPose turn_while_braking(const DifferentialDrive& drive, Vec2 velocity, Vec2 heading,
                               double length);
BrakingPose turn_within(const DifferentialDrive& drive, const MotionState& from,
                        const MotionState& to, double time_step);

/// Returns whether the wheels keep their limits while q accelerates evenly to that velocity, at
/// every instant of the step. They must also keep them if it then brakes straight at up to
/// most_braking.
bool follows(const DifferentialDrive& drive, double most_braking, const MotionState& state,
             Vec2 next_velocity, double time_step);

/// m/s: the largest speed of q in a direction for which straight braking keeps the limits: the set
/// S. `along` and `across` are the direction's components along the heading and across it.
double most_speed(const DifferentialDrive& drive, double most_braking, double along, double across);

/// See robots/model.h.
Vec2 within_own_limits(const DifferentialDrive& drive, const Robot& robot, double time, Vec2 v);
Vec2 steered(const DifferentialDrive& drive, const Robot& robot, const Approach& approach);
Vec2 within_steering(const DifferentialDrive& drive, const Robot& robot, Vec2 v);
/// src/robots/drive_maneuver.cpp
std::optional<Vec2> maneuver(const DifferentialDrive& drive, const Robot& robot,
                             const Approach& approach, const ClearPlaces& is_clear);
double room_for_maneuvers(const DifferentialDrive& drive);

}  // namespace avo::inline robots
