// SPDX-License-Identifier: Apache-2.0
// Steering of robots that cannot move in every direction at once.
#pragma once
#include <array>
#include <vector>

#include "certificate/braking_path.h"
#include "planner/options.h"
#include "planner/tile.h"
#include "robots/maneuver_memory.h"
#include "walls/segment.h"

namespace avo::inline planner {

/// Memory for steering; reuse it, and nothing is allocated once it has grown.
struct SteerMemory {
  /// An obstacle to a maneuver.
  struct ManeuverObstacle {
    Segment segment;
    std::array<double, 3> keep;  // m, from the segment, by nearness
  };
  std::vector<ManeuverObstacle> obstacles;
  ManeuverMemory maneuvers;
};

/// Replaces each preferred velocity by a velocity that the robot can steer to, beside walls with
/// maneuvers (docs/arrival.md, rule 14). Only the wish depends on it. tile.maneuvers: set for
/// robots with a maneuver.
void steer(const PlannerOptions& options, const StepLaw& law, Tile& tile, SteerMemory& memory);

}  // namespace avo::inline planner
