// SPDX-License-Identifier: Apache-2.0
// Reads the places of a moving obstacle by their times, as CSV.
#pragma once
#include <vector>

#include "avo/scenario.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Reads a line of time, x, y (s, m, m) for each place, with ascending times. The first line may
/// have the names time, x, y. Throws SceneError.
std::vector<avo::TimedPlace> read_trajectory(const SourceText& source);

}  // namespace avo_io
