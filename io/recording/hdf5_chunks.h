// SPDX-License-Identifier: Apache-2.0
// Checks of chunks, against files that are forged.
#pragma once
#include <hdf5.h>
#include <vector>

namespace avo_io {

/// Returns whether the requested rows of a chunked table can be read. Their chunks must lie in the
/// file, at most shuffled and deflated, and must be as long as the table says. HDF5 does not check
/// the length of an inflated chunk, and reads beyond the end of a chunk that is too short. Returns
/// true for a table without chunks.
bool are_chunks_whole(hid_t table, const std::vector<hsize_t>& offset,
                      const std::vector<hsize_t>& count);

}  // namespace avo_io
