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
  Plan* plan = nullptr;      ///< filled, but for next_velocity: that is told by moving the robot
};

/// Planner::plan() of each. Not for method velocity_obstacle.
void plan_together(const Planner& planner, std::span<const Deciding> robots,
                   PlanWorkspace::Scratch& scratch, StageClock& clock);

/// Room for so many robots with at most so many half-planes each, and in all, among at most so many
/// neighbors each, and in all, which brake for at most so many steps.
void reserve_together(std::size_t robots, std::size_t planes_each, std::size_t planes,
                      std::size_t neighbors_each, std::size_t neighbors, std::size_t braking_steps,
                      PlanWorkspace::Scratch& scratch);

}  // namespace avo
