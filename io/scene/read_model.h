// SPDX-License-Identifier: Apache-2.0
// Reads a robot's motion model from the keys of its map.
#pragma once
#include <string>
#include <vector>

#include "io/fields/fields.h"
#include "io/scene/reader.h"

namespace avo_io {

/// Reads `model`, `heading` and the keys of the robot's model. `heading`: for groups, if their
/// heading may be a word.
void read_model(const Reader& reader, const YamlNode& node, const std::string& path,
                avo::RobotSetup& robot, GroupHeading* heading);

}  // namespace avo_io
