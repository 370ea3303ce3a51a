// SPDX-License-Identifier: Apache-2.0
// The rows of recordings of space, one time after the other.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/space/check.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

inline constexpr std::string_view kSpaceCsvHeader = "time,robot,x,y,z,vx,vy,vz";
/// What follows the header if only every n-th step has rows.
inline constexpr std::string_view kEveryColumn = ",every";
/// The part of a step by which times may be off, because their digits are rounded.
inline constexpr double kOfStep = 1e-6;

/// All rows of one time, by ascending robot.
struct SpaceMoment {
  double time = 0.0;  // s
  std::vector<avo::space::CheckedState> rows;
  std::int64_t every = 1;  // only every n-th step has rows
};

/// Appends the shortest digits that read back to the same bits.
void append_number(double value, std::string& line);
/// Returns the first line of CSV. Its last column is "every" if that is more than 1.
std::string space_csv_header(std::int64_t every);
/// Appends the lines of one time as CSV; the last column is "every" if that is more than 1.
void append_csv_lines(const SpaceMoment& moment, std::string& lines);
/// Appends one time to a block, which must have room for it; its robots are those of the shape.
void append_moment(const SpaceMoment& moment, const BlockShape& shape, RecordingBlock& block);

/// Where rows come from.
class SpaceRowSource {
 public:
  virtual ~SpaceRowSource() = default;
  /// See SpaceRows.
  virtual const SpaceMoment* next() = 0;
  /// The place of that robot's row in the last time, or of its last row.
  [[nodiscard]] virtual std::string place(std::optional<std::int64_t> robot) const = 0;
};

/// Reads CSV. Throws FileError, and RecordingError if it is no recording of space.
std::unique_ptr<SpaceRowSource> space_csv_rows(const std::string& path);

/// Reads a recording: CSV, HDF5 or a spool.
class SpaceRows {
 public:
  /// Throws FileError, and RecordingError if it is no recording of space.
  explicit SpaceRows(const std::string& path);

  /// Returns the rows of the next time, valid until the next call; null at the end. Throws
  /// RecordingError.
  const SpaceMoment* next() { return source_->next(); }
  /// Throws RecordingError that names the place of that robot's row in the last time, or of its
  /// last row.
  [[noreturn]] void fail(const std::string& what, std::optional<std::int64_t> robot = {}) const;
  /// Refuses a row of the last time if its robot is none of so many, those of the scene.
  void require_known(const SpaceMoment& moment, std::size_t robots) const;

 private:
  std::unique_ptr<SpaceRowSource> source_;
};

}  // namespace avo_io
