// SPDX-License-Identifier: Apache-2.0
// The robots that have not arrived, and the robots that block them.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/metrics.h"

namespace avo::inline metrics {

/// A fleet as last seen, by ascending id, and the moving obstacles then.
struct LastSeen {
  struct LastRobot {
    RobotId id;
    Vec2 position, velocity, goal;
    double heading = 0.0;  // rad, of a robot that has one
    double detour = 0.0;   // rad
    PlanStatus status = PlanStatus::optimal;
  };
  std::vector<LastRobot> robots;
  std::vector<Simulation::Wait> wait;  // of robots at rest that wait
  std::vector<std::size_t> waiting;    // indices of these robots, ascending
  struct LastMover {
    std::uint64_t id;
    Vec2 position, velocity;
    double radius;
  };
  std::vector<LastMover> movers;

  void look_at(const Simulation& simulation, const FleetView& fleet);
  /// setups: of the robots last seen.
  [[nodiscard]] NotArrived describe(std::size_t robot, std::span<const RobotSetup> setups) const;
};

}  // namespace avo::inline metrics
