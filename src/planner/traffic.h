// SPDX-License-Identifier: Apache-2.0
// What the rules for arriving see of a robot's neighbors (docs/arrival.md).
#pragma once
#include "avo/robot.h"
#include "core/neighbor_columns.h"

namespace avo {

/// The clearance that is nearly contact, of r_A + r_B.
inline constexpr double kRoom = 0.25;

/// What counts as traffic.
struct TrafficLimits {
  double range;  ///< m
  double slow;   ///< m/s, nearly at rest
};

struct Traffic {
  /// Robots ahead within the range that close in or are nearly at rest, weighted by how near they
  /// are.
  double ahead = 0.0;
  /// Away from those that are nearly in contact.
  Vec2 push;
};

Traffic look_around(const Robot& robot, const Neighbors& neighbors, const TrafficLimits& limits);

}  // namespace avo
