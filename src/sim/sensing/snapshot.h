// SPDX-License-Identifier: Apache-2.0
// What all robots of a fleet sense of each other at the beginning of a step.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/columns/fleet.h"
#include "spatial/point_grid.h"

namespace avo::inline sim {

/// The sensed values of one robot, besides its position.
struct Sensed {
  Vec2 velocity;                  // m/s
  double radius = 0.0;            // m
  double max_acceleration = 0.0;  // m/s^2
};

/// Robots by place: in the order of their cells. Hits carry ranks, so that ids settle ties. It does
/// not change while robots are moved: no robot ever sees a half-updated neighbor.
struct Snapshot {
  Cells cells;
  double side = 0.0;  // m, of a cell
  PointGrid grid;
  std::vector<Sensed> sensed;
  std::vector<LoiterCircle> circle;  // with radius 0 for robots that brake; empty where all do
  std::uint64_t crowding = 0;        // see SortedPart
  std::vector<BrakingPose> pose;     // by slot; empty where no robot has a footprint
};

/// Chooses the size of the cells: the width of a search, or half of that in crowds. radius: m, of
/// sensing; near: m, typical of relevant_range(); most: neighbors found farther away.
void lay_out(const Fleet& fleet, double radius, double near, std::size_t most, Snapshot& snapshot);

void prepare(const Fleet& fleet, const StepLaw& law, Snapshot& snapshot);
/// Parts may be taken at the same time, after prepare(). Returns the part's crowding.
std::uint64_t take(const Fleet& fleet, std::size_t part, std::size_t parts, Snapshot& snapshot);

}  // namespace avo::inline sim
