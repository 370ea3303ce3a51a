// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <span>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/space/planner.h"
#include "certificate/braking_path.h"
#include "space/bodies.h"
#include "space/certificate.h"
#include "space/tempo.h"

namespace avo::space {

/// The bodies around a robot; fill_braking() has been called for them.
struct BodiesAround {
  const Bodies& bodies;
  std::span<const Run> runs;                               ///< share no place
  double self = -1.0;                                      ///< the robot's own place; -1: none
  double range = std::numeric_limits<double>::infinity();  ///< m: others are not sensed
  std::span<const Box> boxes = {};
  std::span<const Mover> movers = {};
  /// Whether no other robot is expected on the robot's course. It changes the time of a decision
  /// alone.
  bool is_free = false;
};

/// The decision of a robot with valid inputs. Updates the detour. `remembers`: whether the
/// detour has the acceleration of the last step. horizons: see horizons_of(). The trace is NoTrace
/// or a Recorder.
template <typename Trace>
Plan decide(const PlannerOptions& options, std::span<const Horizon> horizons, const StepLaw& law,
            const Robot& robot, const Tempo& tempo, const BodiesAround& around, bool remembers,
            PlanWorkspace::Scratch& scratch, Detour& detour, Trace trace);

/// The constraints of a robot with valid inputs.
Constraints& admission_of(const PlannerOptions& options, std::span<const Horizon> horizons,
                          const StepLaw& law, const Robot& robot, const BodiesAround& around,
                          PlanWorkspace::Scratch& scratch);

/// Full braking.
Plan braking_plan(const Robot& robot, const StepLaw& law);

}  // namespace avo::space
