// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "avo/robot.h"
#include "certificate/pair.h"
#include "certificate/trajectory_steps.h"

namespace avo::inline certificate {

/// Covers rounding of squares, and the part of the rounding margin that grows with the distance.
inline constexpr double kFarther = 1.0 + 0x1p-27;

/// What a pair has besides the distance that its centers keep: nothing in the plane.
template <int D>
struct PairShape {};

/// In space no robot may be in the vertical capsule of radius r_A + r_B that reaches `up` below A,
/// and `down` below B. So p_A - p_B keeps r_A + r_B from the segment that reaches from -down to up.
template <>
struct PairShape<3> {
  double up = 0.0, down = 0.0;  ///< [w_A, w_B] m, downwash
  double vertical = 1.0;        ///< [e_A] vertical limits of A as a part of its horizontal ones
  Vec3 own_direction = {};      ///< of v_A in A's own space, where its limits are a ball; 0 at rest

  bool has_wash() const { return up > 0.0 || down > 0.0; }
};

/// One pair for which constraints are computed.
template <int D>
struct PairConstraintsOf {
  const BrakingPairOf<D>& pair;
  const Neighbor& other;
  int neighbor;           ///< its index
  std::size_t intervals;  ///< number of intervals that are tested
  double inflated;        ///< m, contact and all known uncertainty
  double held;            ///< m, the distance that is held; `inflated` until it is known
  double moving;          ///< the invariant covers the intervals below this one
  bool is_free = false;   ///< both decide, each at its own times
  const TrajectorySteps* trajectory = nullptr;  ///< of a neighbor with a known future, from p_B
  [[no_unique_address]] PairShape<D> shape = {};
};
using PairConstraints = PairConstraintsOf<2>;

}  // namespace avo::inline certificate
