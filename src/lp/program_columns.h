// SPDX-License-Identifier: Apache-2.0
// Programs of kWidth robots whose numbers lie side by side, as kernels read them.
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
  Lanes planes;              // how many
  Lanes x, y, violation;     // result
  std::uint32_t settled;     // bit l: lane l
  std::uint32_t moved;       // the result is not the preferred one
  std::uint32_t failed;      // the half-planes leave nothing
  std::size_t first, count;  // rows
};

/// One half-plane of each lane, anything where a robot has fewer.
template <std::size_t kWidth>
struct ProgramRow {
  using Lanes = double[kWidth];
  Lanes n_x, n_y, offset;
  Lanes relative;  // the offset, from Lens::origin
};

/// How many of `count` half-planes all lanes of a pack take at most, in the plane and then on the
/// way to the least unsafe point: some lanes begin with the second when others have done with the
/// first.
constexpr std::size_t most_taken(std::size_t count) {
  return 2 * count + 2;
}

}  // namespace avo::inline lp
