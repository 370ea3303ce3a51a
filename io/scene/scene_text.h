// SPDX-License-Identifier: Apache-2.0
// A scene's text becomes a scenario.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/scenario.h"
#include "io/scene/scene_files.h"

namespace avo_io {

/// `file` stands in front of messages, and the scene is called like it. `robots`: how many there
/// must be. Throws as parse_scenario() does, and RecordingError where there are others.
avo::Scenario scenario_of(std::string_view yaml, const std::string& file,
                          const std::vector<std::string>& overrides, SceneFiles& files,
                          std::optional<std::int64_t> robots = {});

}  // namespace avo_io
