// SPDX-License-Identifier: Apache-2.0
// Reads robots of space from the tree of a scene file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "avo/space/scenario.h"
#include "io/scene/reader.h"

namespace avo_io {

/// Reads a robot. patch: missing values stay unchanged.
void read_robot(const Reader& reader, const YamlNode& node, const std::string& path,
                avo::space::RobotSetup& robot, bool patch);

/// Reads what a group says of each of its robots. keys: the other ones that a group may have.
void read_robot_of_group(const Reader& reader, const YamlNode& node, const std::string& path,
                         std::vector<std::string_view> keys, avo::space::RobotSetup& robot);

}  // namespace avo_io
