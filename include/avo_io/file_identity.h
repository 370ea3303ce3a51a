// SPDX-License-Identifier: Apache-2.0
// Which file a path leads to, whatever its name.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "avo/export.h"

namespace avo_io {

/// Equal where writing to one file changes or replaces the other.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;  ///< of the file; of its folder where the file does not exist yet
  std::string name;         ///< in that folder; empty for a file that exists
  bool operator==(const FileIdentity&) const = default;
};

/// All links followed. None for what several may share (devices, pipes, sockets), for folders, and
/// where there is no such folder.
AVO_API std::optional<FileIdentity> identity_of(const std::string& path);
AVO_API std::optional<FileIdentity> identity_of(int descriptor);

/// Where the links at the end of `path` lead, dangling ones too.
AVO_API std::string behind_links(const std::string& path);

}  // namespace avo_io
