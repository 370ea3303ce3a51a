// SPDX-License-Identifier: Apache-2.0
// The state of a simulation in columns, one entry a robot.
#pragma once
#include <vector>

#include "avo/simulation.h"

namespace avo {

/// Everything that a step reads and writes. The `next_` columns are written while the others are
/// read: no robot ever sees a half-updated neighbor.
struct Fleet {
  std::vector<RobotId> id;  // ascending
  std::vector<RobotSetup> setup;
  std::vector<Vec2> goal;
  std::vector<Vec2> position, next_position;
  std::vector<Vec2> velocity, next_velocity;
  std::vector<double> heading, next_heading;
  std::vector<Detour> detour;
  std::vector<Plan> plan;
  std::vector<double> applied_acceleration;

  std::size_t size() const { return id.size(); }
  void add(RobotId robot, const RobotSetup& robot_setup);
  void remove(std::size_t index);
  /// The next generation becomes the present one.
  void swap_generations();
  /// Index of the robot; throws Error if there is none.
  std::size_t index_of(RobotId robot) const;
};

struct ObstacleColumns {
  std::vector<MovingObstacle> setup;
  std::vector<Vec2> position, velocity;

  void add(const MovingObstacle& obstacle);
  /// Constant acceleration, exactly.
  void advance(double time_step);
};

/// Order-dependent 64-bit hash of the bits of all positions, velocities and headings.
std::uint64_t hash_of(const Fleet& fleet, const ObstacleColumns& obstacles, std::int64_t steps);

}  // namespace avo
