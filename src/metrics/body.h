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
  Vec2 w;  // v' - v, m/s
  // whether Eqs. (8), (9) of the scene hold exactly, not only their interpolation
  bool exact = true;
  StepPath path;
  const RobotSetup* setup = nullptr;  // of a robot
  std::optional<ArcMotion> arc = {};  // of a body that turns, which `path` interpolates
};

/// The step from the last observation to the present one.
struct BodyStep {
  const LastSeen& last;
  double duration;  // s
  bool moves;       // false before the first step
  Method method;    // of robots that have none of their own
};

/// The index of a robot in the present columns and in those of the last observation, and the number
/// of a disc of it.
struct BodyRow {
  std::size_t now, before;
  int disc = 0;
};
/// The discs of the robots that are present before and after the step.
void collect_rows(const FleetView& fleet, const LastSeen& last, std::vector<BodyRow>& rows);
Body body_of(const FleetView& fleet, const BodyStep& step, BodyRow row);
void collect_robots(const FleetView& fleet, const BodyStep& step, std::span<const BodyRow> rows,
                    std::vector<Body>& robots);

/// The path of a disc; for most pairs of robots it shows that they do not meet.
struct Sweep {
  StepPath path;        // of its center
  double radius = 0.0;  // m
  bool turns = false;   // the path is an interpolation
};
Sweep sweep_of(const FleetView& fleet, const BodyStep& step, BodyRow row);

void collect_movers(const MovingObstacleView& now, const BodyStep& step,
                    std::vector<Body>& obstacles);

/// Least distance of the centers over the step; exact for held accelerations and straight lines,
/// and for arcs to 1e-8 m. If the distance is beyond the cutoff, any distance beyond the cutoff may
/// be returned.
judge::Instant separation_of(const Body& a, const Body& b, double step, double cutoff);

/// An upper bound of the displacement of the body in the step, m.
inline double path_length(const StepPath& path) {
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    squared = std::max(squared, norm_squared(path.control[k + 1] - path.control[k]));
  return 3.0 * std::sqrt(squared);
}
inline double path_length(const Body& body) {
  return path_length(body.path);
}

}  // namespace avo::inline metrics
