// SPDX-License-Identifier: Apache-2.0
// Maps of ROS: map.yaml and its image.
#pragma once
#include <string>

#include "io/maps/occupancy_grid.h"
#include "io/scene/scene_files.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Blocked cells are the occupied cells and the unknown cells: all cells that are not free.
/// `folder`: the folder of map.yaml, relative to the scene. Throws SceneError, FileError.
OccupancyGrid read_ros_map(const SourceText& source, const std::string& folder, SceneFiles& files);

}  // namespace avo_io
