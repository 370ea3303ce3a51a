// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there at all: a temporary name first, then one rename.
#include "avo_io/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "regular_file.h"

namespace avo_io {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20U;

/// Where links lead, so that a rename does not replace the link.
std::string behind_links(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const auto target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

std::string temporary_name(const std::string& path) {
  const std::filesystem::path name(path);
  return (name.parent_path() /
          fmt::format(".{}.{}.part{}", name.stem().string(), getpid(), name.extension().string()))
      .string();
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), final_(behind_links(path_)) {
  if (path_ == "-") {
    temporary_ = "/dev/stdout";
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status = {};
  const bool exists = stat(final_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
    throw FileError(path_ + ": found a directory, must be a file");
  renames_ = !exists || S_ISREG(status.st_mode);
  if (exists && renames_ && access(final_.c_str(), W_OK) != 0) fail();
  temporary_ = renames_ ? temporary_name(final_) : final_;
  const int flags = O_WRONLY | O_CLOEXEC | (renames_ ? O_CREAT | O_TRUNC : 0);
  descriptor_ = open(temporary_.c_str(), flags, exists ? status.st_mode & 0777U : 0666U);
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0 || path_ == "-") return;
  close(descriptor_);
  if (renames_) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBufferSize) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::settle() {
  flush();
  if (renames_ && fsync(descriptor_) != 0 && errno != EINVAL) fail();
}

void OutputFile::commit() {
  settle();
  if (path_ == "-") return;
  const int descriptor = std::exchange(descriptor_, -1);
  const bool closed = close(descriptor) == 0;
  const bool done = closed && (!renames_ || std::rename(temporary_.c_str(), final_.c_str()) == 0);
  if (done) return;
  const int reason = errno;
  if (renames_) unlink(temporary_.c_str());
  errno = reason;
  fail();
}

void OutputFile::fail() const {
  throw FileError(with_errno(path_), errno == EPIPE);
}

}  // namespace avo_io
