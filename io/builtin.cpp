// SPDX-License-Identifier: Apache-2.0
// The scenes that are part of the library, and circle-N and uniform-N for every N.
#include "builtin.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "avo_io/scene.h"
#include "core/ranges.h"
#include "words.h"

namespace avo_io {
namespace {

/// One scene for every number N of robots, e.g. circle-N.
struct Family {
  std::string_view stem;   ///< "circle-"
  std::string_view model;  ///< the embedded file that it is, for one N
  /// What changes with N besides the name and the number.
  std::vector<std::string> (*overrides)(double n);
};

std::string_view find_scene(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.is_scene && file.name == name) return file.text;
  return {};
}

std::vector<std::string> no_overrides(double) {
  return {};
}

/// The square with ten robots in every circle of 15 m, π 15² / 10 m² a robot.
std::vector<std::string> square_of(double n) {
  const double half = 0.5 * std::sqrt(22.5 * 3.141592653589793 * n);
  std::vector<std::string> overrides;
  for (const char* what : {"placement", "goals"}) {
    overrides.push_back(fmt::format("groups.0.{0}.random.min=[-{1}, -{1}]", what, half));
    overrides.push_back(fmt::format("groups.0.{0}.random.max=[{1}, {1}]", what, half));
  }
  return overrides;
}

constexpr Family kFamilies[] = {{"circle-", "circle-100", no_overrides},
                                {"uniform-", "uniform-1000", square_of}};

std::optional<BuiltinText> find_member(const Family& family, const std::string& name) {
  const std::string number = name.substr(family.stem.size());
  const bool whole = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
  if (!whole || (number[0] == '0' && number != "0")) return std::nullopt;
  const double n = *to_double(number.substr(0, 20));
  if (n < 2 || n > static_cast<double>(avo::kMostRobots))
    throw OverrideError(fmt::format("{}: found N = {}, must be 2 to {}", name, number.substr(0, 20),
                                    avo::kMostRobots));
  std::vector<std::string> overrides = family.overrides(n);
  overrides.push_back("name=" + name);
  overrides.push_back("groups.0.number=" + number);
  return BuiltinText{find_scene(family.model), std::move(overrides)};
}

std::string listed_name(std::string_view file) {
  for (const Family& family : kFamilies)
    if (family.model == file) return std::string(family.stem) + "N";
  return std::string(file);
}

/// The first line, a comment, says what the scene is.
std::string first_comment(std::string_view yaml) {
  std::string_view line = yaml.substr(0, yaml.find('\n'));
  line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
  return std::string(line);
}

}  // namespace

std::optional<BuiltinText> find_builtin(const std::string& name) {
  for (const Family& family : kFamilies) {
    if (!name.starts_with(family.stem)) continue;
    if (auto member = find_member(family, name)) return member;
  }
  const std::string_view yaml = find_scene(name);
  if (yaml.empty()) return std::nullopt;
  return BuiltinText{yaml, {}};
}

bool is_builtin_scene(const std::string& name) {
  return find_builtin(name).has_value();
}

std::string_view builtin_file(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (!file.is_scene && file.name == name) return file.text;
  return {};
}

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes = [] {
    std::vector<BuiltinScene> result;
    for (const EmbeddedFile& file : embedded_files())
      if (file.is_scene)
        result.push_back(
            {listed_name(file.name), first_comment(file.text), std::string(file.text)});
    return result;
  }();
  return scenes;
}

}  // namespace avo_io
