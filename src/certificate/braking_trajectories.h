// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: on each interval each robot keeps to its own side of a line. Both robots of
// a pair derive the line from the paths on which they would brake now (docs/certificate.md).
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/constraint_columns.h"
#include "certificate/near_pairs.h"
#include "certificate/pair.h"
#include "certificate/trajectory_steps.h"
#include "core/neighbor_columns.h"

namespace avo::inline certificate {

/// What one neighbor demands on one interval between steps: normal . y_i + offset[i] >= 0 for the
/// Bézier points y_0, y_1, y_2 of A's path on it, relative to p_A.
struct TrajectoryConstraint {
  int neighbor = 0;
  int interval = 0;                ///< 0: the step of the decision
  bool only_in_motion = false;     ///< applies only to paths on which A still moves then
  Vec2 normal;                     ///< unit, from B to A
  std::array<double, 3> offset{};  ///< m
  /// Error of the normal from sensing errors: cone |y_i - x_i| is demanded in addition. x is A's
  /// braking path.
  double cone = 0.0;
  /// m, <= 0: a path with normal . (y - x) >= bound keeps the constraint. x is the braking path.
  double bound = 0.0;
};

/// Scratch memory; allocates only while it grows.
struct TrajectoryConstraints {
  ConstraintColumns columns;  ///< the constraints of one neighbor are consecutive
  Braking own;
  Deviation deviation;
  OwnColumns own_columns;
  TrajectorySteps trajectory;  ///< of the present neighbor, where it is known
  /// pairs with constraints that no candidate has needed yet
  std::vector<const NearPair*> waiting;
  /// A rests so near a neighbor that does not decide that A may not begin to move.
  bool stays_at_rest = false;
  bool has_cones = false;
};

TrajectoryConstraint constraint_at(const ConstraintColumns& columns, std::size_t index);

/// Begins the constraints of robot i of the robots in `near`, for candidates with |v_1 - v| <= u.
/// The constraints of its movers are collected. Those of other neighbors wait until a candidate
/// comes that they can refuse. Neighbors that do not decide are assumed to keep their acceleration.
/// A's share is then 1, and only times count in which A moves.
void begin_trajectories(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                        std::size_t i, const StepLaw& law, TrajectoryConstraints& constraints,
                        Invariant& invariant);

/// A robot, or one disc of its footprint.
struct OneDisc {
  const Robot& robot;  ///< the whole robot, which may meet the neighbor
  Robot disc;          ///< what keeps clear of it
  double lever = 0.0;  ///< m, from the robot's position to the disc
};
/// The neighbors that are tested one by one: all, or those that the lanes leave out.
enum class Selected : unsigned char { all, left_out };

/// Collects the constraints of these neighbors, with all discs of their footprints.
void collect_one_by_one(const OneDisc& self, const Neighbors& neighbors, Selected selected,
                        const StepLaw& law, TrajectoryConstraints& constraints,
                        Invariant& invariant);

/// Collects the constraints of the waiting pairs that can refuse the path.
void collect_refusing(const Robot& robot, const CandidatePath& path, const StepLaw& law,
                      TrajectoryConstraints& constraints, Invariant& invariant);

/// Collects the constraints of all waiting pairs.
void collect_waiting(const StepLaw& law, TrajectoryConstraints& constraints, Invariant& invariant);

/// Returns whether the path keeps all constraints, and computes the coefficient of each constraint
/// that is asked.
bool keeps_trajectories(const CandidatePath& path, const StepLaw& law,
                        TrajectoryConstraints& constraints, Asked asked_for);

/// The constraint that the last tested path violates most.
struct WorstConstraint {
  double coefficient;  ///< m, < 0 if a constraint is violated; otherwise nothing else is set
  TrajectoryConstraint constraint = {};
  int point = 0;   ///< which of the three points
  Vec2 lean = {};  ///< the part of the normal that a cone takes off there
};
/// The worst of the constraints [first .. last), as far as they have been tested for the path.
WorstConstraint worst_constraint(const TrajectoryConstraints& constraints,
                                 const CandidatePath& path, const StepLaw& law, std::size_t first,
                                 std::size_t last);

/// The constraint's half-plane in v_1, tangent at the path: v_1 lies outside if the path violates
/// the constraint.
HalfPlane tangent(const WorstConstraint& worst, const CandidatePath& path, const StepLaw& law);

}  // namespace avo::inline certificate
