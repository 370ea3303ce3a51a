// SPDX-License-Identifier: Apache-2.0
// A recorded run as curves over time, s, and as frames of figures.
#pragma once
#include <vector>

#include "avo/vec.h"
#include "avo_io/recorded_run.h"
#include "figures/trajectories.h"

namespace avo_cli {

/// Returns as many points as a figure can show, and the last point.
std::vector<avo::Vec2> thinned(const std::vector<avo::Vec2>& points);

// Curves end where no robot moves any more.
/// % of the robots that are not parked
std::vector<avo::Vec2> arrivals_of(const avo_io::RecordedRun& run);
/// m, the least clearance of two robots; thinned to the lowest value of every n times.
std::vector<avo::Vec2> clearances_of(const avo_io::RecordedRun& run);
std::vector<avo::Vec2> top_speeds_of(const avo_io::RecordedRun& run);  ///< m/s

std::vector<avo::figures::TrajectoryFrame> frames_of(const avo_io::RecordedRun& run);

}  // namespace avo_cli
