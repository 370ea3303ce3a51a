// SPDX-License-Identifier: Apache-2.0
// Method orca_clamped: ORCA chooses a velocity as if it could be adopted at once, and a robot with
// limits gets as far as a_max Δt leads towards it.
#pragma once
#include <span>

#include "planner/decision.h"
#include "planner/methods/passive_obstacles.h"

namespace avo::inline planner {

/// The plan of ORCA, its v' brought within a_max Δt of v: the velocity at the end of a step of held
/// acceleration. Its violation is then the most by which that leaves a neighbor's half-plane.
Plan clamped(const Planner& planner, const Robot& robot, const Plan& plan,
             std::span<const HalfPlane> half_planes);

/// The same of a choice among obstacles, whose limits are given.
PassiveChoice clamped(const PassiveChoice& choice, const Robot& robot, double time_step,
                      std::span<const Limit> limits);

}  // namespace avo::inline planner
