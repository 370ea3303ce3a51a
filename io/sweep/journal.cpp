// SPDX-License-Identifier: Apache-2.0
// The file to which a sweep appends its finished runs.
#include "io/sweep/journal.h"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "avo_io/errors.h"
#include "io/files/descriptors.h"
#include "io/files/regular_file.h"
#include "io/sweep/hash.h"
#include "io/text/csv_text.h"

namespace avo_io {
namespace {

std::string checksum_of(std::string_view line) {
  TextHash hash;
  hash.add(line);
  return hash.text();
}

/// Returns the fields of a line without its hash; none if the line was torn.
std::optional<std::vector<std::string>> intact(std::string_view line, std::size_t fields) {
  const std::size_t comma = line.rfind(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view row = line.substr(0, comma);
  if (line.substr(comma + 1) != checksum_of(row)) return std::nullopt;
  auto found = csv_fields(row);
  if (found && found->size() != fields) return std::nullopt;
  return found;
}

}  // namespace

SweepJournal::SweepJournal(const std::string& path, const std::string& sweep,
                           const std::string& shard, std::size_t fields)
    : path_(path) {
  try {
    open_locked();
    begin(fmt::format("avo sweep journal 1,{},{}\n", sweep, shard), fields);
  } catch (...) {
    if (descriptor_ >= 0) close(descriptor_);
    throw;
  }
}

SweepJournal::~SweepJournal() {
  close(descriptor_);
}

void SweepJournal::open_locked() {
  // O_NONBLOCK: do not wait for the other end of a pipe; only regular files are accepted
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor_ < 0) throw FileError(with_errno(path_));
  struct stat status = {};
  if (fstat(descriptor_, &status) != 0) throw FileError(with_errno(path_));
  if (!S_ISREG(status.st_mode))
    throw FileError(path_ + ": found no regular file, must be one: the runs go there");
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    throw FileError(errno == EWOULDBLOCK ? path_ + ": found in use, another avo sweep writes there"
                                         : with_errno(path_));
}

void SweepJournal::begin(const std::string& head, std::size_t fields) {
  const std::optional<std::string> found = read_all(descriptor_);
  if (!found) throw FileError(with_errno(path_));
  const std::string& text = *found;
  std::size_t whole = 0;
  if (text.starts_with(head)) {
    whole = head.size();
    for (std::size_t end = text.find('\n', whole); end != std::string::npos;
         end = text.find('\n', whole)) {
      auto row = intact(std::string_view(text).substr(whole, end - whole), fields);
      if (!row) break;
      rows_.push_back(std::move(*row));
      whole = end + 1;
    }
  } else if (!head.starts_with(text)) {  // else the head itself was torn
    throw SceneError(path_ +
                     ": found the runs of another sweep, shard or version, must be of this one; "
                     "remove it to begin anew");
  }
  if (ftruncate(descriptor_, static_cast<off_t>(whole)) != 0) throw FileError(with_errno(path_));
  if (whole == 0) write(head);
}

void SweepJournal::add(const std::vector<std::string>& row) {
  const std::string line = csv_line(row);
  write(line + "," + checksum_of(line) + "\n");
}

void SweepJournal::write(const std::string& text) {
  if (!write_all(descriptor_, text)) throw FileError(with_errno(path_));
}

}  // namespace avo_io
