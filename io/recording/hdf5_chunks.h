// SPDX-License-Identifier: Apache-2.0
// Chunks that a file may have forged.
#pragma once
#include <hdf5.h>
#include <vector>

namespace avo_io {

/// Whether the rows of a chunked table that are asked for can be read: their chunks lie in the file
/// shuffled or deflated at most, and are as long as the table says. HDF5 does not look at how many
/// bytes a chunk has once it is inflated, and reads on behind one that is too short. True of a
/// table that has no chunks.
bool are_chunks_whole(hid_t table, const std::vector<hsize_t>& offset,
                      const std::vector<hsize_t>& count);

}  // namespace avo_io
