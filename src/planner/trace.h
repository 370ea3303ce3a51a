// SPDX-License-Identifier: Apache-2.0
// What a decision tells of itself while it is made. The stages of plan_together() take a trace as a
// template parameter, and call it where they know a reason. NoTrace compiles to nothing. Recorder
// keeps the reasons of a tile of one robot, for Planner::explain().
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "certificate/certificate.h"
#include "core/robot_columns.h"
#include "planner/decision_columns.h"
#include "planner/rules/arrival.h"
#include "planner/tile.h"

namespace avo::inline planner {

struct EvasionWorkspace;

struct NoTrace {
  static constexpr bool is_on = false;
  void prefers(const auto&...) const {}
  void keeps_right(const auto&...) const {}
  void yields(const auto&...) const {}
  void wishes(const auto&...) const {}
  void stays_in_cell(const auto&...) const {}
  void chooses(const auto&...) const {}
  void goes_around(const auto&...) const {}
  void proposes(const auto&...) const {}
  void asks(const auto&...) const {}
  void asks_off(const auto&...) const {}
  void is_refused(const auto&...) const {}
  void evades(const auto&...) const {}
};

/// The reasons of one robot's decision. Neighbors are numbered in the order of planning.
struct TraceRecord {
  DecisionTrace decision;
  Vec2 steered;             ///< m/s: the preferred velocity that wheels and wings leave
  bool has_target = false;  ///< whether the decision has come to its target
  /// receives which neighbor or wall refuses what was asked for last
  std::vector<Cause>* asked = nullptr;
};

struct Recorder {
  static constexpr bool is_on = true;
  TraceRecord* record;

  /// The robot has a preferred velocity, after its wheels or wings have turned it.
  void prefers(const RobotColumns& robots) const;
  /// keep_right() has made the wish.
  void keeps_right(const RobotColumns& robots, std::size_t i, const DecisionColumns& columns) const;
  /// Pushes of neighbors beside the robot have made the wish.
  void yields(const RobotColumns& robots, std::size_t i, const StepLaw& law, const PushRule& rule,
              Vec2 wish) const;
  /// Another rule has made the wish, m/s.
  void wishes(WishRule rule, Vec2 wish, int heeded = -1) const;
  /// wish_within_cells() has made the wish.
  void stays_in_cell(const Tile& tile, const DecisionColumns& columns) const;
  /// Eq. (23) has chosen a target for an aim.
  void chooses(const Tile& tile, const PlanWorkspace::Scratch& scratch) const;
  /// Eq. (14) has chosen a target for the preferred velocity.
  void goes_around(Vec2 target, const PlanWorkspace::Scratch& scratch) const;
  /// One step towards the target ends in the proposal, m/s.
  void proposes(Vec2 proposal) const;
  /// The certificate is asked for the proposal, or for a velocity off the route.
  void asks(Vec2 proposal) const;
  void asks_off(Vec2 detour) const;
  /// The constraints refuse the path that was last tested.
  void is_refused(const StepLaw& law, const CertificateConstraints& constraints) const;
  /// The constraints refuse that step of a robot that flies.
  void is_refused(const Robot& robot, const FlightConstraints& constraints,
                  const FlightStep& step) const;
  /// keep_evasion() has tested the plan.
  void evades(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
              EvasionWorkspace& workspace, const Plan& plan) const;
};

}  // namespace avo::inline planner
