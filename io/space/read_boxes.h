// SPDX-License-Identifier: Apache-2.0
// Reads static obstacles of space from the tree of a scene file.
#pragma once
#include <string>
#include <vector>

#include "avo/space/box.h"
#include "io/scene/read_obstacles.h"
#include "io/scene/reader.h"

namespace avo_io {

/// Refuses corners of which one coordinate of `min` exceeds that of `max`.
void require_ascending(const Reader& reader, const YamlNode& node, const std::string& path,
                       const avo::Vec3& min, const avo::Vec3& max);

/// Appends the boxes of an obstacle: a floor, a ceiling, a box, or an obstacle of the plane between
/// two heights.
void read_boxes(const Reader& reader, const YamlNode& node, const std::string& path,
                SceneFiles& files, std::vector<NamedMap>& maps,
                std::vector<avo::space::Box>& boxes);

}  // namespace avo_io
