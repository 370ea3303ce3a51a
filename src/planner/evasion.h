// SPDX-License-Identifier: Apache-2.0
// Beside movers, a robot keeps a way out: docs/movers.md.
#pragma once
#include <span>
#include <vector>

#include "certificate/ways.h"
#include "planner/certified.h"
#include "planner/decision.h"

namespace avo {

/// Scratch memory; allocates only while it grows.
struct EvasionWorkspace {
  Surroundings around;
  std::vector<Neighbor> deciding;      // of the neighbors
  CertifiedWorkspace certified;        // of these and of walls
  // of the last plan that evades: on which way, and the next velocity that it has put aside
  Evasion chosen;
  Vec2 put_aside;  // m/s
};

/// m: as far as the ways of a robot lead, but for the last of its braking.
double way_range(double radius, double max_speed, double max_acceleration);
/// s, from a decision on until it rests: the longest way of a robot that is no faster than its
/// max_speed.
double longest_way_out(const Robot& robot, const StepLaw& law);

/// Replaces a plan of method avo that leaves no way out by the nearest first step of a way, where
/// there is one. Robots that are not holonomic, and those without a certificate, have the plan that
/// they have. All walls within wall_range
/// of the robot's disc are given, or those that the certificate needs. may_swerve: nobody else decides; as a last resort A then need not be able to stop
/// before movers that keep their acceleration.
void keep_a_way_out(const CertificateLaw& law, const Robot& robot,
                    std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                    double wall_range, bool may_swerve, EvasionWorkspace& workspace, Plan& plan);

/// (M), see Planner::has_way_out().
bool has_way_out(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                 std::span<const Wall> walls, EvasionWorkspace& workspace);

/// Whom the robot evades that has put aside a next velocity: index of the nearest one who comes too
/// near to it if it brakes after that step; -1 where there is none.
int find_evaded(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                Vec2 put_aside, EvasionWorkspace& workspace);

}  // namespace avo
