// SPDX-License-Identifier: Apache-2.0
// The tree of a scene file: how values are found, and how they appear in messages.
#include "io/text/yaml_tree.h"

#include <fmt/format.h>
#include <utility>

#include "avo_io/errors.h"

namespace avo_io {

const YamlNode* YamlNode::find(std::string_view key) const {
  if (kind != Kind::map) return nullptr;
  for (std::size_t i = 0; i < children.size(); i += 2)
    if (children[i].text == key) return &children[i + 1];
  return nullptr;
}

YamlNode* YamlNode::find(std::string_view key) {
  return const_cast<YamlNode*>(std::as_const(*this).find(key));
}

std::string Document::where(const YamlNode& node) const {
  const std::string& name = sources[static_cast<std::size_t>(node.source)];
  if (node.source > 0) return name;
  return fmt::format("{}:{}:{}", name, node.line, node.column);
}

void Document::fail(const YamlNode& node, const std::string& message) const {
  const std::string line = where(node) + ": " + message;
  if (node.source > 0) throw OverrideError(line);
  throw SceneError(line);
}

}  // namespace avo_io
