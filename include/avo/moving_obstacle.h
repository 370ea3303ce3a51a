// SPDX-License-Identifier: Apache-2.0
// Discs that react to no robot, and where they are. SI units.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "avo/export.h"
#include "avo/trajectory.h"
#include "avo/vec.h"

namespace avo {

/// A disc that reacts to no robot. It moves with constant acceleration, along a path, or as a
/// trajectory says.
struct MovingObstacle {
  Vec2 position = {};      ///< m
  Vec2 velocity = {};      ///< m/s
  Vec2 acceleration = {};  ///< m/s^2; 0 with max_speed
  double radius = 0.5;     ///< m, > 0
  /// m/s^2, >= 0: robots allow for its acceleration to differ that much from `acceleration`, at any
  /// time.
  double max_deviation = 0.0;
  /// m/s, > 0, with max_deviation: a speed that it never exceeds
  std::optional<double> max_speed = {};
  /// m: it moves to these points in turn, and then to the first again, see next_on_path(). A path
  /// needs max_deviation and max_speed; empty: no path. Robots that sense exactly and decide at the
  /// same times know where it will be.
  std::vector<Vec2> path = {};
  /// By ascending times: it moves straight and evenly from each of these places to the next. Before
  /// the first time and after the last one it stands there. Its position and velocity must be those
  /// at 0 s, see start_on_trajectory(). It then has no acceleration and no path. Empty: no
  /// trajectory.
  std::vector<TimedPlace> trajectory = {};
};

/// Where a moving obstacle is on its path at the beginning of a step.
struct PathWalk {
  Vec2 position, velocity;       ///< m, m/s
  std::uint32_t next_point = 0;  ///< position in its path of the point that it moves to
};
/// Returns the walk one step later. The acceleration is held over the step and is within
/// max_deviation. It moves straight to that point, as fast as max_speed and stopping there allow.
/// It has reached a point when its disc covers the point.
AVO_API PathWalk next_on_path(const MovingObstacle& obstacle, const PathWalk& walk,
                              double time_step);

/// Returns its place on its trajectory at a time, and the velocity with which it goes on. The time
/// is the end of a step: within a step it moves straight from one place to the other. next_point:
/// the position of the place that it moves to.
AVO_API PathWalk on_trajectory(const MovingObstacle& obstacle, double time);
/// Sets its state to that of its trajectory at 0 s, if it has one.
AVO_API void start_on_trajectory(MovingObstacle& obstacle);

}  // namespace avo
