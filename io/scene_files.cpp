// SPDX-License-Identifier: Apache-2.0
// The files that a scene names: each at most as large as a scene, and all together bounded.
#include "scene_files.h"

#include <filesystem>
#include <fmt/format.h>
#include <system_error>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "regular_file.h"

namespace avo_io {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

bool is_missing(const std::string& path) {
  std::error_code error;
  return std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found;
}

}  // namespace

SourceText read_named_file(const Reader& reader, const YamlNode& node, const std::string& path,
                           const std::string& file, SceneFiles& files) {
  const std::string name = (std::filesystem::path(files.folder) / file).string();
  const std::string_view builtin = builtin_file(file);
  if (!builtin.empty() && (files.builtin == BuiltinFiles::first ||
                           (files.builtin == BuiltinFiles::last && is_missing(name))))
    return {file, std::string(builtin)};
  std::string text;
  try {
    text = read_regular_file(name);
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("{}: {}{}", reader.document().where(node), in_front(path), error.what()));
  }
  files.read.push_back(name);
  files.bytes += text.size();
  if (files.bytes > kMostBytes)
    reader.fail(node, path, fmt::format("more than {} MiB in all files", kMostBytes >> 20U),
                "must be less");
  return {name, std::move(text)};
}

}  // namespace avo_io
