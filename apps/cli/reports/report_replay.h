// SPDX-License-Identifier: Apache-2.0
// A recording as a drawing that a page sets in motion.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "avo_io/recorded_run.h"

namespace avo_cli {

/// How many frames of so many robots a page holds.
std::size_t most_frames(std::int64_t robots);

/// An SVG of the walls, goals and bodies, a circle each.
std::string drawing_of(const avo_io::RecordedRun& run);
/// The script's data: an object of times, the box and the positions.
std::string data_of(const avo_io::RecordedRun& run);

}  // namespace avo_cli
