// SPDX-License-Identifier: Apache-2.0
// Refuses values that no run records, before any code uses them.
#pragma once
#include <cstddef>
#include <string>
#include <utility>

#include "io/recording/recording_blocks.h"

namespace avo_io {

/// Checks the blocks of one recording, one after the other.
class BlockChecks {
 public:
  /// `end`: s, after which the scene has no more times; infinite if it is unknown.
  BlockChecks(std::string path, double end) : path_(std::move(path)), end_(end) {}
  /// Throws RecordingError, which names the time and the robot.
  void check(const BlockShape& shape, const RecordingBlock& block);

 private:
  void check_time(double time);
  void check_robot(const BlockShape& shape, const RecordingBlock& block, std::size_t k,
                   std::size_t robot) const;
  [[noreturn]] void refuse(double time, std::size_t robot, const char* column, double value) const;

  std::string path_;
  double end_;
  double last_ = -1.0;  // s
};

}  // namespace avo_io
