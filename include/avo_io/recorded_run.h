// SPDX-License-Identifier: Apache-2.0
// A recorded run for comparisons: arrivals, the least clearance, places.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo_io/frames.h"

namespace avo_io {

/// One time of a run.
struct RecordedMoment {
  double time = 0.0;  ///< s
  /// robots that have been at their goals by then; parked robots do not count
  std::int64_t arrived = 0;
  /// m, the least over pairs that avoid each other; none: infinite
  std::optional<double> clearance;
  double fastest = 0.0;  ///< m/s, of all robots
};

/// The result of read_run().
struct RecordedRun {
  avo::Scenario scenario;
  std::int64_t travelers = 0;  ///< robots that are not parked
  std::vector<RecordedMoment> moments;
  std::vector<RecordedFrame> frames;  ///< at most `most_frames` of its times, and the last
};

/// Reads an HDF5 recording or a spool, which hold their scene. Throws FileError and RecordingError.
AVO_API RecordedRun read_run(const std::string& recording, std::size_t most_frames = 512);

}  // namespace avo_io
