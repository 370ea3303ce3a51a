// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: alone each decides the same, but their half-planes and programs
// then share lanes.
#pragma once
#include <span>

#include "avo/planner.h"
#include "core/stage_clock.h"
#include "planner/soft_planes.h"

namespace avo {

struct Deciding {
  Sensing sensing;
  Detour* detour = nullptr;  ///< what it remembers; updated
  Plan* plan = nullptr;      ///< filled
};

/// Planner::plan() of each. Not for method velocity_obstacle.
void plan_together(const Planner& planner, std::span<const Deciding> robots,
                   PlanWorkspace& workspace, StageClock& clock) noexcept;

/// Room for so many robots, with so many neighbors in all.
void reserve_together(std::size_t robots, std::size_t neighbors, PlanWorkspace& workspace);

}  // namespace avo
