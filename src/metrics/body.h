// SPDX-License-Identifier: Apache-2.0
// A robot or a moving obstacle over one step.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "metrics/not_arrived.h"
#include "metrics/separation.h"

namespace avo::inline metrics {

struct Body {
  std::uint64_t name = 0;  // id of a robot, index of an obstacle
  double radius = 0.0;
  Vec2 position, velocity;
  Vec2 w;             // v' - v, m/s
  bool exact = true;  // the scene's Eqs. (8), (9) hold, not only their interpolation
  StepPath path;
  const RobotSetup* setup = nullptr;  // of a robot
  std::optional<ArcMotion> arc = {};  // of one that turns, which `path` interpolates
};

/// Between what was seen last and now.
struct BodyStep {
  const LastSeen& last;
  double duration;  // s
  bool moves;       // false before the first step
  Method method;    // of robots that have none of their own
};

/// Where a robot is in the columns of now and of what was seen last.
struct BodyRow {
  std::size_t now, before;
};
/// The robots that were there before the step and are there after it.
void collect_rows(const FleetView& fleet, const LastSeen& last, std::vector<BodyRow>& rows);
Body body_of(const FleetView& fleet, const BodyStep& step, BodyRow row);
void collect_robots(const FleetView& fleet, const BodyStep& step, std::span<const BodyRow> rows,
                    std::vector<Body>& robots);

/// The way of a disc, which tells of most robots that they do not meet.
struct Sweep {
  StepPath path;        // of its center
  double radius = 0.0;  // m
  bool turns = false;   // the path is an interpolation
};
Sweep sweep_of(const FleetView& fleet, const BodyStep& step, BodyRow row);

void collect_obstacles(const ObstacleView& now, const BodyStep& step, std::vector<Body>& obstacles);

/// Least distance of the centers over the step; exact for held accelerations and straight lines,
/// and of arcs to 1e-8 m. A distance beyond the cutoff may be any that is beyond it as well.
Separation separation_of(const Body& a, const Body& b, double step, double cutoff);

/// Bounds how far the body goes in the step, m.
inline double way_of(const StepPath& path) {
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    squared = std::max(squared, norm_squared(path.control[k + 1] - path.control[k]));
  return 3.0 * std::sqrt(squared);
}
inline double way_of(const Body& body) {
  return way_of(body.path);
}

}  // namespace avo::inline metrics
