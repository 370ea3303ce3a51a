// SPDX-License-Identifier: Apache-2.0
// S2, linear soft stop: one linear constraint a neighbor on the acceleration, always feasible by
// a = -v/d_s. For held motion; more cautious head-on than the others (docs/certificate.md).
#pragma once
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "certificate/pair.h"
#include "core/neighbor_columns.h"

namespace avo {

struct SoftStopWall {
  int neighbor = 0;
  HalfPlane half_plane;  ///< in v_A + d_s a_A, m/s
};

/// Where a robot comes to rest by a = -v/d_s, half a step ahead: z = p + (d_s - Δt/2) v.
/// Appends n . (v_A + d_s a_A) >= -β (n . z_AB - r)/Δt of all neighbors, n being the direction of
/// the point of the segment [p_AB, z_AB] nearest to 0. soft_stop_time: [d_s] s, common to all.
void collect_soft_stops(const Robot& robot, const Neighbors& neighbors, double time_step,
                        double soft_stop_time, std::vector<SoftStopWall>& walls,
                        Invariant& invariant);

/// [v_1] of the soft stop.
Vec2 softly_braked(Vec2 velocity, double time_step, double soft_stop_time);

/// [v_A + d_s a_A] of the acceleration that leads to v_1.
Vec2 soft_stop_velocity(Vec2 velocity, Vec2 next_velocity, double time_step, double soft_stop_time);

bool keeps(std::span<const SoftStopWall> walls, Vec2 soft_stop_velocity);

/// The walls as half-planes in v_1.
void append_half_planes(std::span<const SoftStopWall> walls, Vec2 velocity, double time_step,
                        double soft_stop_time, std::vector<HalfPlane>& half_planes);

}  // namespace avo
