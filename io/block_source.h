// SPDX-License-Identifier: Apache-2.0
// The blocks of a recording, of an HDF5 file or of a spool.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "hdf5_recording.h"
#include "recording_blocks.h"
#include "spool.h"

namespace avo_io {

class BlockSource {
 public:
  /// Throws FileError and RecordingError, also where it is neither.
  explicit BlockSource(const std::string& path);

  [[nodiscard]] const RecordingHeader& header() const;
  [[nodiscard]] const BlockShape& shape() const;
  /// False at the end. Throws RecordingError.
  bool next();
  /// The block that next() has read.
  [[nodiscard]] const RecordingBlock& block() const { return *block_; }

 private:
  std::string path_;
  std::optional<Hdf5Reader> hdf5_;
  std::optional<SpoolReader> spool_;
  std::optional<BlockCodec> codec_;  // of a spool
  CompressedBlock compressed_;
  std::optional<RecordingBlock> block_;
};

}  // namespace avo_io
