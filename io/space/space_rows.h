// SPDX-License-Identifier: Apache-2.0
// The rows of recordings of space, one time after the other.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/space/check.h"
#include "io/text/line_reader.h"

namespace avo_io {

inline constexpr std::string_view kSpaceColumns = "time,robot,x,y,z,vx,vy,vz";

/// Appends the shortest digits that read back to the same bits.
void append_number(double value, std::string& line);

/// All rows of one time.
struct SpaceMoment {
  double time = 0.0;  // s
  std::vector<avo::space::CheckedState> rows;
};

/// Reads a recording as CSV.
class SpaceRows {
 public:
  /// Throws FileError, and RecordingError if the first line has other columns.
  explicit SpaceRows(const std::string& path);

  /// Returns the rows of the next time, valid until the next call; null at the end. Throws
  /// RecordingError.
  const SpaceMoment* next();
  /// Throws RecordingError that names the last line that was read.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  struct Row {
    double time = 0.0;
    avo::space::CheckedState state;
  };
  std::optional<Row> read();
  double number_of(std::string_view field) const;

  LineReader lines_;
  std::optional<Row> ahead_;  // the first row of the next time
  SpaceMoment moment_;
};

}  // namespace avo_io
