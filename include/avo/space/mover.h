// SPDX-License-Identifier: Apache-2.0
// Moving obstacles of space: they decide nothing (docs/space.md, "Moving obstacles"). SI units.
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "avo/export.h"
#include "avo/vec3.h"

namespace avo::space {

/// A moving obstacle as a robot senses it.
struct Mover {
  Vec3 position = {};          ///< m, the center of its ball
  Vec3 velocity = {};          ///< m/s
  Vec3 acceleration = {};      ///< m/s^2, which it keeps up to max_deviation; 0 with max_speed
  double radius = 0.5;         ///< m, > 0
  double max_deviation = 0.0;  ///< [η] m/s^2, >= 0: the largest difference of its acceleration
  /// [V] m/s, > 0, with max_deviation: a speed that it never exceeds
  double max_speed = std::numeric_limits<double>::infinity();
  /// [d] whole steps, 0 to kMostAge: the time since it was last sensed; extrapolated since then by
  /// its acceleration
  int age = 0;
};

/// Where a moving obstacle is at a time.
struct TimedPoint {
  double time = 0.0;   ///< s
  Vec3 position = {};  ///< m
  friend bool operator==(const TimedPoint&, const TimedPoint&) = default;
};

/// A moving obstacle as a scene lists it.
struct MovingObstacle {
  Vec3 position = {};                    ///< m, at 0 s, or when it comes while a run goes on
  Vec3 velocity = {};                    ///< m/s, as in MovingObstacle
  Vec3 acceleration = {};                ///< m/s^2, constant
  double radius = 0.5;                   ///< m, > 0
  double max_deviation = 0.0;            ///< m/s^2, >= 0, that robots allow for
  std::optional<double> max_speed = {};  ///< m/s, > 0, with max_deviation: that robots count on
  /// By ascending times: it moves straight and evenly from each of these places to the next. Before
  /// the first time and after the last one it rests there. Empty: it keeps its acceleration.
  std::vector<TimedPoint> trajectory = {};

  friend bool operator==(const MovingObstacle&, const MovingObstacle&) = default;
};

/// The place and the velocity of a moving obstacle at the end of a step.
struct MoverState {
  Vec3 position, velocity;  ///< m, m/s
};
/// time: s, on its own clock: that of the run on a trajectory, else since it had the position and
/// the velocity given. On a trajectory the velocity is the one with which it goes on.
AVO_API MoverState state_at(const MovingObstacle& obstacle, double time);

/// The moving obstacle as a robot senses it exactly at that time, s, on its own clock.
AVO_API Mover mover_at(const MovingObstacle& obstacle, double time);

}  // namespace avo::space
