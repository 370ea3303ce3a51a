// SPDX-License-Identifier: Apache-2.0
// Constants of sine and cosine, see core/elementary.h.
#pragma once

namespace avo::elementary {

struct TwoDoubles {
  double high, low;
};

// π/2 in three parts of 53 bits each.
inline constexpr double kHalfPi[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                     -0x1.f1976b7ed8fbcp-110};

// Coefficients of Taylor's series that are small enough for doubles: of x^7 and up, and of x^6.
inline constexpr double kSineTail[] = {
    -1.0 / 5040.0,          1.0 / 362880.0,          -1.0 / 39916800.0,          1.0 / 6227020800.0,
    -1.0 / 1307674368000.0, 1.0 / 355687428096000.0, -1.0 / 121645100408832000.0};
inline constexpr double kCosineTail[] = {
    -1.0 / 720.0,         1.0 / 40320.0,          -1.0 / 3628800.0,         1.0 / 479001600.0,
    -1.0 / 87178291200.0, 1.0 / 20922789888000.0, -1.0 / 6402373705728000.0};

// The coefficients before these: of x^5 and x^3, and of x^4 and x^2.
inline constexpr TwoDoubles kSineHead[] = {{0x1.1111111111111p-7, 0x1.1111111111111p-63},
                                           {-0x1.5555555555555p-3, -0x1.5555555555555p-57}};
inline constexpr TwoDoubles kCosineHead[] = {{0x1.5555555555555p-5, 0x1.5555555555555p-59},
                                             {-0.5, 0.0}};

}  // namespace avo::elementary
