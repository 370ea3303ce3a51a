// SPDX-License-Identifier: Apache-2.0
// The file that a recording grows in while a run goes on: records one after the other, each with
// its length and checksums, so that whatever ends the run, all records before the last are
// readable.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/recording/recording_blocks.h"
#include "io/recording/recording_fields.h"

namespace avo_io {

/// "run.h5.part" of "run.h5".
std::string spool_path(const std::string& recording);
/// Whether a file that begins with these bytes is a spool.
bool is_spool(std::string_view begin);

/// Written at once, without a buffer: what has returned survives the end of the process.
class SpoolWriter {
 public:
  /// Throws FileError also where there is such a file: a killed run has left it.
  SpoolWriter(const std::string& path, const RecordingHeader& header);
  ~SpoolWriter();
  SpoolWriter(const SpoolWriter&) = delete;
  SpoolWriter& operator=(const SpoolWriter&) = delete;

  void write(const CompressedBlock& block);
  /// The run has ended by itself; nothing is written after that.
  void write_end(std::uint64_t state_hash);
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::int64_t times() const { return times_; }

 private:
  void write_record(std::uint32_t type, std::string_view payload);

  std::string path_;
  int descriptor_ = -1;
  std::int64_t times_ = 0;  // in whole records
};

/// Reads records until the end, or until one that is not whole.
class SpoolReader {
 public:
  /// Throws FileError, and RecordingError where not even the header is whole.
  explicit SpoolReader(const std::string& path);
  ~SpoolReader();
  SpoolReader(const SpoolReader&) = delete;
  SpoolReader& operator=(const SpoolReader&) = delete;

  [[nodiscard]] const RecordingHeader& header() const { return header_; }
  [[nodiscard]] const BlockShape& shape() const { return shape_; }
  /// False at the end; `header` has the hash then, if the run ended by itself.
  bool next(CompressedBlock& block);
  /// Bytes at the end that are no whole record, once next() has returned false.
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
  std::uint64_t size_ = 0, offset_ = 0;  // bytes; of the file, of what is whole
  RecordingHeader header_;
  BlockShape shape_;
};

}  // namespace avo_io
