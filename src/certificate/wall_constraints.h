// SPDX-License-Identifier: Apache-2.0
// Walls: neither the step that is decided nor the braking after it may come within a robot's radius
// of any of them (docs/certificate/walls.md).
#pragma once
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"
#include "walls/segment.h"

namespace avo::inline certificate {

/// One wall near a robot, relative to p_A.
struct NearWall {
  Segment segment;
  double distance = 0.0;  ///< m, from p_A to the segment
  double held = 0.0;      ///< m, that the center keeps from the segment
  double margin = 0.0;    ///< m, what covers all rounding; 0 of a wall that braking comes too near
  /// Where A does not know exactly where it is: from the wall to where braking comes nearest, as A
  /// sees it, and most that this is off. A may go that way without knowing how near the wall is.
  Vec2 normal = {};
  double cone = 2.0;
};

/// What the walls demand of a robot. Scratch memory; allocates only while it grows.
struct WallConstraints {
  std::vector<NearWall> near;  ///< those that any candidate can come to touch
  Vec2 middle;                 ///< [s v] m, relative to p_A
  Vec2 stop;                   ///< m, likewise: where braking ends
  Vec2 backup;                 ///< m/s, the velocity after one step of braking
  Vec2 first;                  ///< m, relative to p_A: where that step leads
  Deepest broken = {};         ///< of the walls that braking touches
  bool doubtful = false;       ///< it touches one, or may do so, by where A may be
  bool must_brake = false;     ///< and takes the center across one: nothing but braking is admitted

  void clear() { near.clear(), broken = {}, doubtful = must_brake = false; }
};

/// m: S Δt + l(S), S the largest speed that it can have after this step. No candidate leads a robot
/// farther from its center, and no farther wall can ask it to slow down.
double wall_reach(double speed, double max_speed, const Ability& ability, const StepLaw& law);

/// What the margins of a robot beside all walls have in common.
struct WallRounding {
  double steps = 0.0;    ///< of braking from max_speed, and the one that is decided
  double lengths = 0.0;  ///< m, its radius and the way that these steps take
};
WallRounding wall_rounding(double radius, double max_speed, const Ability& ability,
                           const StepLaw& law);

/// [m] m, what covers all rounding of a robot beside a wall: the same in all its decisions.
double wall_margin(const Wall& wall, const WallRounding& rounding);

/// Those of the walls that are near. Walls out of reach change nothing.
void begin_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                 WallConstraints& constraints);

/// Whether the path keeps clear of all walls, or is braking.
bool keeps_walls(const WallConstraints& constraints, const CandidatePath& path, const StepLaw& law);

/// For every wall that refuses the path, a half-plane in v_1 that cuts the path's off.
void append_wall_cuts(const WallConstraints& constraints, const CandidatePath& path,
                      const StepLaw& law, std::vector<HalfPlane>& half_planes);

}  // namespace avo::inline certificate
