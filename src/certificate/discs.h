// SPDX-License-Identifier: Apache-2.0
// The discs of footprints. Each disc has the constraints of a robot by itself, and all discs have
// one decision (docs/certificate/footprints.md).
#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/robot.h"
#include "certificate/braking_trajectories.h"
#include "certificate/wall_constraints.h"
#include "core/neighbor_columns.h"

namespace avo::inline certificate {

/// See Planner::braking_pose().
BrakingPose braking_pose(const Robot& robot, const StepLaw& law);
BrakingPose braking_pose(const MotionModel& model, Vec2 velocity, double heading,
                         double max_braking, const StepLaw& law);

/// One disc of a robot with a footprint, as a robot. It is at the center about which it turns. Its
/// radius covers it while the robot brakes. Its model and its heading are those of the robot.
Robot disc_of(const Robot& robot, const BrakingPose& pose, int k);
/// The same of a neighbor; it has no footprint then.
Neighbor disc_of(const Neighbor& neighbor, int k);

/// Returns whether others keep clear of the discs of its footprint. A neighbor that does not decide
/// may turn as it likes, and counts as the one disc that covers it at any heading.
inline bool has_discs(const Neighbor& neighbor) {
  return neighbor.footprint && !is_predicted(neighbor);
}
/// The number of discs that others keep clear of.
inline int disc_count(const Neighbor& neighbor) {
  return has_discs(neighbor) ? neighbor.footprint.discs : 1;
}

/// m, more lengths for the rounding of a disc that is so far from its robot.
inline double lengths_of_rounding(double lever) {
  return 4.0 *
         std::abs(lever);  // of its heading, of the direction of that, and of the center there
}
/// m, added to the contact of two discs that are so far from their robots: the rounding of their
/// places (docs/certificate/rounding.md).
double rounding_of_discs(const BrakingPair& pair, double lever, double other_lever);

/// The demands on one disc of a robot.
struct DiscConstraints {
  double ahead = 0.0;  ///< m, from the robot's position to its center
  TrajectoryConstraints trajectories;
  WallConstraints walls;
  CandidatePath path;  ///< of the last tested candidate
};

/// The demands on all discs of a robot. Scratch memory; allocates only while it grows.
struct FootprintConstraints {
  std::vector<DiscConstraints> discs;
  std::size_t count = 0;  ///< of discs; 0: the robot has no footprint
  BrakingPose pose;       ///< of the robot now

  std::span<DiscConstraints> all() { return std::span(discs).first(count); }
  std::span<const DiscConstraints> all() const { return std::span(discs).first(count); }
};

/// Begins the constraints of the neighbors of a robot with a footprint, and collects all of them.
/// `near` has the robot as number i. The robot must be able to rest.
void collect_discs(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                   std::size_t i, const StepLaw& law, FootprintConstraints& footprint,
                   Invariant& invariant);

/// Begins the constraints of the walls near a robot with a footprint. `all` has what they have in
/// common: the deepest broken one, and whether the robot must brake.
void begin_disc_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                      FootprintConstraints& footprint, WallConstraints& all);

/// Follows all discs to the next velocity, and returns whether they keep all their constraints.
bool keep_discs(const Robot& robot, Vec2 next_velocity, const StepLaw& law,
                FootprintConstraints& footprint, Asked asked_for);

}  // namespace avo::inline certificate
