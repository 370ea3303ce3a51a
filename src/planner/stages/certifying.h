// SPDX-License-Identifier: Apache-2.0
// One decision of method avo, or of a method behind a certificate: what its rules choose from.
#pragma once
#include "core/plane.h"
#include "planner/decision.h"
#include "planner/stages/certified.h"
#include "planner/stages/execution.h"
#include "robots/model.h"

namespace avo::inline planner {

/// The inputs of a decision; the constraints of the robot are in `certified`.
struct Certifying {
  const Robot& robot;
  CertificateLaw law;
  Haste haste;
  Disc acceleration;  // of v'
  const Wished& wished;
  CertifiedWorkspace& certified;

  Vec2 followed(Vec2 next) const {
    return is_holonomic(robot.model) ? next : within_own_limits(robot, law.step.braking_time, next);
  }
  // The velocity after one step towards v.
  Vec2 reached(Vec2 v) const { return followed(approach(robot.velocity, v, haste.most)); }
  // The same without haste; on a detour only the acceleration limits it.
  Vec2 gently(Vec2 v) const {
    return followed(executed(robot.velocity, wished.last_change, v, haste));
  }
  Vec2 smoothly(Vec2 v) const {
    return followed(executed(robot.velocity, wished.last_change, v, {1.0, haste.most, haste.jerk}));
  }
};

}  // namespace avo::inline planner
