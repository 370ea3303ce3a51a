// SPDX-License-Identifier: Apache-2.0
#include "io/scene/removed.h"

#include <fmt/format.h>

#include "core/removed.h"
#include "io/scene/overrides.h"
#include "io/scene/reader.h"

namespace avo_io {
namespace {

using avo::Removed;

/// Calls visit(removed, key, value) for each removed key of the tree, and each with a removed
/// value.
template <class Visit>
void for_each_removed(const YamlNode& root, const Visit& visit) {
  if (root.kind != YamlNode::Kind::map) return;
  for (std::size_t k = 0; k + 1 < root.children.size(); k += 2) {
    const YamlNode &key = root.children[k], &value = root.children[k + 1];
    for (const Removed& one : avo::kRemoved) {
      const bool is_text = value.kind == YamlNode::Kind::text;
      if (key.text == one.key && (one.value.empty() || (is_text && value.text == one.value)))
        visit(one, key, value);
    }
  }
}

}  // namespace

void refuse_removed(const Reader& reader, const YamlNode& root) {
  for_each_removed(root, [&](const Removed& one, const YamlNode& key, const YamlNode& value) {
    if (one.value.empty())
      reader.fail(key, "", "the removed key " + in_quotes(key.text),
                  "must be " + allowed_instead(one));
    reader.fail(value, key.text, shown(value), "must be " + allowed_instead(one));
  });
}

void refuse_removed(const std::vector<std::string>& overrides) {
  Document document;
  document.sources.emplace_back();  // in place of the scene's file
  apply_overrides(overrides, document);
  refuse_removed(Reader(document), document.root);
}

void replace_removed(YamlNode& root) {
  if (root.kind != YamlNode::Kind::map) return;
  for (std::size_t k = 0; k + 1 < root.children.size();) {
    const auto at = root.children.begin() + static_cast<std::ptrdiff_t>(k);
    if (avo::removed_key(at->text) != nullptr) {
      root.children.erase(at, at + 2);
      continue;
    }
    for (const Removed& one : avo::kRemoved)
      if (at->text == one.key && at[1].kind == YamlNode::Kind::text && at[1].text == one.value)
        at[1].text = one.instead;
    k += 2;
  }
}

std::optional<std::string> lost_setting(const SceneSource& source) {
  Document document;
  document.root = parse_yaml(source.yaml, source.name, document);
  apply_overrides(source.overrides, document);
  std::optional<std::string> lost;
  for_each_removed(document.root,
                   [&](const Removed& one, const YamlNode& key, const YamlNode& value) {
                     const bool is_text = value.kind == YamlNode::Kind::text;
                     if (!one.value.empty() || !is_text || value.text != one.usual)
                       lost = fmt::format("{}: {}", key.text, shown(value));
                   });
  return lost;
}

}  // namespace avo_io
