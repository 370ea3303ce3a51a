// SPDX-License-Identifier: Apache-2.0
// Recordings as HDF5 files (docs/recordings.md).
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/recording/hdf5_handle.h"
#include "io/recording/recording_blocks.h"
#include "io/recording/recording_fields.h"

namespace avo_io {

/// The value of its attribute "format".
inline constexpr const char* kRecordingFormat = "avo recording 1";

/// Returns whether a file that begins with these bytes is an HDF5 file.
bool is_hdf5(std::string_view begin);

/// Writes all blocks of the spool to the file at `path`, without compressing them again. Returns
/// the number of times. Throws FileError, which names the file `name`, and RecordingError.
std::int64_t write_hdf5(const std::string& spool, const std::string& path, const std::string& name);

/// All data of a recording, as input for a writer.
struct RecordedTables {
  const RecordingHeader& header;
  const BlockShape& shape;
  const std::vector<double>& times;                  ///< s, of all blocks
  std::function<bool(CompressedBlock& block)> next;  ///< false at the end
};
/// Returns the bytes of its file. Throws FileError, which names it `name`, and what next() throws.
std::string hdf5_bytes(const RecordedTables& recording, const std::string& name);

/// Reads one block after the other.
class Hdf5Reader {
 public:
  /// Throws FileError, and RecordingError if it is not a recording of avo.
  explicit Hdf5Reader(const std::string& path);

  [[nodiscard]] const RecordingHeader& header() const { return header_; }
  [[nodiscard]] const BlockShape& shape() const { return shape_; }
  /// Reads the next block; returns false at the end. Throws RecordingError.
  bool next(RecordingBlock& block);

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  [[nodiscard]] Hdf5Handle open_table(const char* name, const std::vector<hsize_t>& size) const;
  [[nodiscard]] Hdf5Handle open_dataset(const char* name) const;
  void require_layout(const Hdf5Handle& table, const char* name,
                      const std::vector<hsize_t>& size) const;
  void require_columns() const;
  void read_attributes();
  void read_rows(const Hdf5Handle& table, hid_t type, const std::vector<hsize_t>& offset,
                 const std::vector<hsize_t>& count, void* values) const;

  std::string path_;
  RecordingHeader header_;
  BlockShape shape_;
  Hdf5Handle file_, time_, state_, status_, clearance_;
  hsize_t times_ = 0, first_ = 0;  // in the file; of the next block
};

}  // namespace avo_io
