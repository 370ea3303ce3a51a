// SPDX-License-Identifier: Apache-2.0
// The robots of a MovingAI scenario, in the cells of its map.
#include <fmt/format.h>

#include "io/files/file_names.h"
#include "io/maps/free_space.h"
#include "io/maps/moving_ai.h"
#include "io/scene/placement.h"
#include "io/scene/random.h"
#include "io/scene/read_obstacles.h"
#include "io/scene/read_parts.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr double kUsualRadius = 0.45;              // cells
constexpr std::uint64_t kStreamOfScenarios = ~0U;  // groups use the other streams

/// Returns the only map, or the map with a file of the name that the scenario gives for its map.
const OccupancyGrid& map_of(const Reader& reader, const YamlNode& node, const std::string& path,
                            const std::vector<NamedMap>& maps, const std::string& name) {
  if (maps.size() == 1) return maps[0].grid;
  for (const NamedMap& map : maps)
    if (file_name_of(map.file) == file_name_of(name)) return map.grid;
  if (maps.empty()) reader.fail(node, path, "no map in obstacles", "must have the scenario's");
  std::vector<std::string_view> files;
  files.reserve(maps.size());
  for (const NamedMap& map : maps) files.push_back(map.file);
  reader.fail(node, path, "a scenario of " + in_quotes(name),
              "must be of a map in obstacles: " + joined(files));
}

void check_row(const SourceText& source, const ScenRow& row, const OccupancyGrid& grid) {
  if (row.width != grid.width || row.height != grid.height)
    source.fail(row.offset, fmt::format("found a map of {} x {} cells, must be {} x {}", row.width,
                                        row.height, grid.width, grid.height));
  if (!grid.is_free(row.start_x, row.start_y))
    source.fail(row.offset, fmt::format("found the start {} {}, a blocked cell, must be free",
                                        row.start_x, row.start_y));
}

/// Names both robots by their numbers.
void fail_overlap(const SourceText& source, const ScenRow& row, Vec2 start,
                  const avo::RobotSetup& robot, const std::vector<avo::RobotSetup>& before) {
  const double radius = room_of(robot);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double distance = norm(start - disc_center(before[i]));
    const double least = radius + disc_radius(before[i]);
    if (!(distance < least) || !keep_apart(before[i], robot)) continue;
    source.fail(row.offset, fmt::format("found the start of robots.{}, {:g} m from that of "
                                        "robots.{}, must be at least {:g} m",
                                        before.size(), distance, i, least));
  }
}

}  // namespace

void append_robots_from(const Reader& reader, const YamlNode& node, const std::string& path,
                        SceneFiles& files, const std::vector<NamedMap>& maps,
                        avo::Scenario& scenario) {
  RobotsFrom from = read_robots_from(reader, node, path);
  const SourceText source =
      read_named_file(reader, *node.find("scen"), path_to(path, "scen"), from.scen, files);
  const std::vector<ScenRow> rows = read_scen(source);
  const auto number = static_cast<std::size_t>(from.number);
  if (number > rows.size())
    reader.fail(*node.find("number"), path_to(path, "number"), fmt::format("{}", number),
                fmt::format("must be <= {}, the rows of {}", rows.size(), source.name()));
  const OccupancyGrid& grid =
      map_of(reader, *node.find("scen"), path_to(path, "scen"), maps, rows[0].map);
  if (node.find("radius") == nullptr) take_radius(node, kUsualRadius * grid.cell, from.robot);
  const double radius = room_of(from.robot);
  const Vec2 size{static_cast<double>(grid.width) * grid.cell,
                  static_cast<double>(grid.height) * grid.cell};
  FreeSpace space(grid.origin, grid.origin + size, radius, 0.0, scenario.robots.size() + number);
  for (const avo::RobotSetup& robot : scenario.robots) {
    if (keep_apart(robot, from.robot)) space.add({disc_center(robot), disc_radius(robot)});
  }
  Random random(scenario.seed, kStreamOfScenarios);
  for (std::size_t i = 0; i < number; ++i) {
    const ScenRow& row = rows[i];
    check_row(source, row, grid);
    const Vec2 start = grid.center(row.start_x, row.start_y);
    if (!space.is_clear(start)) fail_overlap(source, row, start, from.robot, scenario.robots);
    if (keep_apart(from.robot, from.robot)) space.add({start, radius});
    append_robot(from.robot, from.heading, start, grid.center(row.goal_x, row.goal_y), random,
                 scenario);
  }
}

}  // namespace avo_io
