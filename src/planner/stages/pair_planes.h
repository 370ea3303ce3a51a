// SPDX-License-Identifier: Apache-2.0
// From one pair of robots to A's half-plane against B.
#pragma once
#include <optional>

#include "avo/half_plane.h"
#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/robot.h"
#include "obstacles/half_planes.h"

namespace avo::inline planner {

/// The pair in the form of Eqs. (2), (3): p_AB, v_AB, r_AB.
Pair relative(const Robot& robot, const Neighbor& neighbor);

Reserve reserve_of(const PlannerOptions& options);

/// A's half-plane against one neighbor alone. It is none where nothing within reach collides, or no
/// direction is defined. Sets `overlapping` where the two are in contact already.
std::optional<NeighborPlane> own_half_plane(const PlannerOptions& options, const Horizon& horizon,
                                            const Robot& robot, const Neighbor& neighbor, int index,
                                            bool& overlapping);

// Its parts, which soft_planes.cpp applies to many pairs at a time.

/// Returns whether it coincides with A, and has a parting direction.
bool parts(const Neighbor& neighbor);
bool has_noise(const SensingNoise& noise);

/// The radius of contact with the part of a margin, m, that the gap leaves (docs/scenes.md,
/// "Margin").
double with_margin(const Pair& pair, double margin);

/// The half-plane of robots that coincide, in place of half_plane().
RelativeHalfPlane parting_plane(const PlannerOptions& options, const Horizon& horizon,
                                double radius, Vec2 direction, double reach);

/// A's share of H = {w | n . w >= h}, Eq. (20): of the change that H asks for, h > 0, or of the
/// change that it leaves.
double share_of_plane(double h, double a_A, double a_B, double priority_A, double priority_B);

/// m/s, the increase of the offset by a mover's own acceleration: w = v'_A - v_A - δ a_B (§III-B:
/// v'_B = v_B + δ a_B).
double mover_offset(const PlannerOptions& options, const Neighbor& neighbor, Vec2 normal);

}  // namespace avo::inline planner
