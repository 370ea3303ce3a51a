// SPDX-License-Identifier: Apache-2.0
// Where robots are within a step, cars on their arcs among them.
#pragma once
#include <vector>

#include "avo/check.h"
#include "avo/simulation.h"

namespace avo::safety {

/// Whatever a robot's motion within the next step depends on.
struct Pose {
  Vec2 position, velocity;
  double heading = 0.0;  ///< rad
};

std::vector<Pose> poses(const FleetView& fleet);

/// The robots after `part` of the step of so many seconds that led from `before` to `now`. Cars
/// hold their curvature and their change of speed, all others their acceleration.
std::vector<CheckedState> states_within(const std::vector<Pose>& before, const FleetView& now,
                                        double time_step, double part);

}  // namespace avo::safety
