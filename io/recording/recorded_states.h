// SPDX-License-Identifier: Apache-2.0
// What a recording keeps of a simulation's state.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/check.h"
#include "avo/clearance.h"
#include "avo/simulation.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

/// The present state becomes one more time of the block, which has room for it.
void add_states(const avo::Simulation& simulation, const BlockShape& shape, RecordingBlock& block);
/// The rows of one of its times, of those who are there.
std::vector<avo::CheckedState> rows_of(const BlockShape& shape, const RecordingBlock& block,
                                       std::size_t time);
/// Of one of the times that are there.
void find_clearances(const BlockShape& shape, std::size_t time, avo::ClearanceFinder& clearances,
                     RecordingBlock& block);

}  // namespace avo_io
