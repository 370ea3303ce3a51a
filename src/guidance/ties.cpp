// SPDX-License-Identifier: Apache-2.0
#include "guidance/ties.h"

#include <cstdint>

namespace avo::inline guidance {
namespace {

constexpr double kTie = 0.03;    // robots right ahead: the largest value, too small to be visible
constexpr double kAlike = 1e-5;  // of a squared distance: places may be given in few digits

// [0, 1), van der Corput's sequence: no two of consecutive numbers are near each other.
double spread(std::uint64_t number) {
  double place = 0.0;
  for (double half = 0.5; number != 0; number /= 2, half /= 2) {
    if (number % 2 != 0) place += half;
  }
  return place;
}

}  // namespace

void break_tie(RobotId robot, double nearest_squared, double next_squared, Detour& detour) {
  if (detour.congestion != 0.0F || next_squared - nearest_squared > kAlike * nearest_squared)
    return;
  detour.congestion = static_cast<float>(kTie * spread(robot.value));
}

}  // namespace avo::inline guidance
