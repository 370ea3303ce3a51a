// SPDX-License-Identifier: Apache-2.0
// S3, braking trajectories: each robot keeps, interval by interval, to its own side of a line that
// both robots of a pair derive from the paths on which they would brake now (docs/certificate.md).
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"

namespace avo {

/// What one neighbor demands on one interval between steps: normal . y_i + offset[i] >= 0 for the
/// Bézier points y_0, y_1, y_2 of A's path on it, relative to p_A.
struct TrajectoryWall {
  int neighbor = 0;
  int interval = 0;                ///< 0: the step to be decided
  bool only_in_motion = false;     ///< asked only of paths on which A still moves then
  Vec2 normal;                     ///< unit, from B to A
  std::array<double, 3> offset{};  ///< m
  /// With sensing errors the normal is off by so much: cone |y_i - x_i| is asked for besides, x
  /// being A's braking path.
  double cone = 0.0;
  /// m, <= 0: a path that keeps normal . (y - x) >= bound, x the braking path, keeps the wall.
  double bound = 0.0;
};

/// Whose walls are wanted.
enum class Whom : unsigned char { everyone, movers };

/// Scratch memory; allocates only while it grows.
struct TrajectoryWalls {
  std::vector<TrajectoryWall> walls;  ///< a neighbor's follow each other
  int intervals = 0;                  ///< of a candidate's braking that have to be known
  Vec2 direction;                     ///< of A's braking
  BrakingDistances braking, neighbor_braking;
};

/// Collects the walls that can refuse a candidate with |v_1 - v| <= u. A neighbor with
/// max_acceleration 0 does not decide: it is taken to keep its acceleration, A's share is 1, and
/// only the time counts in which A moves.
void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors, Whom whom,
                   const StepLaw& law, TrajectoryWalls& walls, Invariant& invariant);

/// The wall that the path violates most, or that it is nearest to.
struct WorstWall {
  double coefficient;  ///< m, >= 0 iff the candidate is admitted; infinite without walls
  const TrajectoryWall* wall = nullptr;
  int point = 0;   ///< of the three
  Vec2 lean = {};  ///< what a cone takes off the normal there
};
WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path);
/// Of walls.walls[first .. last) only.
WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path, std::size_t first,
                     std::size_t last);

/// The wall's half-plane in v_1, tangent at the path: v_1 of a path that violates it lies outside.
HalfPlane tangent(const WorstWall& worst, const CandidatePath& path, const Robot& robot,
                  const StepLaw& law);

}  // namespace avo
