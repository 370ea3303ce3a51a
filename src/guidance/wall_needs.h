// SPDX-License-Identifier: Apache-2.0
// Which walls the decisions of robots need.
#pragma once
#include <span>

#include "avo/planner.h"
#include "certificate/wall_constraints.h"
#include "guidance/traits.h"
#include "walls/wall_grid.h"

namespace avo::inline guidance {

/// The needs of the robots beside walls, for a grid of walls.
struct WallNeeds {
  double reach = 0.0;  // m, from a robot's center, of everything that it could touch
  WallRounding rounding;

  /// stray: m, see Stray.
  void include(const RobotTraits& robot, double stray, double speed, const StepLaw& law);
  /// All that the planner's decisions need for a robot with those limits, that model and that
  /// velocity.
  void include(const Robot& robot, const RobotTraits& traits, const Planner& planner);
  bool cover(const WallNeeds& needs) const;
  bool is_same(const WallNeeds& needs) const { return cover(needs) && needs.cover(*this); }
};

/// The grid of the walls that matter to those robots, at any place.
WallGrid grid_of(std::span<const Wall> walls, const WallNeeds& needs);

}  // namespace avo::inline guidance
