// SPDX-License-Identifier: Apache-2.0
// The lines of a file of any length, one after the other.
#include "io/text/line_reader.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <span>

#include "avo_io/errors.h"
#include "io/files/regular_file.h"

namespace avo_io {

LineReader::LineReader(const std::string& path, std::size_t longest)
    : name_(path == "-" ? kStandardInput : path),
      longest_(longest),
      bytes_(open_bytes(path)),
      buffer_(4 * longest) {}

// Reads more bytes behind the remaining ones; returns false at the end of the file.
bool LineReader::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  const std::size_t got = bytes_->read(std::span(buffer_).subspan(end_));
  end_ += got;
  return got > 0;
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = 0;
  while (true) {
    const char* start = buffer_.data() + begin_;
    const std::size_t there = end_ - begin_;
    const void* end = std::memchr(start + searched, '\n', there - searched);
    const std::size_t length =
        end != nullptr ? static_cast<std::size_t>(static_cast<const char*>(end) - start) : there;
    if (length > longest_)
      throw RecordingError(
          fmt::format("{}:{}: found more than {} characters, a line must be shorter", name_,
                      number_ + 1, longest_));
    searched = there;
    if (end == nullptr && fill()) continue;
    if (end == nullptr && there == 0) return std::nullopt;
    const std::string_view line(buffer_.data() + begin_, length);
    begin_ += length + (end != nullptr ? 1 : 0);
    ++number_;
    has_end_ = end != nullptr;
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }
}

}  // namespace avo_io
