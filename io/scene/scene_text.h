// SPDX-License-Identifier: Apache-2.0
// Makes a scenario of a scene's text.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/scenario.h"
#include "io/scene/scene_files.h"

namespace avo_io {

/// Returns the scenario. `file` stands in front of messages, and gives the scene its name.
/// `robots`: the required number of robots. Throws as parse_scenario() does, and RecordingError if
/// the number is different.
avo::Scenario scenario_of(std::string_view yaml, const std::string& file,
                          const std::vector<std::string>& overrides, SceneFiles& files,
                          std::optional<std::int64_t> robots = {});

}  // namespace avo_io
