// SPDX-License-Identifier: Apache-2.0
// The part of a simulation's state that a recording keeps.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/check.h"
#include "avo/clearance.h"
#include "avo/simulation.h"
#include "avo_io/recording.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

/// Appends the present state to the block as one more time; the block must have room for it.
void add_states(const avo::Simulation& simulation, const BlockShape& shape, RecordingBlock& block);
/// Does the same for rows of any origin.
void add_rows(const RecordedTime& moment, const BlockShape& shape, RecordingBlock& block);
/// Returns the rows of the present robots at one of its times.
std::vector<avo::CheckedState> rows_of(const BlockShape& shape, const RecordingBlock& block,
                                       std::size_t time);
/// Finds the clearances at one of the times in the block.
void find_clearances(const BlockShape& shape, std::size_t time, avo::ClearanceFinder& clearances,
                     RecordingBlock& block);

}  // namespace avo_io
