// SPDX-License-Identifier: Apache-2.0
// The comparison of a recording with a run that is simulated again, in the plane and in space.
#pragma once
#include <cstdint>
#include <string>

#include "avo_io/replay.h"
#include "io/recording/block_source.h"

namespace avo_io {

/// A simulation of the recorded scene.
class ReplayedRun {
 public:
  virtual ~ReplayedRun() = default;
  [[nodiscard]] virtual std::int64_t steps() const = 0;
  [[nodiscard]] virtual double time() const = 0;  ///< s
  /// Returns whether the next step ends by that time, s.
  [[nodiscard]] virtual bool can_step_by(double time) const = 0;
  virtual void step() = 0;
  /// Appends the present state and its clearances to the block.
  virtual void take(RecordingBlock& block) = 0;
  [[nodiscard]] virtual std::uint64_t state_hash() const = 0;
};

/// Throws RecordingError for a recording that this version need not simulate to the same bits.
void require_this_version(const std::string& recording, const RecordingHeader& header);

/// Steps the run along the recording until a value differs. duration: of the scene, s.
Replay compare(BlockSource& source, ReplayedRun& run, const std::string& scene, double duration);

}  // namespace avo_io
