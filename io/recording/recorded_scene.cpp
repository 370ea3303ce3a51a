// SPDX-License-Identifier: Apache-2.0
// The scene that a recording contains.
#include "io/recording/recorded_scene.h"

#include <fmt/format.h>

#include "avo_io/scene.h"
#include "io/recording/block_source.h"
#include "io/recording/row_source.h"
#include "io/scene/removed.h"

namespace avo_io {

avo::Scenario own_scene(const std::string& path, const RecordingHeader& header) {
  try {
    return parse_scenario_of(header.scene, header.robots);
  } catch (const RecordingError& error) {
    throw RecordingError(fmt::format("{}: {}", path, error.what()));
  } catch (const avo::Error& error) {
    throw OwnSceneError(fmt::format("{}: its scene: {}", path, error.what()));
  }
}

std::optional<RecordedScene> read_recorded_scene(const std::string& path,
                                                 const std::vector<std::string>& overrides) {
  const RecordingFormat format = format_of(path);
  if (format != RecordingFormat::hdf5 && format != RecordingFormat::spool) return std::nullopt;
  BlockSource source(path);
  RecordedScene found{source.header(), source.scenario()};
  if (overrides.empty()) return found;
  refuse_removed(overrides);
  found.header.scene.overrides.insert(found.header.scene.overrides.end(), overrides.begin(),
                                      overrides.end());
  found.scenario = parse_scenario(found.header.scene);
  return found;
}

}  // namespace avo_io
