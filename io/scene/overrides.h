// SPDX-License-Identifier: Apache-2.0
// key=value besides the file: changes the tree before it is read.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// Changes of robots that groups make: they are not in the tree. By number of the robot, in the
/// order given.
struct RobotPatch {
  std::size_t robot;
  YamlNode map;  ///< keys of a robot
};

/// Puts each "key=value" into the tree. "robots.I.key" beyond the robots that the file lists goes
/// to the patches instead. Throws OverrideError.
std::vector<RobotPatch> apply_overrides(const std::vector<std::string>& overrides,
                                        Document& document);

}  // namespace avo_io
