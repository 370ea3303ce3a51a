// SPDX-License-Identifier: Apache-2.0
// Writes a run's states to a spool, compressed by a separate thread, and then to an HDF5 file.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "avo_io/recording.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

/// Returns the facts of this build, for the header of a recording.
RecordingHeader header_of_this_build();

/// Returns the header of a run of a scene, in the plane or in space, but for what only one of the
/// two has.
template <class Scenario>
RecordingHeader header_of_run(const Scenario& scenario, const SceneSource& source,
                              const RecordingOptions& options) {
  RecordingHeader header = header_of_this_build();
  header.seed = scenario.seed;
  header.robots = static_cast<std::int64_t>(scenario.robots.size());
  header.every = options.every;
  header.until_arrived = options.until_arrived;
  header.scene = source;
  return header;
}

/// The recording that grows while a run fills it time by time, in the plane and in space.
class BlockRecorder {
 public:
  /// Finds the clearances of one time of a block; another thread calls it.
  using FindClearances = std::function<void(std::size_t time, RecordingBlock& block)>;

  /// Throws FileError where there is a spool beside `path`.
  BlockRecorder(const std::string& path, const RecordingHeader& header, FindClearances clearances);
  ~BlockRecorder();
  BlockRecorder(const BlockRecorder&) = delete;
  BlockRecorder& operator=(const BlockRecorder&) = delete;

  [[nodiscard]] const BlockShape& shape() const;
  /// The block to which the next time is appended; it has room for that. Call taken() afterwards.
  [[nodiscard]] RecordingBlock& block();
  /// Throws FileError that the other thread met.
  void taken();
  /// Writes the rest, and the file at `temporary`. state_hash: of the last state; none: rows of
  /// another program have none.
  void finish(const std::string& temporary, std::optional<std::uint64_t> state_hash);
  /// Removes the spool if the file that finish() has written got its name.
  void remove_spool_of(const OutputFile& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace avo_io
