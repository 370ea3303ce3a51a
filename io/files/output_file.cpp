// SPDX-License-Identifier: Apache-2.0
// Files that are whole or do not exist: they are written under a temporary name, then renamed once.
#include "avo_io/output_file.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "avo_io/file_identity.h"
#include "io/files/descriptors.h"
#include "io/files/regular_file.h"

namespace avo_io {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20U;

/// The temporary files of this process. The mutex is held while a name is added, changed or
/// removed.
struct Temporaries {
  std::mutex mutex;
  std::set<std::string> paths;
};

Temporaries& temporaries() {
  static Temporaries& all = *new Temporaries;  // outlives all threads
  return all;
}

/// Returns an unpredictable name beside `target`; its length does not depend on the target's name.
std::string random_name_beside(const std::string& target) {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number)
    throw FileError(with_errno("random name of a temporary file"));
  return (std::filesystem::path(target).parent_path() / fmt::format(".avo-{:016x}.part", number))
      .string();
}

/// Gives the new file the permissions of the old one.
void copy_permissions(const struct stat& old, int descriptor) {
  // only root can give files away
  [[maybe_unused]] const bool given = fchown(descriptor, old.st_uid, old.st_gid) == 0;
  [[maybe_unused]] const bool allowed = fchmod(descriptor, old.st_mode & 0777U) == 0;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? "standard output" : path) {
  if (path == "-") {
    descriptor_ = STDOUT_FILENO;
    closes_ = false;
    const int flags = fcntl(STDOUT_FILENO, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
      throw FileError(name_ + ": found it closed, must be open for writing");
    return;
  }
  struct stat status = {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (path.empty() || (!exists && errno != ENOENT)) fail();
  if (exists && S_ISDIR(status.st_mode))
    throw FileError(path + ": found a directory, must be a file");
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) fail();
    return;
  }
  target_ = behind_links(path);
  if (identity_of(target_) != identity_of(path))
    throw FileError(path + ": found a file without a name, must have one");
  if (exists && access(target_.c_str(), W_OK) != 0) fail();
  open_temporary(exists ? 0600 : 0666);  // the old file may be private: permissions follow
  if (exists) copy_permissions(status, descriptor_);
}

OutputFile::~OutputFile() {
  if (closes_ && descriptor_ >= 0) close(descriptor_);
  if (temporary_.empty()) return;
  const std::lock_guard lock(temporaries().mutex);
  unlink(temporary_.c_str());
  temporaries().paths.erase(temporary_);
}

void OutputFile::open_temporary(unsigned mode) {
  const std::lock_guard lock(temporaries().mutex);
  while (descriptor_ < 0) {
    const auto path = temporaries().paths.insert(random_name_beside(target_)).first;
    descriptor_ = open(path->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    temporary_ = *path;
    if (descriptor_ >= 0) return;
    const int reason = errno;
    temporary_.clear();
    temporaries().paths.erase(path);
    errno = reason;
    if (reason != EEXIST) fail();
  }
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBufferSize) flush();
}

void OutputFile::flush() {
  if (!write_all(descriptor_, buffer_)) fail();
  buffer_.clear();
}

// Reports every error of the bytes here: only the rename is left to do.
void OutputFile::settle() {
  if (descriptor_ < 0) return;
  flush();
  if (!target_.empty() && fsync(descriptor_) != 0 && errno != EINVAL) fail();
  if (closes_ && close(std::exchange(descriptor_, -1)) != 0) fail();
}

// Keeps the old file under another name, as a hard link; some file systems have none.
void OutputFile::keep_old() {
  backup_ = random_name_beside(target_);
  old_ = link(target_.c_str(), backup_.c_str()) == 0 ? Old::kept
         : errno == ENOENT                           ? Old::none
                                                     : Old::not_kept;
}

bool OutputFile::put_old_back() {
  if (old_ == Old::kept) return std::rename(backup_.c_str(), target_.c_str()) == 0;
  return old_ == Old::none && unlink(target_.c_str()) == 0;
}

void OutputFile::commit() {
  commit_all(std::array<OutputFile*, 1>{this});
}

void commit_all(std::span<OutputFile* const> files) {
  for (OutputFile* file : files) file->settle();
  const std::lock_guard lock(temporaries().mutex);
  std::vector<OutputFile*> unnamed;
  for (OutputFile* file : files)
    if (!file->temporary_.empty()) unnamed.push_back(file);
  for (std::size_t i = 0; i + 1 < unnamed.size(); ++i) unnamed[i]->keep_old();
  const auto forget_old = [&unnamed] {
    for (const OutputFile* file : unnamed)
      if (file->old_ == OutputFile::Old::kept) unlink(file->backup_.c_str());
  };
  for (std::size_t i = 0; i < unnamed.size(); ++i) {
    if (std::rename(unnamed[i]->temporary_.c_str(), unnamed[i]->target_.c_str()) == 0) continue;
    std::string message = with_errno(unnamed[i]->name_);
    for (std::size_t k = i; k-- > 0;)
      if (!unnamed[k]->put_old_back())
        message += fmt::format("; {} is replaced already", unnamed[k]->name_);
    forget_old();
    throw FileError(message);
  }
  forget_old();
  for (OutputFile* file : unnamed) temporaries().paths.erase(std::exchange(file->temporary_, {}));
}

void abandon_outputs() {
  Temporaries& all = temporaries();
  all.mutex.lock();  // never unlocked
  for (const std::string& path : all.paths) unlink(path.c_str());
}

void OutputFile::fail() const {
  throw FileError(with_errno(name_), errno == EPIPE);
}

}  // namespace avo_io
