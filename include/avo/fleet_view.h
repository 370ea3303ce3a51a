// SPDX-License-Identifier: Apache-2.0
// What a simulation shows of its robots and obstacles.
#pragma once
#include <cstdint>
#include <span>

#include "avo/ids.h"
#include "avo/plan.h"
#include "avo/scenario.h"
#include "avo/vec.h"

namespace avo {

/// Columns of a FleetView. Each costs a copy of the fleet's, once a generation.
enum class Columns : std::uint16_t {
  id = 1,
  position = 2,
  velocity = 4,
  heading = 8,
  goal = 16,
  setup = 32,
  detour = 64,
  plan = 128,
  applied_acceleration = 256,
  all = 511,
};
/// The columns of both.
constexpr Columns operator|(Columns a, Columns b) {
  return static_cast<Columns>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Returns whether each of `some` is one of `all`.
constexpr bool includes(Columns all, Columns some) {
  return (static_cast<unsigned>(some) & ~static_cast<unsigned>(all)) == 0;
}

/// Columns of the present generation, one entry a robot, by ascending id. Valid until the next
/// call that changes the simulation.
struct FleetView {
  std::span<const RobotId> id;
  // Where Scenario::execution is set, both are of the bodies. Detours, plans and accelerations are
  // of the references, and so are places in queries.
  std::span<const Vec2> position;     ///< m
  std::span<const Vec2> velocity;     ///< m/s
  std::span<const double> heading;    ///< rad; for cars, 0 for others
  std::span<const Vec2> goal;         ///< m
  std::span<const RobotSetup> setup;  ///< the constant part (radius, limits, car)
  std::span<const Detour> detour;     ///< what each remembers; method avo only
  std::span<const Plan> plan;         ///< of its last decision; value-initialized before the first
  /// m/s^2, the largest |a| within the last step. For a car with the exact set it is the larger
  /// component, along the heading or across.
  std::span<const double> applied_acceleration;
};

/// One robot's entries in the columns that steps change.
struct RobotState {
  RobotId id;
  Vec2 position, velocity;            ///< m, m/s
  double heading = 0.0;               ///< rad; for cars, 0 for others
  Vec2 goal;                          ///< m
  Detour detour;                      ///< see FleetView
  Plan plan;                          ///< see FleetView
  double applied_acceleration = 0.0;  ///< m/s^2, see FleetView
};

/// Columns of the moving obstacles, by ascending id. They are valid as long as a FleetView.
struct MovingObstacleView {
  std::span<const Vec2> position;
  std::span<const Vec2> velocity;
  std::span<const MovingObstacle> setup;
  std::span<const std::uint32_t> next_point;  ///< position in its path of the point it moves to
  std::span<const MovingObstacleId> id;
};

/// Columns of the static obstacles, by ascending id. Valid until the next call that changes the
/// simulation.
struct StaticObstacleView {
  std::span<const ObstacleId> id;
  std::span<const StaticObstacle> setup;
};

}  // namespace avo
