// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "avo/robot.h"
#include "certificate/pair.h"
#include "certificate/trajectory_steps.h"

namespace avo::inline certificate {

/// Covers rounding of squares, and the part of the rounding margin that grows with the distance.
inline constexpr double kFarther = 1.0 + 0x1p-27;

/// One pair for which constraints are computed.
struct PairConstraints {
  const BrakingPair& pair;
  const Neighbor& other;
  int neighbor;           ///< its index
  std::size_t intervals;  ///< number of intervals that are judged
  double inflated;        ///< m, contact and all known uncertainty
  double held;            ///< m, the distance that is held; `inflated` until it is known
  double moving;          ///< the invariant covers the intervals below this one
  bool is_free = false;   ///< both decide, each at its own times
  const TrajectorySteps* trajectory = nullptr;  ///< of a neighbor with a known future, from p_B
};

}  // namespace avo::inline certificate
