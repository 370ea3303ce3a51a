// SPDX-License-Identifier: Apache-2.0
// Flows that never end: the progress of robots that never arrive for good.
#pragma once
#include <cstdint>

#include "run.h"

namespace avo::safety {

inline constexpr double kFlowSide = 30.0;  ///< m, of the square

/// Returns 100 robots at rest at random places in the square, with preferred speed 2 m/s.
Scene flow_scene(Flow flow, std::uint64_t seed);

/// Runs a flow. The torus runs in a loop around Planner::plan, in which robots sense each other
/// across the seam. To and fro runs in the library's simulation. There, a robot has reached its
/// waypoint once it stands within 1 m of it, as in the simulators of other measurements.
/// Outcome::flow is the mean velocity towards a robot's waypoint over the preferred speed. A robot
/// within 1 m of its waypoint counts as 0.
void run_flow(const Scene& scene, const std::string& record, Outcome& outcome);

}  // namespace avo::safety
