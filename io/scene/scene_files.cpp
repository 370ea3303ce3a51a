// SPDX-License-Identifier: Apache-2.0
// The files that a scene names: each is at most as large as a scene, and their sum is bounded.
#include "io/scene/scene_files.h"

#include <algorithm>
#include <fmt/format.h>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "core/retell.h"
#include "io/files/file_names.h"
#include "io/files/regular_file.h"

namespace avo_io {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

/// Returns the built-in file at that path, or else the file read from there.
SceneFile file_at(const std::string& path, const std::string& file, const SceneFiles& files) {
  if (files.given != nullptr) {
    for (const SceneFile& given : *files.given)
      if (given.path == path) return given;
    throw FileError(path + ": found none of that name among the files that were given");
  }
  const std::string_view builtin = builtin_file(file);
  if (!builtin.empty() && (files.builtin == BuiltinFiles::first ||
                           (files.builtin == BuiltinFiles::last && is_missing(path))))
    return {path, std::string(builtin), true};
  return {path, read_regular_file(path)};
}

void remember(const SceneFile& file, std::vector<SceneFile>& read) {
  const auto same = [&file](const SceneFile& other) { return other.path == file.path; };
  if (std::none_of(read.begin(), read.end(), same)) read.push_back(file);
}

}  // namespace

void add_note(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

SourceText read_named_file(const Reader& reader, const YamlNode& node, const std::string& path,
                           const std::string& file, SceneFiles& files) {
  const std::string name = path_in(files.folder, file);
  SceneFile found = avo::retelling<FileError>(
      [&] { return file_at(name, file, files); },
      [&](const FileError& error) {
        throw FileError(
            fmt::format("{}: {}{}", reader.document().where(node), in_front(path), error.what()));
      });
  remember(found, files.read);
  if (found.builtin) return {file, std::move(found.text)};
  files.bytes += found.text.size();
  if (files.bytes > kMostBytes)
    reader.fail(node, path, fmt::format("more than {} MiB in all files", kMostBytes >> 20U),
                "must be less");
  return {name, std::move(found.text)};
}

}  // namespace avo_io
