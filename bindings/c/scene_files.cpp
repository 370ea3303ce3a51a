// SPDX-License-Identifier: Apache-2.0
// Scenes with avo_io.
#include "scene_files.h"

#include <utility>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "errors.h"

namespace avo_c {
namespace {

template <typename Read>
auto read_scene(const Read& read) {
  try {
    return read();
  } catch (const avo_io::FileError& error) {
    fail(AVO_ERROR_FILE, error.what());
  } catch (const avo::Error& error) {
    fail(AVO_ERROR_INVALID_SCENE, error.what());
  }
}

}  // namespace

avo::Scenario load_scene(const std::string& name_or_path,
                         const std::vector<std::string>& overrides) {
  if (name_or_path == "-")
    fail(AVO_ERROR_INVALID_SCENE, "name_or_path: found \"-\", must be a name or a file");
  return read_scene([&] { return avo_io::load_scenario(name_or_path, overrides); });
}

avo::Scenario parse_scene(std::string_view yaml, const std::string& file,
                          const std::vector<std::string>& overrides) {
  return read_scene([&] { return avo_io::parse_scenario(yaml, file, overrides); });
}

avo::space::Scenario load_space_scene(const std::string& path,
                                      const std::vector<std::string>& overrides) {
  if (path == "-") fail(AVO_ERROR_INVALID_SCENE, "path: found \"-\", must be a file");
  auto scenario = read_scene([&] { return avo_io::load_space_scenario(path, overrides); });
  if (!scenario)
    fail(AVO_ERROR_INVALID_SCENE, path + ": found no scene with space: 3, must be one");
  return std::move(*scenario);
}

}  // namespace avo_c
