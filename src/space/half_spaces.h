// SPDX-License-Identifier: Apache-2.0
// The soft half-spaces of a robot's neighbors, Eqs. (15) to (20) in space.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/space/robot.h"
#include "obstacles/half_planes.h"
#include "space/frame.h"
#include "space/program.h"

namespace avo::space {

/// Scratch memory; allocates only while it grows.
struct HalfSpaces {
  std::vector<HalfSpace> soft;  ///< in v', m/s, in space
  bool overlapping = false;     ///< a neighbor is in contact already
  // pairs in their own planes
  std::vector<std::size_t> index;  ///< of the neighbors with pairs
  std::vector<PairFrame> frames;
  PairColumns pairs;
  PlaneColumns planes;
  HalfPlaneWorkspace workspace;
};

/// Collects the half-spaces that can cut into what the robot may choose. Neighbors beyond
/// max_neighbors, counted from the nearest, have none.
void collect_half_spaces(const Robot& robot, std::span<const Neighbor> neighbors,
                         const PlannerOptions& options, const Horizon& horizon,
                         HalfSpaces& half_spaces);

}  // namespace avo::space
