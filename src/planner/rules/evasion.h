// SPDX-License-Identifier: Apache-2.0
// Beside movers, a robot keeps an evasive maneuver: docs/movers.md.
#pragma once
#include <span>

#include "planner/rules/evading.h"

namespace avo::inline planner {

/// Replaces a plan of method avo that leaves no evasive maneuver by the nearest first step of an
/// evasive maneuver, where there is one. Robots without a certificate keep their plan. may_swerve:
/// no other robot decides. As a last resort A then need not be able to stop before movers that keep
/// their acceleration.
void keep_evasion(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                  bool may_swerve, EvasionWorkspace& workspace, Plan& plan);

/// Returns whether the robot has an evasive maneuver, or needs none, because all others decide.
bool may_go_on(const CertificateLaw& law, const Robot& robot, const Sight& sight,
               EvasionWorkspace& workspace);

/// Tests (M), see Planner::has_evasive_maneuver().
bool has_evasive_maneuver(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                          EvasionWorkspace& workspace);

/// The mover that the robot evades, if it has rejected a next velocity. It is the index of a mover
/// that comes too near to the robot if the robot brakes after that step. The nearest of several
/// counts; -1 if there is none.
int find_evaded(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                Vec2 put_aside, EvasionWorkspace& workspace);

}  // namespace avo::inline planner
