// SPDX-License-Identifier: Apache-2.0
// Tolerances and bounds of the program's kernels.
#pragma once
#include <limits>

namespace avo::inline lp {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kToleranceUlps = 8.0;
constexpr double kTouchingUlps = 2.0;
// The corners need fourth powers, of numbers that are not denormal.
constexpr double kLargestSize = 0x1p200;
constexpr double kSmallestSize = 0x1p-200;
// Squares of preferred points within this distance do not overflow.
constexpr double kFarthest = 0x1p400;
// A point just computed on one circle may miss the other one's inside by rounding alone. For nearly
// equal discs that must not count as "outside of both": the corner may be far away.
constexpr double kRoundingOfSquares = 1.0 + 8.0 * kUlp;

}  // namespace avo::inline lp
