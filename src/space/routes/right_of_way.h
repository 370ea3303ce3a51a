// SPDX-License-Identifier: Apache-2.0
// The rules of the plane at passages of space (docs/arrival.md, rules 6 to 10).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "navigation/right_of_way.h"
#include "space/routes/passages.h"
#include "space/routes/search.h"

namespace avo::space {

/// A robot that seems to claim a passage.
struct SpaceClaimant {
  Claimant plane;  ///< folded: along the axis, and off it
  Vec3 position;   ///< m
  std::uint32_t robot = 0;
};

/// The claims of one moment, by passage.
struct SpaceClaims {
  std::vector<std::vector<SpaceClaimant>> of;

  void clear(std::size_t passages);
};

/// Appends the claims that a robot seems to have, by its place and its velocity, m/s.
void append_claims(const SpacePassages& passages, const Solids& solids, Vec3 position,
                   Vec3 velocity, std::uint32_t robot, SpaceClaims& claims);

/// What the rules know of the robot that decides.
struct SpaceClaimer {
  Vec3 position;                ///< m
  double radius = 0.0;          ///< m
  double braking = 0.0;         ///< m/s^2
  double sensing_radius = 0.0;  ///< m
  std::uint32_t robot = 0;
  std::span<const SpaceRoutePoint> route;  ///< from its place on
  std::span<const Neighbor> neighbors;
  double yielded = 0.0;  ///< s, for which it has let others enter before it
};

/// Where to go in place of farther on the route, if anywhere, and the largest speed.
struct SpaceCourse {
  std::optional<Vec3> target = {};  ///< m
  bool is_after_others = false;     ///< it lets another robot enter before it
  bool stops = false;               ///< at the target
  double max_speed = std::numeric_limits<double>::infinity();  ///< m/s
};

/// The course at the passage of one lane that the robot is in or comes to next. others: scratch.
SpaceCourse right_of_way(const SpacePassages& passages, const SpaceClaims& claims,
                         const SpaceClaimer& robot, std::vector<Claimant>& others);

/// The robot for which another one waits at a passage.
struct SpaceWait {
  Vec3 passage;           ///< m: the middle of its axis
  bool is_claim = false;  ///< `robot` is a number of the fleet, and else of a neighbor
  std::uint32_t robot = 0;
  bool inside = false;  ///< whether that robot is in the passage
};

/// The robot that the rules count first among those for which the robot waits, where right_of_way()
/// makes it wait. others: scratch.
std::optional<SpaceWait> waited_for(const SpacePassages& passages, const SpaceClaims& claims,
                                    const SpaceClaimer& robot, std::vector<Claimant>& others);

/// m: the place to move to in order to keep the lane, in a passage of two lanes.
std::optional<Vec3> lane_ahead(const SpacePassages& passages, const Solids& solids,
                               const SpaceClaimer& robot);

}  // namespace avo::space
