// SPDX-License-Identifier: Apache-2.0
// Eq. (23): the velocities that robots choose in the half-planes of their neighbors, and again with
// the demands of walls and of their own motion.
#pragma once
#include <cstddef>
#include <span>

#include "avo/planner.h"
#include "certificate/braking_path.h"
#include "planner/scratch.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Solves Eq. (23) for each robot, in scratch.decisions.
void solve_programs(const Planner& planner, const RobotColumns& robots,
                    PlanWorkspace::Scratch& scratch);

/// Returns whether walls or its own motion demand anything of robot i, for which Eq. (23) is
/// solved.
bool has_demands(const Tile& tile, std::size_t i, const DecisionColumns& decisions);

/// The half-planes of robot i: those of its walls and of its own motion, which are scratch.demands,
/// and those of neighbors.
std::span<const HalfPlane> collect_hard_and_soft(const Planner& planner, const Robot& robot,
                                                 const Tile& tile, std::size_t i,
                                                 const StepLaw& law,
                                                 PlanWorkspace::Scratch& scratch);

/// Walls are hard, and so are the limits of a robot's motion. Where a target does not keep these
/// half-planes, Eq. (23) is solved again with them. Where that has no solution, the half-planes of
/// neighbors yield.
void keep_to_demands(const Planner& planner, const Tile& tile, PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
