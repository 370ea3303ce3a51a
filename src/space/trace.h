// SPDX-License-Identifier: Apache-2.0
// What a decision in space tells of itself while it is made. decide() takes a trace as a template
// parameter, and calls it where it knows a reason. A step passes NoTrace, which compiles to
// nothing. Recorder keeps the reasons, for space::Planner::explain().
#pragma once
#include <span>
#include <vector>

#include "avo/space/decision_trace.h"
#include "planner/rules/arrival.h"
#include "planner/trace.h"
#include "space/certificate.h"
#include "space/evading.h"
#include "space/target.h"

namespace avo::space {

/// The reasons of one decision. Neighbors are known by the numbers of their bodies.
struct TraceRecord {
  DecisionTrace decision;
  std::span<const Box> boxes;           ///< as given
  std::span<const Mover> movers;        ///< as given
  std::vector<Cause>* asked = nullptr;  ///< receives who refuses what was asked for last
};

struct AVO_LOCAL Recorder {
  TraceRecord* record;

  /// Traffic ahead has turned the wish, m/s.
  void keeps_right(const Viewer& look, const Bodies& bodies, const Looked& looked, Vec3 wish) const;
  /// Pushes of neighbors beside the robot have made the wish.
  void yields(const Robot& robot, const Bodies& bodies, const Looked& looked, const PushRule& rule,
              Vec3 wish) const;
  /// Eq. (23) has chosen a target for an aim, among all half-spaces.
  void chooses(const Deciding& decision, Vec3 own_aim, const Target& target) const;
  /// The certificate is asked for the proposal, or for a velocity off the route, m/s.
  void asks(Vec3 proposal) const;
  void asks_off(Vec3 detour) const;
  /// What was asked for last is beyond the robot's own limits.
  void is_refused() const;
  /// The constraints refuse the candidate that was last tested, m/s.
  void is_refused(const Robot& robot, Vec3 candidate, const StepLaw& law,
                  Constraints& constraints) const;
  /// keep_evasion() has replaced the choice.
  void evades(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
              const Sight& sight, PlanWorkspace::Scratch& scratch) const;

 private:
  void wishes(WishRule rule, Vec3 wish, int heeded) const;
};

}  // namespace avo::space
