// SPDX-License-Identifier: Apache-2.0
// The bytes of a file of any length, one part after the other.
#include "io/files/byte_source.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "avo_io/errors.h"
#include "io/files/regular_file.h"

namespace avo_io {
namespace {

class FileBytes final : public ByteSource {
 public:
  explicit FileBytes(const std::string& path)
      : name_(path == "-" ? kStandardInput : path),
        descriptor_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~FileBytes() override {
    if (descriptor_ > STDIN_FILENO) close(descriptor_);
  }
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  void require_file() const {
    struct stat status = {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) throw FileError(with_errno(name_));
    if (S_ISDIR(status.st_mode)) throw FileError(name_ + ": found a directory, must be a file");
  }
  std::size_t read(std::span<char> bytes) override;

 private:
  std::string name_;
  int descriptor_;
};

std::size_t FileBytes::read(std::span<char> bytes) {
  while (true) {
    const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) throw FileError(with_errno(name_));
  }
}

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
  auto file = std::make_unique<FileBytes>(path);
  file->require_file();
  return file;
}

}  // namespace avo_io
