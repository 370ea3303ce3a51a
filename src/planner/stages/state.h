// SPDX-License-Identifier: Apache-2.0
// The proved properties of the state in which a robot decides: docs/states.md.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "certificate/certificate.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// Returns whether braking is proved to keep clear of all bodies in the constraints.
inline bool braking_keeps_clear(const CertificateConstraints& constraints) {
  const Invariant& invariant = constraints.invariant;
  return !invariant.doubtful && !invariant.touched && !invariant.unknown &&
         !constraints.walls.doubtful;
}

/// Returns whether braking touches a neighbor or a wall, as sensed.
inline bool collides(const CertificateConstraints& constraints) {
  return constraints.invariant.broken.any() || constraints.walls.broken.any();
}

/// The constraints must be those of the robot under the law, of its neighbors and walls.
SafetyReport state_of(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                      const CertificateLaw& law, const CertificateConstraints& constraints);

}  // namespace avo::inline planner
