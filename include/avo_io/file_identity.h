// SPDX-License-Identifier: Apache-2.0
// The file behind a path, whatever its name.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "avo/export.h"

namespace avo_io {

/// Equal where writing to one file changes or replaces the other.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;  ///< of the file; or of its folder where the file does not exist yet
  std::string name;         ///< in that folder; empty for a file that exists
  bool operator==(const FileIdentity&) const = default;
};

/// Returns the identity with all links followed. It is none for what several writers may share
/// (devices, pipes, sockets), for folders, and where there is no such folder.
AVO_API std::optional<FileIdentity> identity_of(const std::string& path);
AVO_API std::optional<FileIdentity> identity_of(int descriptor);

/// Returns the target of the links at the end of `path`, also of dangling links.
AVO_API std::string behind_links(const std::string& path);

}  // namespace avo_io
