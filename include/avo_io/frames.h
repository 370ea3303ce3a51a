// SPDX-License-Identifier: Apache-2.0
// A recording for pictures: where all robots and obstacles are, at any time.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/vec.h"

namespace avo_io {

/// Where all robots and obstacles are at one time, by the numbers of the scene.
struct RecordedFrame {
  double time = 0.0;                ///< s
  std::vector<avo::Vec2> position;  ///< m; of a robot that is not present, its last place
  std::vector<double> heading;      ///< rad; 0 for a robot without a heading
  std::vector<bool> there;
  std::vector<avo::Vec2> mover_position;  ///< m, of the moving obstacles
};

/// Reads a recording of the scene forwards.
class AVO_API FrameReader {
 public:
  /// Throws FileError, RecordingError.
  FrameReader(const std::string& recording, const avo::Scenario& scenario);
  ~FrameReader();
  FrameReader(FrameReader&&) noexcept;
  FrameReader& operator=(FrameReader&&) noexcept;

  /// Returns the frame at that time, s, not before the time of the last call. Between two rows the
  /// frame is on the cubic with their positions and velocities. None after the last row. Throws
  /// RecordingError.
  std::optional<RecordedFrame> at(double time);
  [[nodiscard]] double first_time() const;  ///< s

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo_io
