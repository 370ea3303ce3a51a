// SPDX-License-Identifier: Apache-2.0
// The inputs of a robot that keeps an evasive maneuver (docs/movers.md): the predicted movers, the
// walls that it knows, and its own evasive maneuvers.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "certificate/evasions.h"
#include "certificate/fallback_areas.h"
#include "planner/decision.h"
#include "planner/rules/levels.h"
#include "planner/stages/certified.h"

namespace avo::inline planner {

/// Scratch memory; allocates only while it grows.
struct EvasionWorkspace {
  Surroundings around;
  std::vector<Neighbor> deciding;  // the neighbors that decide
  CertifiedWorkspace certified;    // for these neighbors and for walls
  // of the last plan that evades: its evasive maneuver, and the choice that it has rejected
  Evasion chosen;
  Vec2 put_aside;  // see Taken::choice
};

/// The surroundings that a robot is given.
struct Sight {
  std::span<const Neighbor> neighbors;
  /// all walls within wall_range, or those that the certificate needs
  std::span<const Wall> walls;
  double wall_range = 0.0;  ///< m, see PlannerOptions::wall_range
  /// of a robot that flies, for its choices: the demands of its deciding neighbors and of walls
  const FlightConstraints* flight = nullptr;
};

/// The state of one decision.
struct Evading {
  const CertificateLaw& law;
  const Robot& robot;
  Sight sight;
  EvasionWorkspace& workspace;
  EvasionOptions options;
  double radius = 0.0;           // m, of the robot's disc, or of each disc of its footprint
  double braking = 0.0;          // s, the longest time of braking
  bool has_constraints = false;  // whether the workspace has constraints

  EvasionState now() const { return {{}, robot.velocity, 0.0, robot.heading}; }
};

/// The replacement of a choice, and the evasive maneuver that begins with it.
struct Taken {
  Vec2 choice;  // m/s, the velocity after the step; of a robot that flies m/s², its acceleration
  Evasion evasion;
};

inline bool decides(const Neighbor& neighbor) {
  return !is_predicted(neighbor);
}

/// m: the range of a robot's evasive maneuvers.
double evasion_range(const Robot& robot);
/// s, from a decision until rest: the duration of the longest evasive maneuver of a robot that is
/// no faster than its max_speed.
double longest_evasion(const Robot& robot, const StepLaw& law);

/// The result is none for robots that have no evasive maneuvers.
std::optional<Evading> begin_evading(const CertificateLaw& law, const Robot& robot,
                                     const Sight& sight, EvasionWorkspace& workspace);
/// Predicts all neighbors that do not decide, and begins evasive maneuvers of that level.
void look_around(Evading& evading, const Level& level);
/// Keeps the walls within reach, because walls beyond it are not known for sure. Where there is
/// one, evasive maneuvers stay within that reach.
void keep_walls(Evading& evading);

}  // namespace avo::inline planner
