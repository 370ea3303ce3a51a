// SPDX-License-Identifier: Apache-2.0
// The moving obstacles of a simulation, in columns.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo/trajectory.h"
#include "avo/wall.h"

namespace avo::inline sim {

/// Future places of moving obstacles with a path, for robots that know their paths. They follow
/// from the present places, the number of the step and the fleet.
struct Foresight {
  // by obstacle, empty where it has no path; no entries where no robot knows the paths
  std::vector<Trajectory> trajectory;
  double time_step = 0.0;          // s; the times count from the start of the run
  double horizon = 0.0;            // s, for which they last at least, before they repeat
  std::int64_t until = -1;         // step, until which they are valid
  std::vector<TimedPlace> places;  // scratch
};

/// All moving obstacles.
struct MoverColumns {
  std::vector<MovingObstacle> setup;
  std::vector<Vec2> position, velocity;
  std::vector<std::uint32_t> next_point;  // see PathWalk
  std::vector<MovingObstacleId> id;       // ascending
  std::uint64_t next_id = 0;
  std::int64_t steps = 0;  // of the run, where the clock is common
  bool has_paths = false;  // whether some have a path
  Foresight foresight;

  explicit MoverColumns(const std::vector<MovingObstacle>& obstacles);
  /// Adds one in that state. Call it on a copy: it may throw in the midst.
  void add(const MovingObstacle& obstacle, const PathWalk& start);
  void remove(std::size_t index);
  /// Throws Error if there is none.
  std::size_t find(MovingObstacleId obstacle) const;
  /// Some values follow from the setups: call it after a change.
  void look_over();
  Neighbor sensed(std::size_t index) const;
  /// The discs of the obstacles that are at rest, or nearly, and are not known to move again.
  std::vector<Wall> resting() const;
  /// Returns whether these discs are the present ones.
  bool rest_as(std::span<const Wall> discs) const;
  PathWalk walk(std::size_t index) const {
    return {position[index], velocity[index], next_point[index]};
  }
  /// Advances all by constant acceleration, exactly; along a path; or by trajectories at `time`, s,
  /// at the end.
  void advance(double time_step, double time);
};

}  // namespace avo::inline sim
