// SPDX-License-Identifier: Apache-2.0
// Trajectories that other programs have measured or simulated: a table of positions by frames.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/vec.h"
#include "io/recording/row_source.h"

namespace avo_io {

struct TrackRow {
  std::int64_t robot = 0, frame = 0;
  avo::Vec2 position = {};  ///< m
  avo::Vec2 velocity = {};  ///< m/s, estimated by track_rows()
  std::int64_t line = 0;    ///< line of the file; 0: none
};

struct TrackTable {
  std::string path;
  double frames_per_second = 0.0;  ///< 0: unknown, and rows are kSecondsApart
  std::vector<TrackRow> rows;      ///< in any order
};

/// s, between rows of a pedestrian in data sets that give no frame rate.
inline constexpr double kSecondsApart = 0.4;
inline constexpr std::size_t kMostTrackRows = 50'000'000;

/// Adds a row. Throws RecordingError if there are too many rows, or if a position is out of range.
void add_track_row(TrackTable& table, const TrackRow& row);
/// Returns "FILE:7" or, if there are no lines, "FILE: frame 3, id 5".
std::string place_of(const TrackTable& table, const TrackRow& row);

/// Returns the rows, one time after the other, at frame / frames_per_second. Frames have the most
/// frequent distance; an empty time marks missing frames. A velocity is the mean velocity from the
/// row before to the row after, or from or to the only one of them. Throws RecordingError on ids
/// that occur twice in a frame, or are not below `robots`.
std::unique_ptr<RowSource> track_rows(TrackTable table, std::optional<std::int64_t> robots);

// These functions tell the format by the first bytes of a file, or by its contents.
bool is_sqlite(std::string_view begin);
bool is_pedestrian_text(std::string_view begin);
bool is_pedestrian_hdf5(const std::string& path);

// These throw FileError and RecordingError.
TrackTable read_pedestrian_text(const std::string& path);
TrackTable read_pedestrian_hdf5(const std::string& path);
TrackTable read_pedestrian_sqlite(const std::string& path);

}  // namespace avo_io
