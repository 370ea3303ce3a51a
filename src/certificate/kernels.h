// SPDX-License-Identifier: Apache-2.0
// What the certificate's kernels share whatever the instruction set, and their scalar instance: the
// reference that all others equal bit for bit.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "certificate/wall_columns.h"
#include "core/neighbor_columns.h"
#include "core/scalar.h"

namespace avo {

/// Covers rounding of squares, and of the margin for it what grows with the distance.
inline constexpr double kFarther = 1.0 + 0x1p-27;

/// Who is no faster than A may be and just as able need not be looked at beyond a distance, the sum
/// of this, its radius and its reach: the most of a fleet, told by little arithmetic.
struct FarBound {
  double distance;              ///< m
  std::array<double, 3> reach;  ///< of one's speed, a polynomial: m, s, s²/m
  double max_acceleration, speed_squared;
};

FarBound far_bound_of(const Robot& robot, const StepLaw& law);

/// Whether any neighbor that decides is not far, and whether any does not decide.
struct Present {
  bool near, movers;
};

/// One pair whose walls are wanted.
struct PairWalls {
  const BrakingPair& pair;
  const Neighbor& other;
  int neighbor;           ///< its index
  std::size_t intervals;  ///< that are looked at
  double inflated;        ///< m, contact and all that is known to be uncertain
  double held;            ///< m, the distance that is held
  double moving;          ///< the invariant speaks of the intervals below
};

namespace scalar {
#include "certificate/certificate_kernels.h"
}  // namespace scalar

/// See pair_kernel.h.
Present look_for(const Robot& robot, const Neighbors& neighbors, const FarBound& bound);
void judge_pairs(const Robot& robot, const Neighbors& neighbors, const FarBound& bound,
                 const Braking& a, const Deviation& deviation, const StepLaw& law,
                 NearColumns& pairs);

/// own.count is known, the columns have room for it.
void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own);

/// See walls_kernel.h; the columns have room for all intervals.
double append_walls(const PairWalls& of, const StepLaw& law, const OwnColumns& own,
                    WallColumns& walls);

/// See admission_kernel.h.
bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           WallColumns& walls);

}  // namespace avo
