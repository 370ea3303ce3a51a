// SPDX-License-Identifier: Apache-2.0
// The files that a scene names.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "io/scene/reader.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Whether a scene may use built-in files. A built-in scene takes them before files of the folder.
/// A scene that may be the text of a built-in scene takes them if the folder has no file of that
/// name.
enum class BuiltinFiles { none, first, last };

/// The places where a scene finds its files, and the files that it has read.
struct SceneFiles {
  std::string folder;  ///< folder of the scene's file
  BuiltinFiles builtin = BuiltinFiles::none;
  const std::vector<SceneFile>* given = nullptr;  ///< if set, only these files exist
  std::size_t bytes = 0;                          ///< bytes read so far
  std::vector<SceneFile> read{};
  std::vector<std::string> notes{};  ///< see SceneSource
  bool is_recorded = false;          ///< see SceneSource::recorded
  bool may_lack_robots = false;  ///< whether the scene may have no robots, see load_surroundings()
};

/// The text of a scene, and the files that it may name.
struct FoundScene {
  std::string yaml, file;  ///< `file`: its name in messages
  SceneFiles files;
};
/// Returns the built-in scene of that name, the standard input for "-", or else the file of that
/// path; none if there is no such file.
std::optional<FoundScene> find_scene_text(const std::string& name_or_path);

/// Adds a note, unless it is there already.
void add_note(std::vector<std::string>& notes, const std::string& note);

/// Returns the file that the value at `node` names, `file` relative to the scene. An unreadable
/// file is reported with the value's place. Throws SceneError, OverrideError, FileError.
SourceText read_named_file(const Reader& reader, const YamlNode& node, const std::string& path,
                           const std::string& file, SceneFiles& files);

}  // namespace avo_io
