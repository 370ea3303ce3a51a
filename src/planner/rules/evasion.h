// SPDX-License-Identifier: Apache-2.0
// Beside movers, a robot keeps a way out: docs/movers.md.
#pragma once
#include <span>

#include "planner/rules/evading.h"

namespace avo::inline planner {

/// Replaces a plan of method avo that leaves no way out by the nearest first step of a way, where
/// there is one. Airplanes, and robots without a certificate, have the plan that they have.
/// may_swerve: nobody else decides; as a last resort A then need not be able to stop before movers
/// that keep their acceleration.
void keep_a_way_out(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                    bool may_swerve, EvasionWorkspace& workspace, Plan& plan);

/// (M), see Planner::has_way_out().
bool has_way_out(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                 EvasionWorkspace& workspace);

/// Whom the robot evades that has put aside a next velocity: index of the nearest one who comes too
/// near to it if it brakes after that step; -1 where there is none.
int find_evaded(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                Vec2 put_aside, EvasionWorkspace& workspace);

}  // namespace avo::inline planner
