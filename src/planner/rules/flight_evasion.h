// SPDX-License-Identifier: Apache-2.0
// Beside movers, a robot that flies keeps an evasive maneuver: certificate/flight_evasions.h. A
// choice is an acceleration, m/s², that the robot holds through the step.
#pragma once
#include "planner/rules/evading.h"

namespace avo::inline planner {

/// Returns whether the circle after that step is clear of movers, for any walls.
bool may_circle_after_choice(Evading& evading, Vec2 acceleration);

/// Finds the choice nearest to the wanted choice that the certificate admits and that leaves an
/// evasive maneuver, (M).
EvasionFound find_flight(Evading& evading, Vec2 wanted, Taken& found);

/// Returns whether some evasive maneuver is clear, (M).
bool has_clear_flight(Evading& evading);

}  // namespace avo::inline planner
