// SPDX-License-Identifier: Apache-2.0
// Programs of kWidth robots with their numbers side by side, as kernels read them.
#pragma once
#include <cstddef>
#include <cstdint>

namespace avo::inline lp {

template <std::size_t kWidth>
struct ProgramGroup {
  using Lanes = double[kWidth];
  Lanes c_x, c_y, radius;    // acceleration disc
  Lanes top_speed;           // speed disc around 0
  Lanes p_x, p_y;            // preferred
  Lanes planes;              // number of half-planes
  Lanes x, y, violation;     // result
  std::uint32_t settled;     // bit l: lane l
  std::uint32_t moved;       // the result is not the preferred one
  std::uint32_t failed;      // the half-planes leave nothing
  std::size_t first, count;  // rows
};

/// One half-plane of each lane, an arbitrary one where a robot has fewer.
template <std::size_t kWidth>
struct ProgramRow {
  using Lanes = double[kWidth];
  Lanes n_x, n_y, offset;
  Lanes relative;  // the offset, from LensOf::origin
};

/// The largest number of half-planes, out of `count`, that all lanes of a pack take, in the plane
/// and then for the least unsafe point. Some lanes begin the second part when others have finished
/// the first.
constexpr std::size_t most_taken(std::size_t count) {
  return 2 * count + 2;
}

}  // namespace avo::inline lp
