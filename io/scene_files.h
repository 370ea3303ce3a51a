// SPDX-License-Identifier: Apache-2.0
// The files that a scene names.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "reader.h"
#include "source_text.h"

namespace avo_io {

/// Where a scene finds its files, and which ones it has read.
struct SceneFiles {
  std::string folder;               ///< of the scene's file
  bool builtin = false;             ///< files that are built in come first
  std::size_t bytes = 0;            ///< read so far
  std::vector<std::string> read{};  ///< paths
};

/// The file that the value at `node` names, `file` relative to the scene. What cannot be read is
/// told with the value's place. Throws SceneError, OverrideError, FileError.
SourceText read_named_file(const Reader& reader, const YamlNode& node, const std::string& path,
                           const std::string& file, SceneFiles& files);

}  // namespace avo_io
