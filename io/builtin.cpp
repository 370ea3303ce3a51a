// SPDX-License-Identifier: Apache-2.0
// The scenes that are part of the library, and circle-N, one of them for every N.
#include "builtin.h"

#include <algorithm>
#include <fmt/format.h>

#include "avo_io/scene.h"
#include "core/ranges.h"
#include "words.h"

namespace avo_io {
namespace {

constexpr std::string_view kCircle = "circle-";
constexpr std::string_view kCircleTemplate = "circle-100";

std::string_view embedded(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.name == name) return file.yaml;
  return {};
}

std::optional<BuiltinText> find_circle(const std::string& name) {
  const std::string number = name.substr(kCircle.size());
  const bool whole = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
  if (!whole || (number[0] == '0' && number != "0")) return std::nullopt;
  const double n = *to_double(number.substr(0, 20));
  if (n < 2 || n > static_cast<double>(avo::kMostRobots))
    throw OverrideError(fmt::format("{}: found N = {}, must be 2 to {}", name, number.substr(0, 20),
                                    avo::kMostRobots));
  return BuiltinText{embedded(kCircleTemplate), {"name=" + name, "groups.0.number=" + number}};
}

/// The first line, a comment, says what the scene is.
std::string first_comment(std::string_view yaml) {
  std::string_view line = yaml.substr(0, yaml.find('\n'));
  line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
  return std::string(line);
}

}  // namespace

std::optional<BuiltinText> find_builtin(const std::string& name) {
  if (name.starts_with(kCircle)) {
    if (auto circle = find_circle(name)) return circle;
  }
  const std::string_view yaml = embedded(name);
  if (yaml.empty()) return std::nullopt;
  return BuiltinText{yaml, {}};
}

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes = [] {
    std::vector<BuiltinScene> result;
    for (const EmbeddedFile& file : embedded_files())
      result.push_back({file.name == kCircleTemplate ? "circle-N" : std::string(file.name),
                        first_comment(file.yaml), std::string(file.yaml)});
    return result;
  }();
  return scenes;
}

}  // namespace avo_io
