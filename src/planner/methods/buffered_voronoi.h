// SPDX-License-Identifier: Apache-2.0
// Method buffered_voronoi: D. Zhou, Z. Wang, S. Bandyopadhyay, M. Schwager, "Fast, On-line
// Collision Avoidance for Dynamic Vehicles Using Buffered Voronoi Cells", RA-L 2017.
#pragma once
#include "avo/planner.h"
#include "core/robot_columns.h"
#include "planner/stages/soft_planes.h"

namespace avo::inline planner {

/// One side of A's cell: { x : n . (x - p_A) <= gap }.
struct CellSide {
  Vec2 normal;       ///< [n] unit, from A to B; 0 where the centers coincide: there is no side
  double gap = 0.0;  ///< m, from p_A; negative in contact
};

/// The bisector less r_A. For unequal radii it is moved by (r_A - r_B)/2 to B's side. Then each
/// robot has half of the gap between the discs, and the discs of centers in two cells are disjoint.
/// Against a mover, the whole gap is A's.
CellSide cell_side(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor);

/// m/s: the largest speed V at the end of a step that begins with `speed`, with the acceleration
/// held. Both are towards a side at the distance `gap`, and braking from V must stop there or
/// before: V is at most sqrt(2 b gap). If there is no such V, it is the speed that leads back to
/// the side at the end of the step.
double speed_within(double gap, double speed, double max_braking, double time_step);

/// Collects the half-planes of all robots of the tile: v' must be able to stop within the cell. If
/// both have footprints, the two nearest discs count.
void collect_cells(const PlannerOptions& options, const StepLaw& law, const Tile& tile,
                   SoftPlanes& soft);

/// Writes each robot's wish into scratch.decisions: the preferred velocity where its goal is in its
/// cell. Otherwise the robot goes to the point of the cell nearest the goal (their Algorithm 1),
/// and rests there. Near that point it keeps to the right along the side that blocks it.
void wish_within_cells(const PlannerOptions& options, const RobotColumns& robots,
                       PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
