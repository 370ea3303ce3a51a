// SPDX-License-Identifier: Apache-2.0
// Beside movers, a robot that brakes keeps an evasive maneuver: docs/movers.md, "Evasive
// maneuvers". A choice is the velocity after the step, m/s.
#pragma once
#include "planner/rules/evading.h"

namespace avo::inline planner {

/// Returns whether braking after that step is clear of movers, (C1) to (C3).
bool may_brake_after_choice(Evading& evading, Vec2 next_velocity);

/// Finds the choice nearest to the wanted choice that the certificate admits and that leaves an
/// evasive maneuver, (M).
EvasionFound find_braking_evasion(Evading& evading, Vec2 wanted, Taken& found);

/// Returns whether some evasive maneuver is clear, (M).
bool has_clear_evasion(Evading& evading);

}  // namespace avo::inline planner
