// SPDX-License-Identifier: Apache-2.0
// Flows that never end: how fast robots get on where nobody ever arrives for good.
#pragma once
#include <cstdint>

#include "run.h"

namespace avo::safety {

inline constexpr double kFlowSide = 30.0;  ///< m, of the square

/// 100 robots at rest anywhere in the square, who prefer 2 m/s.
Scene flow_scene(Flow flow, std::uint64_t seed);

/// The scene in a loop around Planner::plan, in which robots sense each other across the seam.
/// Outcome::flow is the mean velocity towards where a robot wants to go over the preferred speed,
/// after the first minute.
void run_flow(const Scene& scene, const std::string& record, Outcome& outcome);

}  // namespace avo::safety
