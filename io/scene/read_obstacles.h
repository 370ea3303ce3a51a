// SPDX-License-Identifier: Apache-2.0
// Reads entries of `obstacles`, and the robots of a map's scenario.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "io/fields/fields.h"
#include "io/maps/occupancy_grid.h"
#include "io/scene/reader.h"
#include "io/scene/scene_files.h"
#include "io/text/yaml_tree.h"

namespace avo_io {

/// Limit for a scene and for each of its obstacles.
inline constexpr std::size_t kMostWalls = 2'000'000;

/// A MovingAI map of the scene.
struct NamedMap {
  std::string file;
  OccupancyGrid grid;
};

/// The keys of which an obstacle has one, and all keys that an obstacle may have.
std::vector<std::string_view> obstacle_kinds();
std::vector<std::string_view> obstacle_keys();

/// Reads an obstacle, and appends maps that scenarios may refer to to `maps`.
avo::StaticObstacle read_static_obstacle(const Reader& reader, const YamlNode& node,
                                         const std::string& path, SceneFiles& files,
                                         std::vector<NamedMap>& maps);

/// Appends robots to the scene, at the starts of the first rows of a .scen file.
void append_robots_from(const Reader& reader, const YamlNode& node, const std::string& path,
                        SceneFiles& files, const std::vector<NamedMap>& maps,
                        avo::Scenario& scenario);

}  // namespace avo_io
