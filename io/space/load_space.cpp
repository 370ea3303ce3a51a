// SPDX-License-Identifier: Apache-2.0
// A scene of space by its name or its path, from the standard input, or from a text.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "io/files/file_names.h"
#include "io/recording/recorded_scene.h"
#include "io/space/read_space.h"

namespace avo_io {
namespace {

using avo::space::Scenario;

Scenario scenario_of_space(const std::string& yaml, const std::string& file,
                           const std::vector<std::string>& overrides, SceneFiles& files,
                           std::int64_t most_robots) {
  std::optional<Scenario> scenario =
      scenario_if_in_space(yaml, file, overrides, files, most_robots);
  if (!scenario) throw SceneError(file + ": found no space: 3, which scenes of space have");
  return *std::move(scenario);
}

}  // namespace

std::optional<Scenario> load_space_scenario(const std::string& name_or_path,
                                            const std::vector<std::string>& overrides,
                                            SceneSource* source) {
  std::optional<FoundScene> found = find_scene_text(name_or_path);
  if (!found) return std::nullopt;
  auto& [yaml, file, files] = *found;
  std::optional<Scenario> scenario =
      scenario_if_in_space(yaml, file, overrides, files, avo::kMostRobots);
  if (scenario && source != nullptr)
    *source = {file, std::move(yaml), overrides, std::move(files.read)};
  return scenario;
}

Scenario parse_space_scenario(std::string_view yaml, const std::string& file,
                              const std::vector<std::string>& overrides) {
  SceneFiles files{folder_of(file)};
  return scenario_of_space(std::string(yaml), file, overrides, files, avo::kMostRobots);
}

Scenario parse_space_scenario(const SceneSource& source) {
  return parse_space_scenario_of(source, avo::kMostRobots);
}

Scenario parse_space_scenario_of(const SceneSource& source, std::int64_t most_robots) {
  SceneFiles files{folder_of(source.name)};
  files.given = &source.files;
  return scenario_of_space(source.yaml, source.name, source.overrides, files, most_robots);
}

}  // namespace avo_io
