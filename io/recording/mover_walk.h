// SPDX-License-Identifier: Apache-2.0
// The places of a scene's moving obstacles at the times of a recording, which has no rows of them.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "avo/scenario.h"

namespace avo_io {

class MoverWalk {
 public:
  explicit MoverWalk(const avo::Scenario& scenario);

  /// Moves on to the next time, s; times must ascend. Throws Error if the place of an obstacle with
  /// a path is unknown then: clocks are free, and rows are missing before the first time.
  void go_to(double time);
  /// Throws Error if clocks are free and rows are missing up to `time`: such steps matter.
  void require_known(double time) const;
  [[nodiscard]] avo::Vec2 position(std::size_t obstacle) const { return now_[obstacle].position; }
  [[nodiscard]] avo::Vec2 velocity(std::size_t obstacle) const { return now_[obstacle].velocity; }

 private:
  avo::Clock clock_;
  double time_step_;  // s
  std::vector<avo::MovingObstacle> obstacles_;
  std::vector<avo::PathWalk> walks_;  // at the end of the last whole step
  std::vector<avo::PathWalk> now_;
  std::optional<double> last_time_;
};

}  // namespace avo_io
