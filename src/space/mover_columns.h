// SPDX-License-Identifier: Apache-2.0
// The moving obstacles of a fleet of space: their ids, and where they are now.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/ids.h"
#include "avo/space/mover.h"

namespace avo::space {

/// Columns by ascending id, beside those of the scene's moving obstacles.
struct MoverColumns {
  std::vector<MovingObstacleId> id;
  std::vector<std::int64_t> since;  // its position and velocity hold at the start of this step
  std::vector<Mover> now;
  std::vector<MoverState> before;  // at the start of the last step, or when it came
  std::uint64_t next_id = 0;

  /// Adds one that comes at the start of that step. Call it on a copy: it may throw in the midst.
  void add(std::int64_t step);
  void remove(std::size_t k);
  /// Throws Error if there is none.
  [[nodiscard]] std::size_t find(MovingObstacleId obstacle) const;
  /// Sets where one was before from where it is now.
  void begin(std::size_t k) { before[k] = {now[k].position, now[k].velocity}; }
  /// Sets where they are at the start of that step. obstacles: those of the scene.
  void move_to(std::int64_t step, std::span<const MovingObstacle> obstacles, double time_step);
};

/// s, at the start of a step: the time on the obstacle's own clock. A trajectory has the clock of
/// the run. The others count from the step in which they came, or were changed.
double own_time(const MovingObstacle& obstacle, std::int64_t since, std::int64_t step,
                double time_step);

}  // namespace avo::space
