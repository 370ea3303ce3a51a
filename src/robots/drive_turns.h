// SPDX-License-Identifier: Apache-2.0
// The turns of several differential drives together.
#pragma once
#include <array>
#include <cstddef>

#include "avo/vec.h"
#include "robots/model.h"

namespace avo::inline robots {

// rad, the largest turn of the heading in a substep.
inline constexpr double kSubturn = 1.0 / 16.0;
// A step that needs more substeps is refused.
inline constexpr double kMostSubsteps = 1024.0;
inline constexpr double kFewestSubsteps = 2.0;

/// Their steps, in columns: the number is a multiple of the number of lanes of any vector.
struct DriveTurns {
  static constexpr std::size_t kMost = kMostModelSteps;
  using Column = std::array<double, kMost>;
  std::size_t count = 0;
  // m/s, of q; the headings at the start and the offsets, m
  Column ahead_x, ahead_y, v_x, v_y, next_x, next_y, offset;
  Column half_x, half_y;  // unit: half of the angle of each turn, see turn()

  void add(const DifferentialDrive& drive, Vec2 ahead, Vec2 velocity, Vec2 next_velocity) {
    set(count++, drive.offset, ahead, velocity, next_velocity);
  }
  /// Lanes after the last step get a trivial step.
  void fill_up() {
    for (std::size_t k = count; k < kMost; ++k) set(k, 1.0, {1.0, 0.0}, {}, {});
  }
  Vec2 half(std::size_t k) const { return {half_x[k], half_y[k]}; }

 private:
  void set(std::size_t k, double axle_offset, Vec2 ahead, Vec2 velocity, Vec2 next_velocity) {
    ahead_x[k] = ahead.x, ahead_y[k] = ahead.y, offset[k] = axle_offset;
    v_x[k] = velocity.x, v_y[k] = velocity.y;
    next_x[k] = next_velocity.x, next_y[k] = next_velocity.y;
  }
};

/// Finds half_x and half_y for steps of so many seconds.
void turn(DriveTurns& turns, double time);

}  // namespace avo::inline robots
