// SPDX-License-Identifier: Apache-2.0
// Tolerances and bounds of the half-plane's kernels.
#pragma once
#include <cstddef>

namespace avo::inline obstacles {

// The most iterations of Newton's method; bisection alone would end by then.
constexpr int kMaxIterations = 64;
// How often a horn's near side may cross the circle |w| = R. It is once, which is nearly always
// known beforehand, or several times; the near side must then be followed.
enum class Crossed : unsigned char { once, often };
constexpr std::size_t kMostCrossings = 3;
// Along a near side that is followed, with halved strides.
constexpr int kMaxStrides = 48;
// `cusp` may change its sign twice within a stride. This is not proved but measured. In 10^7 random
// close passes none was missed where long strides near R, with a `cusp` near 0, are halved (at most
// as many again).
constexpr double kFlat = 0.1;   // of l²
constexpr double kWide = 0.25;  // of the time, and of R
// The bound of the relative product of the last two steps, which leaves an error of about its
// square. Every use is of second order in the time.
constexpr double kTimeTolerance = 1e-4;
// The same bound where the near side may have cusps near by.
constexpr double kCloseTolerance = 1e-8;
// Relative bound of Newton's last step in σ, which leaves about its square.
constexpr double kConvexTolerance = 1e-8;
// Its square does not underflow.
constexpr double kTiniest = 1e-150;
// An angle with a smaller |sin| may come from rounding.
constexpr double kTie = 1e-9;
// Supports that differ by less than this part of the reach differ only by rounding: a tie.
constexpr double kEqualSupports = 0x1p-40;
// A part of r: nearer than this, the distance left is of the order of rounding.
constexpr double kContact = 1e-9;
// m/s; a slower pair is at rest.
constexpr double kSlowest = 1e-100;

}  // namespace avo::inline obstacles
