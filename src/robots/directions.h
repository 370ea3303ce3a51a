// SPDX-License-Identifier: Apache-2.0
// Directions of many angles at once.
#pragma once
#include <cstddef>

namespace avo::inline robots {

/// Columns of angles have so many spare entries, which are read and written and do not count.
inline constexpr std::size_t kSpareAngles = 8;

inline constexpr double kMostAngle = 0x1p40;  // rad
/// The unit vectors of the angles, up to kMostAngle: elementary::direction() of each, bit for bit.
void find_directions(const double* angles, std::size_t count, double* x, double* y);

}  // namespace avo::inline robots
