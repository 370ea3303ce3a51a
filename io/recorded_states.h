// SPDX-License-Identifier: Apache-2.0
// What a recording keeps of a simulation's state.
#pragma once
#include <cstddef>

#include "avo/clearance.h"
#include "avo/simulation.h"
#include "recording_blocks.h"

namespace avo_io {

/// The present state becomes one more time of the block, which has room for it.
void add_states(const avo::Simulation& simulation, const BlockShape& shape, RecordingBlock& block);
/// Of one of the times that are there.
void find_clearances(const BlockShape& shape, std::size_t time, avo::ClearanceFinder& clearances,
                     RecordingBlock& block);

}  // namespace avo_io
