// SPDX-License-Identifier: Apache-2.0
// The source of a recording's rows, whatever its format.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "avo_io/recording.h"

namespace avo_io {

class RowSource {
 public:
  virtual ~RowSource() = default;
  /// See RecordingReader.
  virtual bool next(RecordedTime& moment) = 0;
  [[nodiscard]] virtual std::string place(std::optional<std::int64_t> robot) const = 0;
  [[nodiscard]] virtual std::optional<double> frame_rate() const { return std::nullopt; }
};

std::unique_ptr<RowSource> csv_rows(const std::string& path, std::optional<std::int64_t> robots);
/// Returns the rows of an HDF5 file or a spool.
std::unique_ptr<RowSource> block_rows(const std::string& path, std::optional<std::int64_t> robots);

/// The format of a file by its first bytes. "-" is CSV. Throws FileError if the file cannot be
/// read.
enum class RecordingFormat {
  csv,
  hdf5,
  spool,
  pedestrian_text,  ///< of the archive, or of ETH and UCY
  pedestrian_hdf5,
  pedestrian_sqlite
};
RecordingFormat format_of(const std::string& path);

}  // namespace avo_io
