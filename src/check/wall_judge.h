// SPDX-License-Identifier: Apache-2.0
// Robots against walls: contacts, and the least clearance.
#pragma once
#include <optional>
#include <vector>

#include "avo/check.h"
#include "check/box_tree.h"
#include "check/step.h"

namespace avo::judge {

/// The tree contains the walls; a robot counts once.
class WallJudge {
 public:
  void set_walls(std::vector<CheckedWall> walls);
  /// Judges one robot over the step. A robot keeps clear of the walls of its layers.
  void judge(const MovingDisc& robot, const JudgedStep& step);
  /// Returns whether a wall of a robot in those layers touches the segment between the two places.
  [[nodiscard]] bool hides(Vec2 from, Vec2 to, std::uint32_t layers) const;
  /// Writes all results.
  void write(CheckReport& report) const;

 private:
  void meet(const MovingDisc& robot, std::size_t wall, const JudgedStep& step);

  std::vector<CheckedWall> walls_;
  BoxTree tree_;
  std::vector<bool> touched_;  // by robot
  CheckCount contacts_;
  std::optional<double> least_clearance_;
};

}  // namespace avo::judge
