// SPDX-License-Identifier: Apache-2.0
// The file behind a path, whatever its name.
#include "avo_io/file_identity.h"

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace avo_io {
namespace {

namespace fs = std::filesystem;

std::optional<FileIdentity> regular(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino, ""};
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) == 0) return regular(status);
  if (errno != ENOENT) return std::nullopt;
  const fs::path target = behind_links(path);
  const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
  if (stat(folder.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino, target.filename().string()};
}

std::optional<FileIdentity> identity_of(int descriptor) {
  struct stat status = {};
  return fstat(descriptor, &status) == 0 ? regular(status) : std::nullopt;
}

std::string behind_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // the kernel's limit
  fs::path target = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(target, error); ++i)
    target = target.parent_path() / fs::read_symlink(target, error);
  return target.string();
}

}  // namespace avo_io
