// SPDX-License-Identifier: Apache-2.0
// The rules for arriving in space (docs/arrival.md, docs/space.md): those of the plane, turned
// about an axis across the course. Safety never depends on them.
#pragma once
#include "avo/space/planner.h"
#include "planner/rules/arrival.h"
#include "space/bodies.h"
#include "space/look.h"
#include "space/tempo.h"
#include "space/turn_axis.h"

namespace avo::space {

/// A robot's view of its neighbors, see avo::Traffic.
struct Traffic {
  double ahead = 0.0;
  bool is_beside = false;
  Vec3 push, push_at_rest;
};
/// The traffic of the bodies that a look has found.
Traffic traffic_of(const Robot& robot, const Bodies& bodies, const Looked& looked);

/// a turned by an angle in [0, π) rad, clockwise as seen from the tip of a unit axis.
Vec3 turned_right(Vec3 a, Vec3 axis, double angle);

/// [m/s] The velocity that the robot wishes: its preferred velocity, to the right in traffic, aside
/// for others. Updates the detour.
template <typename Trace>
Vec3 wish_of(const Viewer& look, const Bodies& bodies, std::span<const Box> boxes,
             const Looked& looked, const PlannerOptions& options, const Tempo& tempo,
             Detour& detour, Trace trace);

}  // namespace avo::space
