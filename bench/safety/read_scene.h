// SPDX-License-Identifier: Apache-2.0
// Scenes that YAML says: built-in ones, and those in the folder scenes. `avo run` and `avo sweep`
// take the same names and settings.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scenes.h"

namespace avo::safety {

/// A scene by its name, and what it sets otherwise, such as "groups.0.jitter=0.2".
struct SceneText {
  std::string scene;
  std::vector<std::string> settings = {};
};

/// Returns the scenario with that seed.
Scenario read_scene(const SceneText& text, std::uint64_t seed);

}  // namespace avo::safety
