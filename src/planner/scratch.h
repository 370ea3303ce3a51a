// SPDX-License-Identifier: Apache-2.0
// The memory of a planner's decisions.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/planner.h"
#include "certificate/fallback_areas.h"
#include "core/neighbor_columns.h"
#include "lp/linear_program.h"
#include "lp/programs.h"
#include "planner/decision_columns.h"
#include "planner/methods/passive_obstacles.h"
#include "planner/rules/evading.h"
#include "planner/stages/certified.h"
#include "planner/stages/demands.h"
#include "planner/stages/steer.h"
#include "planner/together.h"

namespace avo {

struct PlanWorkspace::Scratch {
  static Scratch& of(PlanWorkspace& workspace) { return *workspace.scratch_; }

  SoftPlanes soft;
  DecisionColumns decisions;
  ProgramBatch programs;
  ProgramRows rows;
  Demands demands;                       // of one robot
  std::vector<HalfPlane> hard_and_soft;  // those of its demands, followed by its other ones
  std::vector<PassiveObstacle> obstacles;
  // the order of the given neighbors, and the neighbors sorted by distance
  std::vector<std::uint32_t> order;
  std::vector<Neighbor> ordered;
  Tile alone;  // of one robot
  std::vector<Neighbor> listed, movers;
  std::vector<int> indices;  // of neighbors, for lists
  PassiveWorkspace passive;
  CertifiedWorkspace certified;
  FlightConstraints flight;
  EvasionWorkspace evasion;
  SteerMemory steering;

  /// Reserves room for the certificate of so many neighbors, each of which brakes for so many
  /// steps.
  void reserve_choice(std::size_t neighbors, std::size_t braking_steps);
  /// Reserves room for so many walls in addition.
  void reserve_walls(std::size_t neighbors, std::size_t most_walls);
  void reserve_planes(std::size_t neighbors, std::size_t most_walls);
};

}  // namespace avo
