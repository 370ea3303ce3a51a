// SPDX-License-Identifier: Apache-2.0
// Overrides key=value besides the file: they change the tree before it is read.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// Changes of robots that groups create, because these robots are not in the tree. They go by
/// number of the robot, in the order given.
struct RobotPatch {
  std::size_t robot;
  YamlNode map;  ///< keys of a robot
};

/// Puts each "key=value" into the tree. If "robots.I.key" names a robot beyond the list in the
/// file, it becomes a patch instead. Throws OverrideError.
std::vector<RobotPatch> apply_overrides(const std::vector<std::string>& overrides,
                                        Document& document);

}  // namespace avo_io
