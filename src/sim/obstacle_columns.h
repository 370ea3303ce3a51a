// SPDX-License-Identifier: Apache-2.0
// The moving obstacles of a simulation, in columns.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "avo/scenario.h"
#include "avo/trajectory.h"
#include "avo/wall.h"

namespace avo::inline sim {

/// Where moving obstacles with a path will be, for robots that know their paths. All of it follows
/// from where they are, the number of the step and the fleet.
struct Foresight {
  // by obstacle, of nobody where it has no path; empty where nobody knows
  std::vector<Trajectory> trajectory;
  double time_step = 0.0;          // s; their times begin with the run
  double horizon = 0.0;            // s, for which they last at least, before they go round
  std::int64_t until = -1;         // step, until which they do
  std::vector<TimedPlace> places;  // scratch
};

/// All moving obstacles.
struct ObstacleColumns {
  std::vector<MovingObstacle> setup;
  std::vector<Vec2> position, velocity;
  std::vector<std::uint32_t> target;  // see PathWalk
  std::int64_t steps = 0;             // of the run, where the clock is common
  bool has_paths = false;             // some have one
  Foresight foresight;

  explicit ObstacleColumns(const std::vector<MovingObstacle>& obstacles);
  Neighbor sensed(std::size_t index) const;
  /// The discs of those that are at rest, or nearly, and stay so as far as anybody knows.
  std::vector<Wall> resting() const;
  /// Whether those are they.
  bool rest_as(std::span<const Wall> discs) const;
  PathWalk walk(std::size_t index) const {
    return {position[index], velocity[index], target[index]};
  }
  /// Constant acceleration, exactly; along a path; or as trajectories say of `time`, s, at the end.
  void advance(double time_step, double time);
};

}  // namespace avo::inline sim
