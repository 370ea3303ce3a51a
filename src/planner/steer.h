// SPDX-License-Identifier: Apache-2.0
// Robots that cannot go everywhere at once go about it in their own way.
#pragma once
#include <array>
#include <vector>

#include "certificate/braking_path.h"
#include "planner/options.h"
#include "planner/tile.h"
#include "robots/maneuver_memory.h"
#include "walls/segment.h"

namespace avo::inline planner {

/// Memory to steer with; reuse it and nothing is allocated once it has grown.
struct SteerMemory {
  /// What is in the way of a maneuver.
  struct Obstacle {
    Segment segment;
    std::array<double, 3> keep;  // m, from the segment, by nearness
  };
  std::vector<Obstacle> obstacles;
  ManeuverMemory maneuvers;
};

/// Makes of each preferred velocity what the robot can steer to, beside walls with maneuvers
/// (docs/arrival.md, rule 11). Only the wish depends on it. tile.maneuvers: who has one.
void steer(const PlannerOptions& options, const StepLaw& law, Tile& tile, SteerMemory& memory);

}  // namespace avo::inline planner
