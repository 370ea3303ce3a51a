// SPDX-License-Identifier: Apache-2.0
// Maps and scenarios of the MovingAI benchmarks (Sturtevant 2012).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/maps/occupancy_grid.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Cells `.`, `G` and `S` (swamp) are free; cells `@`, `O`, `T` and `W` (water) are blocked. The
/// cell size and the origin keep their values. Throws SceneError.
OccupancyGrid read_moving_ai_map(const SourceText& source);

/// One row of a .scen file; cells are counted from the upper left.
struct ScenRow {
  std::size_t offset = 0;  ///< in the text
  std::string map;
  std::int64_t width = 0, height = 0;
  std::int64_t start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;
};
/// Reads a .scen file. Throws SceneError. Starts and goals are cells of a map of that size.
std::vector<ScenRow> read_scen(const SourceText& source);

}  // namespace avo_io
