// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers of a robot A that flies: it holds a control for some steps, and then it circles
// for ever (docs/movers.md, "Airplanes"). Places are relative to p_A, and times count from the
// decision.
#pragma once
#include "certificate/evasions.h"
#include "robots/flight.h"

namespace avo::inline certificate {

/// What the robot holds until it circles.
struct FlightControl {
  double speed = 0.0;  ///< m/s, which it approaches as fast as it can
  double turn = 0.0;   ///< [-1, 1] part of its lateral acceleration; > 0: to the left
};

/// Returns whether the first step keeps clear, (C1) and (C3). The functions below test the flight
/// after it. `step` begins at 0; options.wheels is the robot.
bool take_first_flight(const EvasionOptions& options, Surroundings& around, const MotionState& now,
                       const FlightStep& step);
/// The functions below then test the flight from now on.
void take_no_flight(Surroundings& around, Vec2 velocity);
/// Returns whether A keeps clear, (C1) and (C3), if it circles at once.
bool may_circle(const EvasionOptions& options, Surroundings& around);
/// Returns whether A keeps clear, (C1) and (C3), if A holds the control for some steps and then
/// circles. around.last is then the state in which it begins to circle.
bool may_circle_after(const EvasionOptions& options, Surroundings& around,
                      const FlightControl& control);

}  // namespace avo::inline certificate
