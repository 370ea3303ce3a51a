// SPDX-License-Identifier: Apache-2.0
// What cuts off refused proposals, in the plane and in space.
#pragma once
#include <algorithm>
#include <cstddef>

namespace avo::inline planner {

/// A neighbor is cut off by at most so many half-planes.
inline constexpr std::size_t kMostCuts = 6;
/// Each round cuts off the last proposal; more rounds find hardly anything nearer.
inline constexpr auto kRounds = static_cast<int>(kMostCuts);
/// Between the backup and the wanted velocity, after the last round.
inline constexpr int kCutBisections = 5;
/// Half-planes are drawn so far on the safe side, of u: a point of them passes the exact test for
/// any rounding.
inline constexpr double kInside = 0x1p-30;

/// m/s: how far the tangent at a refused velocity is moved in. `speed` is that of the refused
/// velocity, `violation` that of the tangent by it, and u the largest change of velocity; m/s.
///
/// The admitted set has curved boundaries that bend away from their tangents, since the braking
/// distance grows with the square of the speed. The next proposal lies on a tangent, so 97 in 100
/// of them were refused on Circle-1000. A cut is therefore moved in by a part of its violation:
/// then 1 in 100 is refused. Near rest nothing bends, and robots in a jam would back off from each
/// other. So the part grows with the speed.
inline double moved_in(double speed, double violation, double u) {
  constexpr double kDeeper = 0.125;
  constexpr double kStraight = 2.0, kBent = 7.0;  // of u: where the part begins, and where it ends
  const double bent = (speed / u - kStraight) / (kBent - kStraight);
  const double deeper = kDeeper * std::min(1.0, std::max(0.0, bent));
  return kInside * u + deeper * std::max(violation, 0.0);
}

}  // namespace avo::inline planner
