// SPDX-License-Identifier: Apache-2.0
// Stopping capsules: each robot keeps the area that it needs to stop on its own side of a line.
// Both robots of a pair derive the line from the capsules in which they would stop now
// (docs/certificate/capsules.md).
#pragma once
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "core/neighbor_columns.h"

namespace avo::inline certificate {

/// The demand of one neighbor: normal . x >= offset for all of A's next capsule, relative to p_A.
struct CapsuleConstraint {
  int neighbor = 0;
  Vec2 normal;          ///< unit, from B's capsule to A's
  double offset = 0.0;  ///< m
  double begin = 0.0;   ///< m, the start of A's present capsule
};

/// Appends the constraints of the neighbors that decide and have capsules that can meet A's.
void collect_capsules(const Robot& robot, const Neighbors& neighbors, const StepLaw& law,
                      std::vector<CapsuleConstraint>& constraints, Invariant& invariant);

/// Returns whether the capsule after the candidate's first step, and with it that step, keeps all
/// constraints.
bool keeps_capsules(std::span<const CapsuleConstraint> constraints, const CandidatePath& path,
                    const StepLaw& law);

/// The constraints as half-planes in v_1, sufficient while |v_1| <= top_speed.
void append_half_planes(std::span<const CapsuleConstraint> constraints, const Robot& robot,
                        const StepLaw& law, double top_speed, std::vector<HalfPlane>& half_planes);

}  // namespace avo::inline certificate
