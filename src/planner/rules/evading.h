// SPDX-License-Identifier: Apache-2.0
// What a robot reckons with that keeps a way out (docs/movers.md): movers as it predicts them, the
// walls that it knows, and its own ways.
#pragma once
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "certificate/ways.h"
#include "planner/certified.h"
#include "planner/decision.h"

namespace avo::inline planner {

/// Scratch memory; allocates only while it grows.
struct EvasionWorkspace {
  Surroundings around;
  std::vector<Neighbor> deciding;  // of the neighbors
  CertifiedWorkspace certified;    // of these and of walls
  // of the last plan that evades: on which way, and the next velocity that it has put aside
  Evasion chosen;
  Vec2 put_aside;  // m/s
};

/// Whom and what a robot is given.
struct Sight {
  std::span<const Neighbor> neighbors;
  std::span<const Wall> walls;  ///< all within wall_range, or those that the certificate needs
  double wall_range = 0.0;      ///< m, see PlannerOptions::wall_range
};

/// What a way reckons with.
struct Level {
  double part;        ///< of a_max that the way uses
  double margin;      ///< of contact
  double reaction;    ///< T
  bool stops = true;  ///< (C2)
  /// Longest ways, for which rest is to be clear.
  double until = std::numeric_limits<double>::infinity();
  double likely = 0.0;  ///< of likely deviations
};

/// One decision.
struct Evading {
  const CertificateLaw& law;
  const Robot& robot;
  Sight sight;
  EvasionWorkspace& workspace;
  WayOptions options;
  double braking = 0.0;          // s, that it takes at most
  bool has_constraints = false;  // in the workspace

  WayState now() const { return {{}, robot.velocity, 0.0, robot.heading}; }
};

inline bool decides(const Neighbor& neighbor) {
  return !is_predicted(neighbor);
}

/// m: as far as the ways of a robot lead.
double way_range(double radius, double max_speed, double max_acceleration);
/// s, from a decision on until it rests: the longest way of a robot that is no faster than its
/// max_speed.
double longest_way_out(const Robot& robot, const StepLaw& law);

/// Nothing of robots that have no ways.
std::optional<Evading> begin_evading(const CertificateLaw& law, const Robot& robot,
                                     const Sight& sight, EvasionWorkspace& workspace);
/// Looks at all who do not decide, and begins ways by that level.
void look_around(Evading& evading, const Level& level);
/// Keeps the walls within reach: which others there are is not known for sure. Where there is one,
/// ways stay within that reach.
void keep_walls(Evading& evading);

}  // namespace avo::inline planner
