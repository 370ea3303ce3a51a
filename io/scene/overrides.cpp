// SPDX-License-Identifier: Apache-2.0
// Overrides key=value besides the file: they change the tree before it is read.
#include "io/scene/overrides.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <system_error>

#include "avo_io/errors.h"
#include "avo_io/printable.h"
#include "io/scene/reader.h"

namespace avo_io {
namespace {

constexpr std::size_t kLongestShown = 60;  // characters of an override in messages

std::vector<std::string_view> parts_of(std::string_view key) {
  std::vector<std::string_view> parts;
  for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
    parts.push_back(key.substr(0, dot));
    key.remove_prefix(dot + 1);
  }
  parts.push_back(key);
  return parts;
}

std::optional<std::size_t> to_index(std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

/// Takes one step down the tree, to an item of a list or to the value of a key; it adds a missing
/// key.
YamlNode& step_down(const Document& document, YamlNode& node, const std::string& path,
                    std::string_view part, const YamlNode& value) {
  if (node.kind == YamlNode::Kind::list) {
    const std::optional<std::size_t> index = to_index(part);
    const std::size_t count = node.children.size();
    if (!index || *index >= count)
      document.fail(value, fmt::format("{}found the number {}, {}", in_front(path), in_quotes(part),
                                       count == 0 ? std::string("the list is empty")
                                                  : fmt::format("must be 0 to {}", count - 1)));
    return node.children[*index];
  }
  if (node.kind == YamlNode::Kind::nothing) {  // also for a key that was just added
    node = value;
    node.kind = YamlNode::Kind::map;
    node.text.clear();
    node.children.clear();
  }
  if (node.kind != YamlNode::Kind::map)
    document.fail(value, fmt::format("{}found {}, has no key {}", in_front(path), shown(node),
                                     in_quotes(part)));
  if (YamlNode* existing = node.find(part)) return *existing;
  YamlNode key = value;
  key.kind = YamlNode::Kind::text;
  key.text = part;
  key.children.clear();
  node.children.push_back(std::move(key));
  node.children.push_back(YamlNode{});
  node.children.back().source = value.source;
  return node.children.back();
}

void put(const Document& document, YamlNode& root, const std::vector<std::string_view>& parts,
         const YamlNode& value) {
  YamlNode* node = &root;
  std::string path;
  for (const std::string_view part : parts) {
    node = &step_down(document, *node, path, part, value);
    path = path_to(path, part);
  }
  *node = value;
}

/// Returns whether the scene has robots that are not in its list.
bool makes_robots(const YamlNode& root) {
  return root.find("groups") != nullptr || root.find("robots_from") != nullptr;
}

}  // namespace

std::vector<RobotPatch> apply_overrides(const std::vector<std::string>& overrides,
                                        Document& document) {
  std::vector<RobotPatch> patches;
  for (const std::string& text : overrides) {
    const std::string name = "--set " + printable(text, kLongestShown);
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw OverrideError(
          fmt::format("{}: found no key=value, must be such as time_step=0.1", name));
    const YamlNode value = parse_yaml(std::string_view(text).substr(equals + 1), name, document);
    const std::vector<std::string_view> parts = parts_of(std::string_view(text).substr(0, equals));
    const YamlNode* listed = std::as_const(document.root).find("robots");
    const std::size_t count = listed != nullptr ? listed->size() : 0;
    const std::optional<std::size_t> robot =
        parts.size() > 2 && parts[0] == "robots" ? to_index(parts[1]) : std::nullopt;
    if (robot && *robot >= count && makes_robots(document.root)) {
      RobotPatch patch{*robot, {}};
      put(document, patch.map, {parts.begin() + 2, parts.end()}, value);
      patches.push_back(std::move(patch));
    } else {
      put(document, document.root, parts, value);
    }
  }
  return patches;
}

}  // namespace avo_io
