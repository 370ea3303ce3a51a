// SPDX-License-Identifier: Apache-2.0
// Decisions that a certificate may refuse.
#pragma once
#include <cstddef>
#include <span>

#include "planner/decision.h"
#include "planner/methods/passive_obstacles.h"
#include "planner/stages/certified.h"
#include "planner/stages/execution.h"

namespace avo::inline planner {

/// The constants that the planner's robots share.
CertificateLaw certificate_law(const Planner& planner);

/// The decision that leads to a next velocity, m/s.
Plan plan_under(const CertificateLaw& law, const Robot& robot, Vec2 next_velocity,
                PlanStatus status, double violation);

/// The decision of robot i of the robots that find_near() was last given; begin_walls() has its
/// walls. It is nearest to the program's choice for its wish, or on a detour.
template <typename Trace>
Plan certify(const Planner& planner, const CertificateLaw& law, const RobotColumns& robots,
             std::size_t i, const Haste& haste, const Wished& wished, CertifiedWorkspace& certified,
             Detour& detour, Trace trace);

/// The decision of a robot that moves to a target outside the obstacles of movers (§III-C), if no
/// neighbor decides.
template <typename Trace>
Plan certify_among_movers(const Planner& planner, const Robot& robot,
                          std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                          const PassiveChoice& target, bool overlapping,
                          PlanWorkspace::Scratch& scratch, Trace trace);

}  // namespace avo::inline planner
