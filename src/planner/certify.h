// SPDX-License-Identifier: Apache-2.0
// Decisions of method avo that a certificate may object to.
#pragma once
#include <cstddef>
#include <span>

#include "planner/certified.h"
#include "planner/decision.h"
#include "planner/execution.h"
#include "planner/methods/passive_obstacles.h"

namespace avo::inline planner {

/// What the planner's robots have agreed on.
CertificateLaw certificate_law(const Planner& planner);

/// The decision that leads to a next velocity, m/s.
Plan plan_under(const CertificateLaw& law, const Robot& robot, Vec2 next_velocity,
                PlanStatus status, double violation);

/// Robot i of those that find_near() was given last, whose walls begin_walls() knows: nearest to
/// what the program made of its wish, or on a detour.
Plan certify(const Planner& planner, const CertificateLaw& law, const RobotColumns& robots,
             std::size_t i, const Haste& haste, const Wished& wished, CertifiedWorkspace& certified,
             Detour& detour);

/// One robot on its way to a target outside the obstacles of movers (§III-C), none of which
/// decides, whatever it could do.
Plan certify_among_movers(const Planner& planner, const Robot& robot,
                          std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                          const PassiveChoice& target, bool overlapping,
                          PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
