// SPDX-License-Identifier: Apache-2.0
// The bodies of footprints as half-planes and contacts see them: the two discs of a pair that are
// nearest to each other (docs/certificate/footprints.md, "Half-planes").
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "avo/planner.h"
#include "avo/robot.h"
#include "certificate/discs.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// The discs of a robot: itself where it has no footprint.
struct Discs {
  std::array<Robot, Footprint::kMostDiscs> discs;
  std::size_t count = 1;

  std::span<const Robot> all() const& { return std::span(discs).first(count); }
  void all() const&& = delete;  // the discs would be gone
};
Discs discs_of(const Robot& robot, const StepLaw& law);

/// Two discs, as the robot and the neighbor that they belong to.
struct DiscPair {
  Robot robot;
  Neighbor neighbor;
  double gap = 0.0;  ///< m, between the discs; < 0 where they overlap
};
/// The pair of discs with the least gap, the first one of those with equal gaps. discs: see
/// discs_of().
DiscPair nearest_discs(const Discs& discs, const Neighbor& neighbor);

/// Returns whether robot i or one of its neighbors has a footprint.
bool has_discs(const RobotColumns& robots, std::size_t i);

}  // namespace avo::inline planner
