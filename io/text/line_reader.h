// SPDX-License-Identifier: Apache-2.0
// The lines of a file of any length, one after the other.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/byte_source.h"

namespace avo_io {

class LineReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 16U;  // bytes

  /// "-" is the standard input. Throws FileError.
  explicit LineReader(const std::string& path, std::size_t longest = kLongestLine);

  /// Returns the next line without its end (LF or CR LF), valid until the next call; none at the
  /// end. Throws FileError, and RecordingError for a line longer than the limit.
  std::optional<std::string_view> next();
  /// Returns the number of the last returned line, from 1.
  [[nodiscard]] std::int64_t number() const { return number_; }
  /// Returns whether the last returned line had an end; the last line of a file that was cut off
  /// has none.
  [[nodiscard]] bool has_end() const { return has_end_; }
  /// Returns the name of the file in messages.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  bool fill();

  std::string name_;
  std::size_t longest_;
  std::unique_ptr<ByteSource> bytes_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // bytes that are read but not yet returned
  std::int64_t number_ = 0;
  bool has_end_ = false;
};

}  // namespace avo_io
