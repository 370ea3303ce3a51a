// SPDX-License-Identifier: Apache-2.0
// The memory of a planner's decisions.
#pragma once
#include <vector>

#include "avo/planner.h"
#include "planner/certified.h"
#include "planner/passive_obstacles.h"

namespace avo {

/// What the planner's robots have agreed on.
CertificateLaw certificate_law(const Planner& planner);

/// The velocity after a step of at most `decrement` from v towards a target, m/s.
Vec2 approach(Vec2 velocity, Vec2 target, double decrement);

struct PlanWorkspace::Scratch {
  std::vector<HalfPlane> half_planes;
  std::vector<HalfPlane> projected;
  std::vector<PassiveObstacle> obstacles;
  std::vector<Neighbor> movers;
  PassiveWorkspace passive;
  CertifiedWorkspace certified;
};

}  // namespace avo
