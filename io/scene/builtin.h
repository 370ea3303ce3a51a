// SPDX-License-Identifier: Apache-2.0
// The scenes that are part of the library, with their maps: the build embeds scenarios/.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace avo_io {

struct EmbeddedFile {
  std::string_view name;  ///< without .yaml, for a scene
  std::string_view text;
  bool is_scene = true;
};
/// Returns the files by name, ascending; CMake generates this function.
std::span<const EmbeddedFile> embedded_files();

}  // namespace avo_io
