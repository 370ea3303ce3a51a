// SPDX-License-Identifier: Apache-2.0
#include "io/scene/origins.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace avo_io {

const YamlNode& origin_of(const Document& document, const std::vector<const YamlNode*>& origins,
                          std::string_view path) {
  const YamlNode* node = &document.root;
  while (!path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string part(path.substr(0, dot));
    path.remove_prefix(std::min(dot + 1, path.size()));
    const YamlNode* next = node->find(part);
    if (node->kind == YamlNode::Kind::list) {
      const std::size_t index = std::stoul(part);
      const bool robot = node == document.root.find("robots");
      if (robot)
        next = origins[index];
      else if (index < node->children.size())
        next = &node->children[index];
    } else if (next == nullptr && part == "robots" && !path.empty()) {
      return *origins[std::stoul(std::string(path))];  // in a group
    }
    if (next == nullptr) break;
    node = next;
  }
  return *node;
}

void fail_at_origin(const Document& document, const std::vector<const YamlNode*>& origins,
                    std::string_view message) {
  document.fail(origin_of(document, origins, message.substr(0, message.find(':'))),
                std::string(message));
}

}  // namespace avo_io
