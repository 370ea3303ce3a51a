// SPDX-License-Identifier: Apache-2.0
// A recording as a drawing that the page animates.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "avo_io/recorded_run.h"

namespace avo_cli {

/// Returns the number of frames with so many robots that a page holds.
std::size_t most_frames(std::int64_t robots);

/// Returns an SVG of the walls, goals and bodies, with a circle for each body. views: the robots
/// are there so many times, one view after the other.
std::string drawing_of(const avo_io::RecordedRun& run, std::size_t views = 1);
/// Returns the script's data: an object of times, the box and the positions.
std::string data_of(const avo_io::RecordedRun& run);

}  // namespace avo_cli
