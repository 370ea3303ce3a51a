// SPDX-License-Identifier: Apache-2.0
// Scenes as YAML: built-in ones by name, any other by path.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo_io/errors.h"

namespace avo_io {

/// A file that a scene names, e.g. a map.
struct SceneFile {
  std::string path;  ///< the path from the scene
  std::string text;
  bool builtin = false;
};

/// Returns the image of a map as a raw graymap (P5), for readers that know no other format. It is
/// none where the image is no PNG and no BMP, is damaged, or has opacity, which ROS counts in some
/// modes.
AVO_API std::optional<std::string> as_graymap(const SceneFile& file);

/// All inputs of a scenario: it can be made again without the scene's files.
struct SceneSource {
  std::string name;  ///< the name in messages: a built-in name, a file, "standard input"
  std::string yaml;
  std::vector<std::string> overrides;
  std::vector<SceneFile> files;
  bool start_at_rest = false;  ///< avo::start_at_rest() follows
  bool limit_speed = false;    ///< and then avo::limit_speed()
  /// Entries of its files that no scene can use, and that are left out: one line each.
  /// load_scenario() sets them.
  std::vector<std::string> notes = {};
  /// It comes from a recording, maybe of an earlier version: keys and values that were removed
  /// since are read as what replaces them, not refused.
  bool recorded = false;
};

/// Returns the scene called `name_or_path`: a built-in name (circle-N and uniform-N for any N >=
/// 2), a file, or "-", the standard input. The standard input is relative to the current folder,
/// and may also name built-in files. Each override is "key=value" on a key of the scene, e.g.
/// "robots.0.radius=0.4"; it can also name robots that a group makes. Files that the scene names
/// (maps, plans) are relative to its own. `source`, where it is given, is set to the inputs of the
/// scene. Throws SceneError, OverrideError or FileError; the returned scene has passed
/// avo::validate.
AVO_API avo::Scenario load_scenario(const std::string& name_or_path,
                                    const std::vector<std::string>& overrides = {},
                                    SceneSource* source = nullptr);
/// Loads a scene that may have no robots: the surroundings of a recording, which has its own
/// robots.
AVO_API avo::Scenario load_surroundings(const std::string& name_or_path,
                                        const std::vector<std::string>& overrides = {},
                                        SceneSource* source = nullptr);
/// Makes the same scenario again; reads no file.
AVO_API avo::Scenario parse_scenario(const SceneSource& source);

/// Returns the setting of a recorded scene that was removed since and that changed its motion, such
/// as "right_of_way: told". None if the scene can be simulated as before.
AVO_API std::optional<std::string> lost_setting(const SceneSource& source);

/// Makes a scenario from text. Error messages begin with `file`. The scene's files are relative to
/// it, or else built-in ones.
AVO_API avo::Scenario parse_scenario(std::string_view yaml, const std::string& file,
                                     const std::vector<std::string>& overrides = {});

/// Returns whether it is a built-in name, so that load_scenario() reads no file. Throws
/// OverrideError for N out of range.
AVO_API bool is_builtin_scene(const std::string& name);

/// A scene that needs no file.
struct BuiltinScene {
  std::string name;         ///< "circle-N" for the whole family
  std::string description;  ///< one line
  std::string yaml;         ///< its text
};
/// All built-in scenes, by ascending name.
AVO_API const std::vector<BuiltinScene>& builtin_scenes();

/// Returns the YAML that load_scenario() reads for a built-in scene; for circle-N and uniform-N it
/// has the N of the name. It is none for any other name. Throws OverrideError for N out of range.
AVO_API std::optional<std::string> builtin_text(const std::string& name);

/// Returns the built-in name that an unknown `name` may have meant: "circle-10" for "circle10";
/// none where no name is like it.
AVO_API std::optional<std::string> nearest_scene(const std::string& name);

/// Returns the text of a file that a built-in scene names, e.g. "arena.map"; empty where there is
/// none.
AVO_API std::string_view builtin_file(std::string_view name);

/// JSON Schema (draft 2020-12) of scene files.
AVO_API std::string scenario_schema();

/// A key of scene files that takes a plain value.
struct SceneSetting {
  std::string key;
  std::vector<std::string> values;  ///< all allowed values; empty where they are numbers
};
/// Returns all settings, in the order of the schema.
AVO_API std::vector<SceneSetting> scene_settings();

}  // namespace avo_io
