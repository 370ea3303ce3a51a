// SPDX-License-Identifier: Apache-2.0
// Reads robots, moving obstacles and groups of a scene file, each from its map.
#pragma once
#include <string>

#include "io/fields/fields.h"
#include "io/scene/reader.h"
#include "io/scene/scene_files.h"
#include "io/text/yaml_tree.h"

namespace avo_io {

/// Reads a robot. patch: changes a robot that exists already.
void read_robot(const Reader& reader, const YamlNode& node, const std::string& path,
                avo::RobotSetup& robot, bool patch);
/// Sets values as if the robot's map gave that radius, m.
void take_radius(const YamlNode& node, double radius, avo::RobotSetup& robot);
void read_moving_obstacle(const Reader& reader, const YamlNode& node, const std::string& path,
                          SceneFiles& files, avo::MovingObstacle& obstacle);
Group read_group(const Reader& reader, const YamlNode& node, const std::string& path);
RobotsFrom read_robots_from(const Reader& reader, const YamlNode& node, const std::string& path);

/// Reads `sensing` and `sensing_error` of the scene.
void read_sensing(const Reader& reader, const YamlNode& scene, avo::SensingModel& sensing,
                  std::optional<avo::SensingError>& error);
/// Reads `execution` of the scene.
void read_execution(const Reader& reader, const YamlNode& scene,
                    std::optional<avo::ExecutionModel>& execution);

}  // namespace avo_io
