// SPDX-License-Identifier: Apache-2.0
// The blocks of a recording, of an HDF5 file or of a spool.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "avo/scenario.h"
#include "avo/space/scenario.h"
#include "io/recording/block_checks.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/recording_blocks.h"
#include "io/recording/spool.h"

namespace avo_io {

class BlockSource {
 public:
  /// Throws FileError and RecordingError; the latter also if the file is in neither format.
  explicit BlockSource(const std::string& path);

  [[nodiscard]] const RecordingHeader& header() const;
  [[nodiscard]] const BlockShape& shape() const;
  /// Returns the scene that the recording contains, see own_scene().
  const avo::Scenario& scenario();
  /// Returns that of a recording of space, see own_scene_of_space().
  const avo::space::Scenario& scenario_of_space();
  /// Reads the next block; returns false at the end. Throws RecordingError, also for rows that no
  /// run records (block_checks.h).
  bool next();
  /// Returns the block that next() has read.
  [[nodiscard]] const RecordingBlock& block() const { return *block_; }

 private:
  [[noreturn]] void refuse_block() const;
  bool read_block();
  [[nodiscard]] double end_of_scene();

  std::string path_;
  std::optional<Hdf5Reader> hdf5_;
  std::optional<SpoolReader> spool_;
  std::optional<BlockCodec> codec_;  // of a spool
  CompressedBlock compressed_;
  bool begun_ = false;  // whether the first block of the spool has been used
  std::optional<avo::Scenario> scenario_;
  std::optional<avo::space::Scenario> scenario_of_space_;
  std::optional<BlockChecks> checks_;
  std::optional<RecordingBlock> block_;
};

}  // namespace avo_io
