// SPDX-License-Identifier: Apache-2.0
// The file that a recording grows in during a run. Its records follow each other, each with its
// length and checksums. However the run ends, all records before the last are readable.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/recording/recording_blocks.h"
#include "io/recording/recording_fields.h"

namespace avo_io {

/// Returns "run.h5.part" for "run.h5".
std::string spool_path(const std::string& recording);
/// Returns whether a file that begins with these bytes is a spool.
bool is_spool(std::string_view begin);

/// Writes without a buffer: bytes of a completed call survive the end of the process.
class SpoolWriter {
 public:
  /// Throws FileError also if the file exists: a killed run has left it.
  SpoolWriter(const std::string& path, const RecordingHeader& header);
  ~SpoolWriter();
  SpoolWriter(const SpoolWriter&) = delete;
  SpoolWriter& operator=(const SpoolWriter&) = delete;

  void write(const CompressedBlock& block);
  /// Marks that the run has ended regularly; nothing may be written after that.
  void write_end(std::uint64_t state_hash);
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::int64_t times() const { return times_; }

 private:
  void write_record(std::uint32_t type, std::string_view payload);

  std::string path_;
  int descriptor_ = -1;
  std::int64_t times_ = 0;  // in whole records
};

/// Reads records until the end, or until a record that is not whole.
class SpoolReader {
 public:
  /// Throws FileError, and RecordingError if even the header is incomplete.
  explicit SpoolReader(const std::string& path);
  ~SpoolReader();
  SpoolReader(const SpoolReader&) = delete;
  SpoolReader& operator=(const SpoolReader&) = delete;

  [[nodiscard]] const RecordingHeader& header() const { return header_; }
  [[nodiscard]] const BlockShape& shape() const { return shape_; }
  /// Reads the next block; returns false at the end. `header` has the hash then, if the run ended
  /// regularly.
  bool next(CompressedBlock& block);
  /// Returns the number of bytes of an incomplete record at the end, once next() has returned
  /// false.
  [[nodiscard]] std::uint64_t lost_bytes() const { return size_ - offset_; }

 private:
  struct Record {
    std::uint32_t type = 0;
    std::string payload;
  };
  std::optional<Record> read_record();
  [[nodiscard]] bool unpack(std::string_view payload, CompressedBlock& block) const;

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0, offset_ = 0;  // bytes; of the file, of its complete records
  RecordingHeader header_;
  BlockShape shape_;
};

}  // namespace avo_io
