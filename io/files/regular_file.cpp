// SPDX-License-Identifier: Apache-2.0
// Reads a whole regular file; it is safe against pipes, devices and huge sizes.
#include "io/files/regular_file.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "avo_io/errors.h"
#include "io/files/descriptors.h"

namespace avo_io {
namespace {

constexpr std::size_t kLargest = std::size_t{16} << 20U;

/// Closes its file descriptor.
struct Descriptor {
  explicit Descriptor(int number) : value(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value >= 0) close(value);
  }
  int value;
};

std::string text_of(int descriptor, const std::string& name) {
  std::optional<std::string> text = read_all(descriptor, kLargest);
  if (!text) throw FileError(with_errno(name));
  if (text->size() <= kLargest) return *std::move(text);
  throw SceneError(
      fmt::format("{}:1:1: found more than {} MiB, must be smaller", name, kLargest >> 20U));
}

}  // namespace

std::string with_errno(const std::string& name) {
  return name + ": " + std::generic_category().message(errno);
}

std::string read_regular_file(const std::string& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.value < 0) throw FileError(with_errno(path));
  struct stat status = {};
  if (fstat(file.value, &status) != 0) throw FileError(with_errno(path));
  if (!S_ISREG(status.st_mode))
    throw FileError(fmt::format("{}: found a {}, must be a regular file", path,
                                S_ISDIR(status.st_mode)    ? "directory"
                                : S_ISFIFO(status.st_mode) ? "pipe"
                                                           : "device"));
  return text_of(file.value, path);
}

bool is_missing(const std::string& path) {
  std::error_code error;
  return std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found;
}

std::string read_standard_input() {
  static std::optional<std::string> text;  // a second reader would find nothing
  if (text) return *text;
  struct stat status = {};
  if (fstat(STDIN_FILENO, &status) != 0) throw FileError(with_errno(kStandardInput));
  if (S_ISDIR(status.st_mode))
    throw FileError(fmt::format("{}: found a directory, must be a file", kStandardInput));
  return text.emplace(text_of(STDIN_FILENO, kStandardInput));
}

}  // namespace avo_io
