// SPDX-License-Identifier: Apache-2.0
// A method of the caller's own, which chooses for all its robots at once (docs/own_method.md). SI
// units.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/robot.h"
#include "avo/wall.h"

namespace avo {

/// What the robots of an external method know when they decide, by ascending id. Valid during the
/// call.
struct MethodBatch {
  double time = 0.0, time_step = 0.0;  ///< s: now, and until they decide again
  std::span<const RobotId> id;
  /// Their states and limits. The preferred velocity leads to the goal, around walls where the
  /// scene has navigation.
  std::span<const Robot> robot;
  std::span<const Vec2> goal;  ///< m
  /// Robot i senses neighbor[first_neighbor[i]] up to before neighbor[first_neighbor[i + 1]],
  /// nearest first. So it is for walls, which come in no order.
  std::span<const std::size_t> first_neighbor, first_wall;
  std::span<const Neighbor> neighbor;
  std::span<const Wall> wall;

  [[nodiscard]] std::size_t size() const { return id.size(); }
  [[nodiscard]] std::span<const Neighbor> neighbors_of(std::size_t i) const {
    return neighbor.subspan(first_neighbor[i], first_neighbor[i + 1] - first_neighbor[i]);
  }
  [[nodiscard]] std::span<const Wall> walls_of(std::size_t i) const {
    return wall.subspan(first_wall[i], first_wall[i + 1] - first_wall[i]);
  }
};

/// Chooses a velocity for each robot of the batch, m/s. The velocities are the preferred ones
/// before the call. The thread that steps calls it once in a step. A run is repeatable where the
/// function is: it must not depend on clocks, threads or calls of other simulations.
using ExternalMethod = std::function<void(const MethodBatch& batch, std::span<Vec2> velocities)>;

/// A batch in arrays of one kind of value each, for functions in other languages. The arrays of
/// MethodBatch that have no entry here are such arrays already.
struct MethodColumns {
  std::vector<std::uint64_t> id;
  std::vector<Vec2> position, velocity, preferred_velocity;  ///< m, m/s
  /// m, m/s, m/s^2, m/s^2, rad
  std::vector<double> radius, max_speed, max_acceleration, max_braking, heading;
  std::vector<Vec2> neighbor_position, neighbor_velocity;
  /// m/s^2: 0 of a neighbor that moves on
  std::vector<double> neighbor_radius, neighbor_max_acceleration;
  std::vector<std::uint8_t> neighbor_behavior;  ///< values of Behavior
  std::vector<Vec2> wall_a, wall_b;             ///< m, the ends
  std::vector<double> wall_radius;

  /// Takes the values of the batch in place of the present ones.
  AVO_API void take(const MethodBatch& batch);
};

/// A method that chooses accelerations, m/s^2: they are 0 before the call, and hold for a step.
AVO_API ExternalMethod by_acceleration(ExternalMethod method);

}  // namespace avo
