// SPDX-License-Identifier: Apache-2.0
// Tables of sweeps in HDF5 files.
#pragma once
#include <string>

#include "avo_io/sweep.h"

namespace avo_io {

/// Reads the group "runs". Throws FileError and RecordingError.
SweepTable read_sweep_hdf5(const std::string& path);

}  // namespace avo_io
