// SPDX-License-Identifier: Apache-2.0
// The place in a scene file that a late error is about.
#pragma once
#include <string_view>
#include <vector>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// Returns the value with that path, such as "robots.3.radius", or the value that contains it.
/// origins: of each robot, its own map, its group's, or its patch's.
const YamlNode& origin_of(const Document& document, const std::vector<const YamlNode*>& origins,
                          std::string_view path);

/// Refuses a scene with the message of an error, which may begin with a path and a colon.
[[noreturn]] void fail_at_origin(const Document& document,
                                 const std::vector<const YamlNode*>& origins,
                                 std::string_view message);

}  // namespace avo_io
