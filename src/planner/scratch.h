// SPDX-License-Identifier: Apache-2.0
// The memory of a planner's decisions.
#pragma once
#include <vector>

#include "avo/planner.h"
#include "core/neighbor_columns.h"
#include "lp/linear_program.h"
#include "lp/programs.h"
#include "planner/certified.h"
#include "planner/passive_obstacles.h"
#include "planner/together.h"

namespace avo {

/// What the planner's robots have agreed on.
CertificateLaw certificate_law(const Planner& planner);

/// The velocity after a step of at most `decrement` from v towards a target, m/s.
Vec2 approach(Vec2 velocity, Vec2 target, double decrement);

struct PlanWorkspace::Scratch {
  std::vector<Deciding> deciding;  // of which these are stages
  std::vector<Sensing> sensing;
  SoftPlanes soft;
  std::vector<Vec2> wishes;
  std::vector<ProgramResult> results;
  ProgramBatch<double> in_double;
  ProgramBatch<float> in_single;
  std::vector<HalfPlane> projected;
  std::vector<PassiveObstacle> obstacles;
  NeighborColumns seen;
  std::vector<Neighbor> movers;
  PassiveWorkspace passive;
  CertifiedWorkspace certified;

  /// Room for the certificate of so many neighbors, each of which brakes for so many steps.
  void reserve_choice(std::size_t neighbors, std::size_t braking_steps);
};

}  // namespace avo
