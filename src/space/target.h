// SPDX-License-Identifier: Apache-2.0
// What Eq. (23) makes of a wish.
#pragma once
#include <span>

#include "avo/export.h"
#include "avo/horizon.h"
#include "planner/stages/execution.h"
#include "space/decide.h"
#include "space/look.h"
#include "space/own_space.h"
#include "space/workspace.h"

namespace avo::space {

/// The inputs of a decision. Velocities with `own` in their names are in the robot's own space.
struct AVO_LOCAL Deciding {
  const Robot& robot;
  const PlannerOptions& options;
  StepLaw law;
  const Tempo& tempo;
  Haste haste;
  const Horizon& full_horizon;  ///< of moving obstacles, which do not see that it arrives
  Vec3 own_velocity, own_last_change;
  const Viewer& look;
  const BodiesAround& around;
  PlanWorkspace::Scratch& scratch;

  Vec3 own(Vec3 a) const { return to_own(a, robot.vertical); }
  Vec3 in_space(Vec3 a) const { return from_own(a, robot.vertical); }
};

/// A target, and by how much it violates the half-spaces.
struct Target {
  Vec3 own;  ///< [v'] m/s
  double violation = 0.0;
};

/// Sets the hard half-spaces of climb, sink and boxes.
void collect_hard(const Deciding& decision, std::span<const Box> boxes);

/// All half-spaces that can cut, the hard ones and then the soft ones, in the robot's own space.
HalfSpaceColumns& all_half_spaces(const Deciding& decision);

/// Eq. (23) among the half-spaces. Where nothing keeps all of them, the hard ones are kept, near
/// the least unsafe point.
Target target_of(const Deciding& decision, HalfSpaceColumns& half_spaces, Vec3 own_wish);

/// Eq. (23) for the aim, among all half-spaces.
Target target_of_aim(const Deciding& decision, Vec3 own_aim);

}  // namespace avo::space
