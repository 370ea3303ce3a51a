// SPDX-License-Identifier: Apache-2.0
// Recordings of space as HDF5: what a run, a replay and rows of another program share.
#pragma once
#include <string>
#include <string_view>

#include "avo_io/space.h"
#include "io/recording/block_recorder.h"
#include "io/space/space_clearances.h"
#include "io/space/space_rows.h"

namespace avo_io {

/// Appends the present state to the block as one more time; the block must have room for it.
void add_states(const avo::space::Simulation& simulation, const BlockShape& shape,
                RecordingBlock& block);

/// Stands in place of the build in the header of a recording that no run of avo has made.
inline constexpr std::string_view kConvertedRows = "converted rows";

/// HDF5 through a spool, see Hdf5Recording.
class SpaceHdf5Recording final : public SpaceRecording {
 public:
  /// is_converted: its rows are those of another recording.
  SpaceHdf5Recording(const std::string& path, const avo::space::Scenario& scenario,
                     const SceneSource& source, const RecordingOptions& options,
                     bool is_converted = false);
  ~SpaceHdf5Recording() override;
  SpaceHdf5Recording(const SpaceHdf5Recording&) = delete;
  SpaceHdf5Recording& operator=(const SpaceHdf5Recording&) = delete;
  void add(const avo::space::Simulation& simulation) override;
  void finish(const avo::space::Simulation& simulation) override;
  /// Adds rows of another program, by ascending robot; their status is `optimal`.
  void add(const SpaceMoment& moment);
  /// Call it after the last of such rows.
  void finish();

 private:
  SpaceClearances clearances_;
  BlockRecorder recorder_;  // its thread uses the clearances
};

}  // namespace avo_io
