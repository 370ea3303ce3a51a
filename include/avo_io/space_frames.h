// SPDX-License-Identifier: Apache-2.0
// A recording of space as a sequence of pictures, and as curves over time.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/space/scenario.h"
#include "avo_io/recorded_run.h"

namespace avo_io {

/// All robots of a scene at one time.
struct SpaceFrame {
  double time = 0.0;                ///< s
  std::vector<avo::Vec3> position;  ///< m; of a robot that is not present, its last place
  std::vector<bool> there;
};

/// Reads a recording of the scene forwards.
class AVO_API SpaceFrameReader {
 public:
  /// Throws FileError, RecordingError.
  SpaceFrameReader(const std::string& recording, const avo::space::Scenario& scenario);
  ~SpaceFrameReader();
  SpaceFrameReader(SpaceFrameReader&&) noexcept;
  SpaceFrameReader& operator=(SpaceFrameReader&&) noexcept;

  [[nodiscard]] double first_time() const;  ///< s
  /// Returns the frame of that time, s, which ascends from call to call; none after the last time.
  /// Between two rows robots are on the cubic with their positions and velocities.
  std::optional<SpaceFrame> at(double time);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// The result of read_space_run().
struct SpaceRun {
  std::vector<RecordedMoment> moments;  ///< of all times
  std::vector<SpaceFrame> frames;       ///< at most `most_frames` of its times, and the last
};
/// Reads a recording of the scene. Throws FileError and RecordingError.
AVO_API SpaceRun read_space_run(const std::string& recording, const avo::space::Scenario& scenario,
                                std::size_t most_frames = 512);

}  // namespace avo_io
