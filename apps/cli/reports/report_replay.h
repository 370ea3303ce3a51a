// SPDX-License-Identifier: Apache-2.0
// A recording as a drawing that the page animates.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "avo/space/scenario.h"
#include "avo_io/recorded_run.h"
#include "figures/space_views.h"

namespace avo_cli {

/// Returns the number of frames with so many robots that a page holds.
std::size_t most_frames(std::int64_t robots);

/// Returns a run in space as one of the plane, with the elevation beside the plan.
avo_io::RecordedRun run_in_plane(const avo::space::Scenario& scenario,
                                 const std::vector<avo::figures::SpaceRecorder::Frame>& frames);

/// Returns an SVG of the walls, goals and bodies, with a circle for each body. views: the robots
/// are there so many times, one view after the other.
std::string drawing_of(const avo_io::RecordedRun& run, std::size_t views = 1);
/// Returns the script's data: an object of times, the box and the positions.
std::string data_of(const avo_io::RecordedRun& run);

}  // namespace avo_cli
