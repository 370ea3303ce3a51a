// SPDX-License-Identifier: Apache-2.0
// The files that a command line names, checked before any of them is opened for writing.
#include "arguments/files.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <system_error>
#include <unistd.h>

#include "avo_io/errors.h"
#include "avo_io/file_identity.h"
#include "avo_io/scene.h"
#include "exit_codes.h"
#include "figures/canvas.h"

namespace avo_cli {
namespace {

namespace fs = std::filesystem;

/// The identity of a file; a stream is always a stream, whatever file it leads to.
struct Place {
  NamedFile file;
  bool stream = false;
  std::optional<avo_io::FileIdentity> identity;
};

Place place_of(const NamedFile& file, int stream) {
  if (file.path == "-") return {file, true, avo_io::identity_of(stream)};
  return {file, false, avo_io::identity_of(file.path)};
}

std::string name_of(const NamedFile& file) {
  const bool unnamed = file.path == "-" && !file.role.starts_with("--");
  return unnamed ? file.role : fmt::format("{} {}", file.role, file.path);
}

void require_different(const Place& a, const Place& b) {
  const bool one_file = a.identity && a.identity == b.identity;
  if (one_file || (a.stream && b.stream))
    throw UsageError(fmt::format("{} and {}: found to be one file, must differ", name_of(a.file),
                                 name_of(b.file)));
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

}  // namespace

void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  std::vector<Place> written;
  for (const NamedFile& file : outputs)
    if (!file.path.empty()) written.push_back(place_of(file, STDOUT_FILENO));
  const auto is_stream = [](const Place& place) { return place.stream; };
  // output for people to read goes there
  if (std::none_of(written.begin(), written.end(), is_stream))
    written.push_back(place_of({"the standard output", "-"}, STDOUT_FILENO));
  for (std::size_t i = 0; i < written.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) require_different(written[j], written[i]);
    for (const NamedFile& file : inputs) {
      Place read = place_of(file, STDIN_FILENO);
      read.stream = false;
      if (!file.path.empty() && read.identity && read.identity->name.empty())
        require_different(read, written[i]);
    }
  }
}

std::string name_of(const SceneArguments& arguments) {
  return arguments.scene == "-" ? "standard input" : arguments.scene;
}

NamedFile file_of(const SceneArguments& arguments) {
  const bool file = !arguments.scene.empty() && !avo_io::is_builtin_scene(arguments.scene);
  return {"the scene", file ? arguments.scene : ""};
}

void require_ending(const NamedFile& file, const std::vector<std::string_view>& endings) {
  const std::string extension = fs::path(file.path).extension().string();
  std::error_code error;
  const fs::file_status status = fs::status(file.path, error);
  const bool other = fs::exists(status) && !fs::is_regular_file(status);
  const bool known = std::find(endings.begin(), endings.end(), lower(extension)) != endings.end();
  if (extension.empty() || known || other) return;
  throw UsageError(fmt::format("{} {}: found the ending {}, must be {} or none", file.role,
                               file.path, extension, fmt::join(endings, ", ")));
}

void require_figure(const NamedFile& file) {
  if (file.path.empty()) return;
  try {
    avo::figures::check_figure_path(file.path);
  } catch (const avo::Error& error) {
    throw UsageError(fmt::format("{} {}", file.role, error.what()));
  }
}

std::string drawn(const std::function<std::string()>& draw) {
  try {
    return draw();
  } catch (const UsageError&) {
    throw;
  } catch (const avo::Error& error) {
    throw avo_io::FileError(error.what());
  }
}

}  // namespace avo_cli
