// SPDX-License-Identifier: Apache-2.0
// A scene by its name or its path, or from the standard input.
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "avo_io/scene.h"
#include "io/files/file_names.h"
#include "io/files/regular_file.h"
#include "io/scene/scene_files.h"
#include "io/scene/scene_text.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

std::string not_found(const std::string& path) {
  std::vector<std::string_view> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  const auto meant = nearest_scene(path);
  return fmt::format("{}: found no such file and no scene of that name, {}cenes are {}", path,
                     meant ? fmt::format("did you mean \"{}\"? S", *meant) : "s", joined(names));
}

avo::Scenario loaded(const std::string& name_or_path, const std::vector<std::string>& overrides,
                     SceneSource* source, bool may_lack_robots) {
  std::optional<FoundScene> found = find_scene_text(name_or_path);
  if (!found) throw FileError(not_found(name_or_path));
  auto& [yaml, file, files] = *found;
  files.may_lack_robots = may_lack_robots;
  avo::Scenario scenario = scenario_of(yaml, file, overrides, files);
  if (source != nullptr) {
    *source = {file, std::move(yaml), overrides, std::move(files.read)};
    source->notes = std::move(files.notes);
  }
  return scenario;
}

}  // namespace

std::optional<FoundScene> find_scene_text(const std::string& name_or_path) {
  FoundScene found{{}, name_or_path, {folder_of(name_or_path)}};
  if (name_or_path == "-") {
    found.files.builtin = BuiltinFiles::last;
    found.yaml = read_standard_input();
    found.file = kStandardInput;
  } else if (std::optional<std::string> builtin = builtin_text(name_or_path)) {
    found.files.builtin = BuiltinFiles::first;
    found.yaml = *std::move(builtin);
  } else {
    if (is_missing(name_or_path)) return std::nullopt;
    found.yaml = read_regular_file(name_or_path);
  }
  return found;
}

avo::Scenario load_scenario(const std::string& name_or_path,
                            const std::vector<std::string>& overrides, SceneSource* source) {
  return loaded(name_or_path, overrides, source, false);
}

avo::Scenario load_surroundings(const std::string& name_or_path,
                                const std::vector<std::string>& overrides, SceneSource* source) {
  return loaded(name_or_path, overrides, source, true);
}

}  // namespace avo_io
