// SPDX-License-Identifier: Apache-2.0
// The scene that a recording contains.
#include "io/recording/recorded_scene.h"

#include <fmt/format.h>

#include "avo_io/scene.h"
#include "io/recording/block_source.h"
#include "io/recording/row_source.h"
#include "io/scene/removed.h"

namespace avo_io {

namespace {

// Returns what `parse` makes of the scene; its errors get the path in front.
template <typename Parse>
auto scene_in(const std::string& path, Parse parse) {
  try {
    return parse();
  } catch (const RecordingError& error) {
    throw RecordingError(fmt::format("{}: {}", path, error.what()));
  } catch (const avo::Error& error) {
    throw OwnSceneError(fmt::format("{}: its scene: {}", path, error.what()));
  }
}

bool may_have_scene(const std::string& path) {
  const RecordingFormat format = format_of(path);
  return format == RecordingFormat::hdf5 || format == RecordingFormat::spool;
}

void add_overrides(const std::vector<std::string>& overrides, SceneSource& source) {
  refuse_removed(overrides);
  source.overrides.insert(source.overrides.end(), overrides.begin(), overrides.end());
}

}  // namespace

void require_plane(const std::string& path, const RecordingHeader& header) {
  if (header.space)
    throw RecordingError(path + ": found a recording of space, must be one of the plane here");
}

avo::Scenario own_scene(const std::string& path, const RecordingHeader& header) {
  require_plane(path, header);
  return scene_in(path, [&] { return parse_scenario_of(header.scene, header.robots); });
}

avo::space::Scenario own_scene_of_space(const std::string& path, const RecordingHeader& header) {
  avo::space::Scenario scene =
      scene_in(path, [&] { return parse_space_scenario_of(header.scene, header.robots); });
  if (static_cast<std::int64_t>(scene.robots.size()) != header.robots)
    throw RecordingError(fmt::format("{}: found {} robots, must be {}, those of its scene", path,
                                     header.robots, scene.robots.size()));
  return scene;
}

std::optional<RecordedScene> read_recorded_scene(const std::string& path,
                                                 const std::vector<std::string>& overrides) {
  if (!may_have_scene(path)) return std::nullopt;
  BlockSource source(path);
  RecordedScene found{source.header(), source.scenario()};
  if (overrides.empty()) return found;
  add_overrides(overrides, found.header.scene);
  found.scenario = parse_scenario(found.header.scene);
  return found;
}

std::optional<RecordedSpaceScene> read_recorded_space_scene(
    const std::string& path, const std::vector<std::string>& overrides) {
  if (!may_have_scene(path)) return std::nullopt;
  BlockSource source(path);
  if (!source.header().space) return std::nullopt;
  RecordedSpaceScene found{source.header(), source.scenario_of_space()};
  if (overrides.empty()) return found;
  add_overrides(overrides, found.header.scene);
  found.scenario = parse_space_scenario(found.header.scene);
  return found;
}

}  // namespace avo_io
