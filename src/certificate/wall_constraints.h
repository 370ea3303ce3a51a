// SPDX-License-Identifier: Apache-2.0
// Walls: neither the step of the decision nor the braking after it may come within a robot's radius
// of a wall (docs/certificate/walls.md).
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
  double held = 0.0;      ///< m, that the center must keep from the segment
  /// m, a margin for all rounding; 0 for a wall that braking comes too near
  double margin = 0.0;
  /// Used where A does not know exactly where it is. The normal points from the wall to the nearest
  /// point of braking, as A sees it; the cone is the largest error of this direction. A may move in
  /// this direction without knowing how near the wall is.
  Vec2 normal = {};
  double cone = 2.0;
  int index = 0;  ///< among the walls given
};

/// The demands of the walls on a robot. Scratch memory; allocates only while it grows.
struct WallConstraints {
  std::vector<NearWall> near;  ///< walls that a candidate can touch
  Vec2 middle;                 ///< [s v] m, relative to p_A
  Vec2 stop;                   ///< m, relative to p_A: where braking ends
  Vec2 backup;                 ///< m/s, the velocity after one step of braking
  Vec2 first;                  ///< m, relative to p_A: the end of that step
  Deepest broken = {};         ///< the deepest of the walls that braking touches
  /// braking touches a wall, or may touch one because of the error of A's place
  bool doubtful = false;
  /// braking takes the center across a wall: nothing but braking is admitted
  bool must_brake = false;

  void clear() { near.clear(), broken = {}, doubtful = must_brake = false; }
};

/// m: S Δt + l(S), S the largest speed of the robot after this step. No candidate leads a robot
/// farther from its center, and no farther wall can ask it to slow down.
double wall_reach(double speed, double max_speed, const Ability& ability, const StepLaw& law);

/// The common part of a robot's margins beside all walls.
struct WallRounding {
  double steps = 0.0;    ///< of braking from max_speed, and the step of the decision
  double lengths = 0.0;  ///< m, its radius and the distance of these steps
};
WallRounding wall_rounding(double radius, double max_speed, const Ability& ability,
                           const StepLaw& law);

/// [m] m, covers all rounding of a robot beside a wall: the same in all its decisions.
double wall_margin(const Wall& wall, const WallRounding& rounding);

/// The additional room of a disc that turns with its robot.
struct DiscRoom {
  double reach = 0.0;    ///< m, how much farther it may get
  double lengths = 0.0;  ///< m, for the rounding of its place
};

/// Begins the constraints of the walls that are near. Walls out of reach change nothing.
void begin_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                 WallConstraints& constraints, const DiscRoom& room = {});

/// Returns whether the path keeps clear of all walls, or is braking.
bool keeps_walls(const WallConstraints& constraints, const CandidatePath& path, const StepLaw& law);

/// Returns the indices of the walls that refuse the path, for reports.
std::vector<int> refusing_walls(const WallConstraints& constraints, const CandidatePath& path,
                                const StepLaw& law);

/// Appends for every wall that refuses the path a half-plane in v_1 that excludes the path's v_1.
void append_wall_cuts(const WallConstraints& constraints, const CandidatePath& path,
                      const StepLaw& law, std::vector<HalfPlane>& half_planes);

}  // namespace avo::inline certificate
