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
  avo::Vec2 velocity = {};  ///< m/s, which track_rows() estimates
  std::int64_t line = 0;    ///< of the file; 0: it has none
};

struct TrackTable {
  std::string path;
  double frames_per_second = 0.0;  ///< 0: none is told, and rows are kSecondsApart
  std::vector<TrackRow> rows;      ///< in any order
};

/// s, of the sets of data that name no frame rate: from row to row of a pedestrian.
inline constexpr double kSecondsApart = 0.4;
inline constexpr std::size_t kMostTrackRows = 50'000'000;

/// Adds a row. Throws RecordingError where there are too many, and on a position beyond all.
void add_track_row(TrackTable& table, const TrackRow& row);
/// "FILE:7" or, where there are no lines, "FILE: frame 3, id 5".
std::string place_of(const TrackTable& table, const TrackRow& row);

/// The rows, one time after the other, at frame / frames_per_second. Frames are as far apart as
/// most are; where some are missing, one without rows says so. Velocities are those from the row
/// before to the row after, else from or to the one that there is. Throws RecordingError on numbers
/// that come twice in a frame, or are not below `robots`.
std::unique_ptr<RowSource> track_rows(TrackTable table, std::optional<std::int64_t> robots);

// By the first bytes of a file, or by what is in it.
bool is_sqlite(std::string_view begin);
bool is_pedestrian_text(std::string_view begin);
bool is_pedestrian_hdf5(const std::string& path);

// These throw FileError and RecordingError.
TrackTable read_pedestrian_text(const std::string& path);
TrackTable read_pedestrian_hdf5(const std::string& path);
TrackTable read_pedestrian_sqlite(const std::string& path);

}  // namespace avo_io
