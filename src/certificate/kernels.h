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
#include "certificate/near_pairs.h"
#include "certificate/pair.h"
#include "certificate/wall_columns.h"
#include "core/neighbor_columns.h"
#include "core/scalar.h"

namespace avo {

/// Covers rounding of squares, and of the margin for it what grows with the distance.
inline constexpr double kFarther = 1.0 + 0x1p-27;

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

struct CertificateKernels {
  void (*find_near)(const RobotColumns&, Whom, const StepLaw&, NearPairs&);
  void (*fill_own)(const Braking&, const Deviation&, const StepLaw&, OwnColumns&);
  double (*append_walls)(const PairWalls&, const StepLaw&, const OwnColumns&, WallColumns&);
  bool (*keeps)(const Braking&, const CandidatePath&, const StepLaw&, bool, WallColumns&);
};

/// own.count is known, the columns have room for it.
void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own);

/// See walls_kernel.h; the columns have room for all intervals.
double append_walls(const PairWalls& of, const StepLaw& law, const OwnColumns& own,
                    WallColumns& walls);

/// See admission_kernel.h.
bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           WallColumns& walls);

}  // namespace avo
