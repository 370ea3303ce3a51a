// SPDX-License-Identifier: Apache-2.0
// The lines of a file of any length, one after the other.
#include "io/text/line_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "avo_io/errors.h"
#include "io/files/regular_file.h"

namespace avo_io {

LineReader::LineReader(const std::string& path, std::size_t longest)
    : name_(path == "-" ? kStandardInput : path), longest_(longest), buffer_(4 * longest) {
  descriptor_ = path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status = {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) throw FileError(with_errno(name_));
  if (!S_ISDIR(status.st_mode)) return;
  if (path != "-") close(descriptor_);
  throw FileError(name_ + ": found a directory, must be a file");
}

LineReader::~LineReader() {
  if (descriptor_ > STDIN_FILENO) close(descriptor_);
}

// Reads more bytes behind the remaining ones; returns false at the end of the file.
bool LineReader::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  while (true) {
    const ssize_t got = read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileError(with_errno(name_));
    end_ += static_cast<std::size_t>(got);
    return got > 0;
  }
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
