// SPDX-License-Identifier: Apache-2.0
// One robot's certificate in space (docs/space.md, "The certificate"): the constraints of its
// neighbors, and whether a next velocity keeps them.
#pragma once
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "certificate/deepest.h"
#include "certificate/pair.h"
#include "space/bodies.h"
#include "space/boxes.h"
#include "space/kernels.h"
#include "space/look.h"
#include "space/mover_constraints.h"
#include "space/program.h"

namespace avo::space {

/// The demands of neighbors and boxes on a robot. Scratch memory; allocates only while it grows.
struct Constraints {
  ConstraintColumns columns;  ///< the constraints of one neighbor are consecutive
  OwnColumns own_columns;
  const Bodies* bodies = nullptr;
  /// Bodies that can refuse a candidate. Braking leaves the pair a gap, so its constraints wait
  /// until a candidate comes that it can refuse.
  std::vector<NearBody> waiting;
  Braking own;
  Vec3 own_direction;   ///< of the velocity in the robot's own space
  Deviation deviation;  ///< in the robot's own space
  Invariant invariant;
  MoverConstraints movers;  ///< by begin_movers(), after begin_constraints()
  BoxConstraints boxes;
  CandidatePath path;  ///< of the last tested candidate
  bool has_cones = false;
};

/// The braking of a robot with that velocity.
Braking braking_of(Vec3 velocity, double max_acceleration, double max_braking, double vertical,
                   const StepLaw& law);

/// The braking of the robot.
Braking braking_of(const Robot& robot, const StepLaw& law);

/// Begins anew, without neighbors and boxes. Sets `own`, the braking of the robot, and `deviation`.
void begin_constraints(const Robot& robot, const Braking& own, const StepLaw& law,
                       Constraints& constraints);

/// Collects the constraints of those of these bodies that can refuse a candidate, and of boxes. The
/// bodies have to stay where they are as long as candidates are tested.
void collect_constraints(const Robot& robot, const Bodies& bodies, std::span<const NearBody> near,
                         std::span<const Box> boxes, const StepLaw& law, Constraints& constraints);

/// Appends the constraints of the pairs that wait and can refuse the candidate v_1, m/s.
void append_needed(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                   Constraints& constraints);

/// Returns whether the robot may have the velocity v_1 after this step, m/s. It is true for
/// backup_velocity() wherever the invariant holds.
bool admits(const Robot& robot, Vec3 next_velocity, const StepLaw& law, Asked asked_for,
            Constraints& constraints);

/// [v_1] m/s: full braking.
Vec3 backup_velocity(const Robot& robot, const StepLaw& law);

/// Appends for each neighbor, moving obstacle and box that refuses the last tested candidate the
/// tangent of its worst constraint, a half-space in v_1 in the robot's own space.
void append_cuts(const Robot& robot, const StepLaw& law, const Constraints& constraints,
                 std::vector<HalfSpace>& cuts);

}  // namespace avo::space
