// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: each robot keeps, interval by interval, to its own side of a line that
// both robots of a pair derive from the paths on which they would brake now (docs/certificate.md).
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
  int interval = 0;                ///< 0: the step to be decided
  bool only_in_motion = false;     ///< asked only of paths on which A still moves then
  Vec2 normal;                     ///< unit, from B to A
  std::array<double, 3> offset{};  ///< m
  /// With sensing errors the normal is off by so much: cone |y_i - x_i| is asked for besides, x
  /// being A's braking path.
  double cone = 0.0;
  /// m, <= 0: a path that keeps normal . (y - x) >= bound, x the braking path, keeps the
  /// constraint.
  double bound = 0.0;
};

/// Scratch memory; allocates only while it grows.
struct TrajectoryConstraints {
  ConstraintColumns columns;  ///< a neighbor's follow each other
  Braking own;
  Deviation deviation;
  OwnColumns own_columns;
  TrajectorySteps trajectory;            ///< of the neighbor that is looked at, where it is known
  std::vector<const NearPair*> waiting;  ///< whose constraints no candidate has asked for yet
  /// A rests beside one that does not decide, so near that it may not begin to move.
  bool stays_at_rest = false;
  bool has_cones = false;
};

TrajectoryConstraint constraint_at(const ConstraintColumns& columns, std::size_t index);

/// Those of robot i, of the robots that were looked at, for candidates with |v_1 - v| <= u: the
/// constraints of its movers, while those of other neighbors wait until a candidate comes that they
/// can refuse. Neighbors that do not decide are taken to keep their acceleration, A's share is 1,
/// and only the time counts in which A moves.
void begin_trajectories(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                        std::size_t i, const StepLaw& law, TrajectoryConstraints& constraints,
                        Invariant& invariant);

/// Collects the constraints of those that wait and can refuse the path.
void collect_refusing(const Robot& robot, const CandidatePath& path, const StepLaw& law,
                      TrajectoryConstraints& constraints, Invariant& invariant);

/// Collects the constraints of all that wait.
void collect_waiting(const StepLaw& law, TrajectoryConstraints& constraints, Invariant& invariant);

/// Whether the path keeps all constraints, and by how much or how little each that is asked.
bool keeps_trajectories(const CandidatePath& path, const StepLaw& law,
                        TrajectoryConstraints& constraints, Asked asked_for);

/// The constraint that the path asked about last violates most.
struct WorstConstraint {
  double coefficient;  ///< m, < 0; of nothing else is known where it violates none
  TrajectoryConstraint constraint = {};
  int point = 0;   ///< of the three
  Vec2 lean = {};  ///< what a cone takes off the normal there
};
/// Of constraints [first .. last) alone, as far as the path was held against them.
WorstConstraint worst_constraint(const TrajectoryConstraints& constraints,
                                 const CandidatePath& path, const StepLaw& law, std::size_t first,
                                 std::size_t last);

/// The constraint's half-plane in v_1, tangent at the path: v_1 of a path that violates it lies
/// outside.
HalfPlane tangent(const WorstConstraint& worst, const CandidatePath& path, const StepLaw& law);

}  // namespace avo::inline certificate
