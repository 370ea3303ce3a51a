// SPDX-License-Identifier: Apache-2.0
// The scenes that are part of the library, and circle-N and uniform-N for every N.
#include "io/scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "core/ranges.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

/// Replaces text of a family's model by text for a member, at every place where it occurs.
struct Replacement {
  std::string from, to;
};

/// One scene for every number N of robots, e.g. circle-N.
struct Family {
  std::string_view stem;   ///< "circle-"
  std::string_view model;  ///< the embedded file of one member
  double model_number;     ///< N of that member
  /// The texts that change with N besides the name and the number.
  std::vector<Replacement> (*replacements)(double model_number, double n);
};

std::string_view find_scene(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.is_scene && file.name == name) return file.text;
  return {};
}

std::vector<Replacement> none(double, double) {
  return {};
}

/// Returns half a side of the square with ten robots in every circle of 15 m, π 15² / 10 m² per
/// robot.
double half_square(double n) {
  return 0.5 * std::sqrt(22.5 * 3.141592653589793 * n);
}

std::vector<Replacement> squares(double model_number, double n) {
  return {{fmt::format("{}", half_square(model_number)), fmt::format("{}", half_square(n))}};
}

constexpr Family kFamilies[] = {{"circle-", "circle-100", 100, none},
                                {"uniform-", "uniform-1000", 1000, squares}};

void replace_all(std::string& text, const Replacement& replacement) {
  const auto& [from, to] = replacement;
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

constexpr std::string_view kDigits = "0123456789";

bool is_whole(std::string_view number) {
  return !number.empty() && number.find_first_not_of(kDigits) == number.npos &&
         (number[0] != '0' || number == "0");
}

bool is_allowed(double n) {
  return n >= 2 && n <= static_cast<double>(avo::kMostRobots);
}

std::optional<std::string> find_member(const Family& family, const std::string& name) {
  const std::string number = name.substr(family.stem.size());
  if (!is_whole(number)) return std::nullopt;
  const double n = *to_double(number.substr(0, 20));
  if (!is_allowed(n))
    throw OverrideError(fmt::format("{}: found N = {}, must be 2 to {}", name, number.substr(0, 20),
                                    avo::kMostRobots));
  std::string text(find_scene(family.model));
  std::vector<Replacement> replacements = family.replacements(family.model_number, n);
  replacements.push_back({std::string(family.model), name});
  replacements.push_back(
      {fmt::format("number: {}\n", family.model_number), fmt::format("number: {}\n", number)});
  for (const Replacement& replacement : replacements) replace_all(text, replacement);
  return text;
}

std::string listed_name(std::string_view file) {
  for (const Family& family : kFamilies)
    if (family.model == file) return std::string(family.stem) + "N";
  return std::string(file);
}

/// Returns the first line, a comment that says what the scene is.
std::string first_comment(std::string_view yaml) {
  std::string_view line = yaml.substr(0, yaml.find('\n'));
  line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
  return std::string(line);
}

/// Appends the members of families with the number in which the name ends; none if the name has
/// other digits.
void append_members(std::string_view name, std::vector<std::string>& names) {
  const std::string_view number = name.substr(std::min(name.find_first_of(kDigits), name.size()));
  if (!is_whole(number) || !is_allowed(*to_double(number.substr(0, 20)))) return;
  for (const Family& family : kFamilies) names.push_back(std::string(family.stem).append(number));
}

}  // namespace

std::optional<std::string> nearest_scene(const std::string& name) {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  append_members(name, names);
  const auto meant = nearest(name, {names.begin(), names.end()});
  return meant ? std::optional<std::string>(*meant) : std::nullopt;
}

std::optional<std::string> builtin_text(const std::string& name) {
  for (const Family& family : kFamilies) {
    if (!name.starts_with(family.stem)) continue;
    if (auto member = find_member(family, name)) return member;
  }
  const std::string_view yaml = find_scene(name);
  if (yaml.empty()) return std::nullopt;
  return std::string(yaml);
}

bool is_builtin_scene(const std::string& name) {
  return builtin_text(name).has_value();
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
