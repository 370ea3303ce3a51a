// SPDX-License-Identifier: Apache-2.0
#include "read_scene.h"

#include "avo_io/scene.h"

namespace avo::safety {

Scenario read_scene(const SceneText& text, std::uint64_t seed) {
  std::vector<std::string> settings = text.settings;
  settings.push_back("seed=" + std::to_string(seed));
  const bool is_builtin = avo_io::is_builtin_scene(text.scene);
  const std::string folder = AVO_SAFETY_SCENES;
  return avo_io::load_scenario(is_builtin ? text.scene : folder + "/" + text.scene, settings);
}

}  // namespace avo::safety
