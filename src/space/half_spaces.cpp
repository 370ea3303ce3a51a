// SPDX-License-Identifier: Apache-2.0
#include "space/half_spaces.h"

#include "space/kernels.h"

namespace avo::space {

void append_half_spaces(const SpacePairs& pairs, const OwnLimits& own, const Horizon& horizon,
                        HalfSpaces& half_spaces) {
  if (pairs.count == 0) return;
  const std::size_t size = pairs.count + kSparePairs;
  half_spaces.columns.reserve(half_spaces.columns.count + pairs.count);
  for (auto* axis : {&half_spaces.along, &half_spaces.across}) {
    for (std::vector<double>& column : *axis) grow(column, size);
  }
  half_spaces.plane_pairs.reserve(pairs.count);
  kernels().find_frames(pairs, half_spaces);
  half_planes(half_spaces.plane_pairs, horizon, half_spaces.workspace, half_spaces.planes);
  kernels().turn_back(pairs, own, half_spaces);
}

}  // namespace avo::space
