// SPDX-License-Identifier: Apache-2.0
// Method orca_clamped: ORCA chooses a velocity as if it could be adopted at once. A robot with
// limits moves towards it as far as a_max Δt allows.
#pragma once
#include <span>

#include "planner/decision.h"
#include "planner/methods/passive_obstacles.h"

namespace avo::inline planner {

/// The plan of ORCA, with v' brought within a_max Δt of v: the velocity at the end of a step of
/// held acceleration. Its violation is the largest violation of a neighbor's half-plane by this
/// velocity.
Plan clamped(const Planner& planner, const Robot& robot, const Plan& plan,
             std::span<const HalfPlane> half_planes);

/// The same for a choice among obstacles with the given limits.
PassiveChoice clamped(const PassiveChoice& choice, const Robot& robot, double time_step,
                      std::span<const Limit> limits);

}  // namespace avo::inline planner
