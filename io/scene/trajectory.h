// SPDX-License-Identifier: Apache-2.0
// The places of a moving obstacle by their times, as CSV.
#pragma once
#include <vector>

#include "avo/scenario.h"
#include "io/text/source_text.h"

namespace avo_io {

/// A line of time, x, y (s, m, m) for each place, times ascending; a line of the names time, x, y
/// may be in front. Throws SceneError.
std::vector<avo::TimedPlace> read_trajectory(const SourceText& source);

}  // namespace avo_io
