// SPDX-License-Identifier: Apache-2.0
// The facts that the module knows without a scene.
#include <string>

#include "avo/simd.h"
#include "avo/version.h"
#include "avo_io/scene.h"
#include "host.h"
#include "io/text/json.h"

namespace avo_lab {

using avo_io::Json;

/// Returns JSON: version, instruction set of the kernels, built-in scenes, keys of scenes that take
/// plain values, words of statuses.
AVO_EXPORT(std::size_t, library)() {
  Json scenes = Json::array(), settings = Json::array(), statuses = Json::array();
  for (const avo_io::BuiltinScene& scene : avo_io::builtin_scenes())
    scenes.push_back(
        {{"name", scene.name}, {"description", scene.description}, {"yaml", scene.yaml}});
  for (const avo_io::SceneSetting& setting : avo_io::scene_settings())
    settings.push_back({{"key", setting.key}, {"values", setting.values}});
  for (int k = 0; k <= static_cast<int>(avo::PlanStatus::detour); ++k)
    statuses.push_back(to_string(static_cast<avo::PlanStatus>(k)));
  const Json json{{"version", avo::kVersion},
                  {"simd_target", avo::simd_target()},
                  {"builtin_scenes", scenes},
                  {"settings", settings},
                  {"statuses", statuses}};
  return into_room(json.dump());
}

/// Returns the text of the scene with the name in the room, e.g. circle-100; nothing if there is
/// none.
AVO_EXPORT(std::size_t, builtin_text)() {
  const std::string name = Input(taken_from_room()).text();
  return into_room(avo_io::builtin_text(name).value_or(""));
}

}  // namespace avo_lab
