// SPDX-License-Identifier: Apache-2.0
// A recording as pictures see it: where everybody is, at any time.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/vec.h"

namespace avo_io {

/// Where everybody is at one time, by the numbers of the scene.
struct RecordedFrame {
  double time = 0.0;                ///< s
  std::vector<avo::Vec2> position;  ///< m; of who is not there, where it was last
  std::vector<double> heading;      ///< rad, 0 of who has none
  std::vector<bool> there;
  std::vector<avo::Vec2> obstacle_position;  ///< m, of the moving obstacles
};

/// Reads a recording of the scene forwards.
class AVO_API FrameReader {
 public:
  /// Throws FileError, RecordingError.
  FrameReader(const std::string& recording, const avo::Scenario& scenario);
  ~FrameReader();
  FrameReader(FrameReader&&) noexcept;
  FrameReader& operator=(FrameReader&&) noexcept;

  /// At that time, s, not before the one asked for last; between two rows on the cubic with their
  /// positions and velocities. None after the last row. Throws RecordingError.
  std::optional<RecordedFrame> at(double time);
  [[nodiscard]] double first_time() const;  ///< s

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo_io
