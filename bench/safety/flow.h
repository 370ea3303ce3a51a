// SPDX-License-Identifier: Apache-2.0
// Flows that never end: how fast robots get on where nobody ever arrives for good.
#pragma once
#include <cstdint>

#include "run.h"

namespace avo::safety {

inline constexpr double kFlowSide = 30.0;  ///< m, of the square

/// 100 robots at rest anywhere in the square, who prefer 2 m/s.
Scene flow_scene(Flow flow, std::uint64_t seed);

/// The torus in a loop around Planner::plan, in which robots sense each other across the seam; to
/// and fro by the library's simulation, where a robot has reached its waypoint once it stands
/// within 1 m of it, as in the simulators that others measure with. Outcome::flow is the mean
/// velocity towards where a robot wants to go over the preferred speed; a robot within 1 m of its
/// waypoint counts as 0.
void run_flow(const Scene& scene, const std::string& record, Outcome& outcome);

}  // namespace avo::safety
