// SPDX-License-Identifier: Apache-2.0
// S3, braking trajectories: each robot keeps, interval by interval, to its own side of a line that
// both robots of a pair derive from the paths on which they would brake now (docs/certificate.md).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "certificate/braking_path.h"

namespace avo {

/// What one neighbor demands on one interval between steps: normal . y_i + offset[i] >= 0 for the
/// Bézier points y_0, y_1, y_2 of A's path on it, relative to p_A.
struct TrajectoryWall {
  int neighbor = 0;
  int interval = 0;               ///< 0: the step to be decided
  bool only_in_motion = false;    ///< asked only of paths on which A has not come to rest before
  Vec2 normal;                    ///< unit, from B to A
  std::array<double, 3> offset{};  ///< m
};

/// All that the certificate asks of one robot. Scratch memory; allocates only while it grows.
struct TrajectoryWalls {
  std::vector<TrajectoryWall> walls;
  int intervals = 1;   ///< for which a candidate's path has to be known
  double slack = 0.0;  ///< m: least distance of braking paths beyond contact; infinite if all far
  int broken = -1;     ///< a neighbor with which braking collides, or -1
  bool touched = false;  ///< one that does not decide is in contact: only braking is admitted
  BrakingDistances braking, neighbor_braking;
};

/// A's path for a candidate: v_1 after one step, then braking. Relative to p_A.
struct CandidatePath {
  Vec2 first;      ///< m, end of the first step
  Vec2 direction;  ///< of v_1; 0 at rest
  double speed = 0.0;
  int moving = 0;  ///< intervals until rest
  BrakingDistances braking;
};

/// Collects the walls that can refuse a candidate with |v_1 - v| <= u. A neighbor with
/// max_acceleration 0 does not decide: it is taken to keep its acceleration, A's share is 1, and
/// only the time counts in which A moves. A pair that collides though both brake is held to the
/// distance that braking keeps.
void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors, const StepLaw& law,
                   TrajectoryWalls& walls);

void follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law, int intervals,
            CandidatePath& path);

/// The wall that the path violates most, or that it is nearest to.
struct WorstWall {
  double coefficient;  ///< m, >= 0 iff the candidate is admitted; infinite without walls
  int wall = -1;
  int point = 0;  ///< of the three
};
WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path);
/// Of walls[first .. last) only.
WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path, std::size_t first,
                     std::size_t last);

/// The wall's half-plane in v_1, as the tangent at the path: where the path violates it, so does
/// the path's v_1.
HalfPlane tangent(const TrajectoryWall& wall, int point, const CandidatePath& path,
                  const Robot& robot, const StepLaw& law);

}  // namespace avo
