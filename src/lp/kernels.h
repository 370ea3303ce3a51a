// SPDX-License-Identifier: Apache-2.0
// What the kernels of the program share whatever the instruction set, and their scalar instance.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/scalar.h"
#include "lp/programs.h"

namespace avo {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kToleranceUlps = 8.0;
constexpr double kTouchingUlps = 2.0;
// The corners need fourth powers, of numbers that are not denormal.
constexpr double kLargest = 0x1p200;
constexpr double kSmallest = 0x1p-200;
// A point just computed on one circle may miss the other one's inside by rounding alone. For discs
// that are nearly equal that must not look like "outside of both": the corner may be far away.
constexpr double kRoundingOfSquares = 1.0 + 8.0 * kUlp;

// Of `count` half-planes by all lanes of a pack, in the plane and then on the way to the least
// unsafe point: some lanes begin with the second when others have done with the first.
constexpr std::size_t most_taken(std::size_t count) {
  return 2 * count + 2;
}

namespace scalar::planar {
#include "lp/program_kernels.h"
}  // namespace scalar::planar

struct ProgramKernels {
  void (*solve)(Programs&, ProgramRow*, bool);
};

}  // namespace avo
