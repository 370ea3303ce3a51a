// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "avo/robot.h"
#include "certificate/pair.h"
#include "certificate/trajectory_steps.h"

namespace avo::inline certificate {

/// Covers rounding of squares, and of the margin for it what grows with the distance.
inline constexpr double kFarther = 1.0 + 0x1p-27;

/// One pair whose constraints are wanted.
struct PairConstraints {
  const BrakingPair& pair;
  const Neighbor& other;
  int neighbor;           ///< its index
  std::size_t intervals;  ///< that are looked at
  double inflated;        ///< m, contact and all that is known to be uncertain
  double held;            ///< m, the distance that is held; until it is known, inflated
  double moving;          ///< the invariant speaks of the intervals below
  bool is_free = false;   ///< both decide, at times of their own
  const TrajectorySteps* trajectory = nullptr;  ///< of one whose future is known, from p_B
};

}  // namespace avo::inline certificate
