// SPDX-License-Identifier: Apache-2.0
// The half-planes in v' of robots that are planned together, Eqs. (17)-(20).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "certificate/braking_path.h"
#include "obstacles/half_planes.h"
#include "planner/stages/pairs.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Allocates only while it grows.
struct SoftPlanes {
  std::vector<HalfPlane> planes;          ///< of all robots, each in the order of its neighbors
  std::vector<double> excess;             ///< m/s, of each plane, see NeighborPlane
  bool exceeding = false;                 ///< whether an excess is not 0
  std::vector<std::size_t> first{0};      ///< of robot i: [first[i], first[i + 1])
  std::vector<std::uint8_t> overlapping;  ///< whether robot i is in contact already
  /// whether robot i is so deep in contact that it nearly coincides with a neighbor; known where a
  /// certificate asks for it
  std::vector<std::uint8_t> coinciding;

  // scratch memory
  TilePairs pairs;
  HalfPlaneWorkspace workspace;
  PlaneColumns relative;  // of each pair
  SharedPlanes shared;

  [[nodiscard]] std::span<const HalfPlane> of(std::size_t i) const {
    return std::span(planes).subspan(first[i], first[i + 1] - first[i]);
  }
  /// For a robot that is planned alone: the neighbor of half-plane k, in the order of planning.
  [[nodiscard]] std::size_t neighbor_of(std::size_t k) const {
    return static_cast<std::size_t>(shared.kept[k]);
  }
  [[nodiscard]] std::span<const double> excess_of(std::size_t i) const {
    return std::span(excess).subspan(first[i], first[i + 1] - first[i]);
  }
};

void reserve(std::size_t robots, std::size_t pairs, SoftPlanes& soft);

/// Begins anew, with so many robots that have no half-planes.
void clear(std::size_t robots, SoftPlanes& soft);

/// The half-planes that are kept.
enum class Kept : std::uint8_t {
  cutting,  ///< a half-plane that contains one of the two limit discs is left out: it cannot cut
  all,
};

/// Collects the half-planes of all robots of the tile.
void collect_soft_planes(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                         const Tile& tile, SoftPlanes& soft, Kept kept = Kept::cutting);

}  // namespace avo::inline planner
