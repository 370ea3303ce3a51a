// SPDX-License-Identifier: Apache-2.0
// Reads moving obstacles of space from the tree of a scene file.
#pragma once
#include <string>

#include "avo/space/mover.h"
#include "io/scene/reader.h"

namespace avo_io {

avo::space::MovingObstacle read_moving_obstacle_in_space(const Reader& reader, const YamlNode& node,
                                                         const std::string& path);

}  // namespace avo_io
