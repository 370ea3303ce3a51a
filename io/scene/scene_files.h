// SPDX-License-Identifier: Apache-2.0
// The files that a scene names.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "io/scene/reader.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Whether a scene's files may be those that are built in: of a built-in scene before those of the
/// folder; of one that may be the text of such a scene, where the folder has none of that name.
enum class BuiltinFiles { none, first, last };

/// Where a scene finds its files, and which ones it has read.
struct SceneFiles {
  std::string folder;  ///< of the scene's file
  BuiltinFiles builtin = BuiltinFiles::none;
  const std::vector<SceneFile>* given = nullptr;  ///< these and no others
  std::size_t bytes = 0;                          ///< read so far
  std::vector<SceneFile> read{};
  std::vector<std::string> notes{};  ///< see SceneSource
  bool may_lack_robots = false;      ///< of the scene, see load_surroundings()
};

/// Adds a note, if it is not there yet.
void add_note(std::vector<std::string>& notes, const std::string& note);

/// The file that the value at `node` names, `file` relative to the scene. What cannot be read is
/// told with the value's place. Throws SceneError, OverrideError, FileError.
SourceText read_named_file(const Reader& reader, const YamlNode& node, const std::string& path,
                           const std::string& file, SceneFiles& files);

}  // namespace avo_io
